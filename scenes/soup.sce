sce1.0
# A soup of triangles: 12,000 of them, none connected, turned every way, evenly in a cube.
# Nothing in it follows a surface, so boxes overlap however they are made; what is near in space is near in nothing
# else. `generate:soup:TRIANGLES:SEED` shrinks them as they become more, so that any number fills the cube alike. All
# are of one white: the colours are those of four lights.

eyepos 2.6 -5.2 2.5
eyedir -2.6 5.2 -2.62
eyeup 0 0 1
wdist 1
fovy_deg 28
nx 480
ny 320
max_recursion 0
aasample 4
background 0.05 0.06 0.09

pointlight -5 -4 2     1.10 0.42 0.22
pointlight 5 -3 -1.5   0.16 0.52 0.95
pointlight 1 -4 6      0.72 0.62 0.42
pointlight 0 0 0       0.90 0.72 0.40

ca 0.05 0.05 0.08
cr 0.92 0.92 0.92
object_flat generate:soup:12000:1
end

sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 60
ny 40
pointlight 2 -3 5  1 1 1
ball r 0 0 0
ball 0,5 0 0 0
translate 1, 2, 3
translate 0x1 1e --3
cr 2 -1 x
end

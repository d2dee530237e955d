sce1.0
# Shapes of all kinds: 3,000 balls, ellipsoids, cylinders and triangles, a quarter of each, turned every way.
# `scatter mixed:COUNT:SEED` makes them by rule. A structure sees only their boxes, of which those of thin things that
# stand askew are nearly empty; and here each object is a primitive of its own, so there are no packs of eight.

eyepos 2.2 -4.9 2.7
eyedir -2.2 4.9 -2.86
eyeup 0 0 1
wdist 1
fovy_deg 28
nx 480
ny 320
max_recursion 1
aasample 4
background 0.90 0.92 0.94

{
    translate -3 -4 5
    rotate 45 1 -1 0
    arealight 0.9   0.66 0.63 0.57
}
pointlight 5 -4 3   0.22 0.23 0.27

{
    ca 0.30 0.30 0.32
    cr 0.70 0.72 0.74
    translate 0 0 -1.02
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
{
    ca 0.26 0.26 0.28
    cr 0.96 0.96 0.96
    cp 0.10 0.10 0.10
    shininess 60
    scatter mixed:3000:2
}
end

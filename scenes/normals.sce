sce1.0
# Flat and interpolated normals.
# The first two are the same mesh of 320 triangles: `object_flat` shades it with one normal a face,
# `object_phong` with normals interpolated from corner to corner. The third is a true ball. The
# middle one is as smooth as the ball, highlight and all, but its outline and its shadow tell what
# it is made of.

eyepos 0 -9 3.0
eyedir 0 9 -1.9
eyeup 0 0 1
wdist 1
fovy_deg 32
nx 480
ny 320
max_recursion 0
aasample 4
background 0.78 0.75 0.72

pointlight -45 -62 70   0.76 0.72 0.66
pointlight 60 -60 50   0.20 0.21 0.24

{
    ca 0.28 0.28 0.28
    cr 0.80 0.75 0.70
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.2 0.2 0.22
cr 0.30 0.46 0.58
cp 0.35 0.35 0.35
shininess 40
{
    translate -2.35 0 1
    object_flat generate:icosphere:320
}
{
    translate 0 0 1
    object_phong generate:icosphere:320
}
ball 1 2.35 0 1
end

sce1.0
# Reflections: the two trefoils.
# The knot on the right is the knot on the left under `scale -1 1 1`. No turning takes one to the
# other: left-handed and right-handed. A negative factor turns triangles inside out, but which side
# is lit is decided by where it is seen from, so both look equally solid.

eyepos 0 -7.6 2.6
eyedir 0 7.6 -1.4
eyeup 0 0 1
wdist 1
fovy_deg 30
nx 480
ny 320
max_recursion 1
aasample 4
background 0.74 0.71 0.69

{
    translate 0 -50 70
    rotate 32 1 0 0
    arealight 8   0.70 0.68 0.64
}
pointlight -40 -90 60   0.22 0.23 0.26

{
    ca 0.28 0.28 0.28
    cr 0.68 0.64 0.60
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.22 0.22 0.24
cp 0.12 0.12 0.12
shininess 60
{
    cr 0.20 0.40 0.50
    translate -1.3 0 1.2
    rotate 8 0 0 1
    rotate 90 1 0 0
    scale 1.2 1.2 1.2
    object_phong generate:torus-knot:9000
}
{
    scale -1 1 1                # all that follows, seen in a mirror
    cr 0.74 0.36 0.22
    translate -1.3 0 1.2
    rotate 8 0 0 1
    rotate 90 1 0 0
    scale 1.2 1.2 1.2
    object_phong generate:torus-knot:9000
}
end

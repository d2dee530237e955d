sce1.0
# A mesh from a file: dice.
# `meshes/die.obj`, named relative to this file, is a cube with its edges cut off: squares, quads and
# triangles, some of them with normals and some without. The pips are flattened balls; each die is
# one transform of all that stands within its braces.

eyepos 0.6 -9.5 5.2
eyedir -0.5 9.5 -4.5
eyeup 0 0 1
wdist 1
fovy_deg 31
nx 480
ny 320
max_recursion 1
aasample 4
background 0.5 0.5 0.5

{
    translate -40 -30 60
    rotate 45 1 -1 0
    arealight 6   0.80 0.76 0.70
}
pointlight 20 -90 50   0.26 0.27 0.31

# The cloth.
{
    ca 0.26 0.26 0.26
    cr 0.16 0.40 0.36
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
ca 0.24 0.24 0.25
cp 0.07 0.07 0.07
shininess 60
{
    translate -1.9 0.3 1
    rotate 24 0 0 1
    cr 0.88 0.84 0.76
    object_flat meshes/die.obj
    cr 0.16 0.16 0.18
    {
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 0 0 0
    }
    {
        rotate 90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate 90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0 0 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate -90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
    }
    {
        rotate -90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 0 0 0
    }
    {
        rotate 180 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 -0.48 0 0
        ball 0.17 0.48 0 0
    }
}
{
    translate 2.1 1.9 1
    rotate -20 0 0 1
    rotate 90 0 1 0
    cr 0.74 0.20 0.16
    object_flat meshes/die.obj
    cr 0.90 0.88 0.84
    {
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 0 0 0
    }
    {
        rotate 90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate 90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0 0 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate -90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
    }
    {
        rotate -90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 0 0 0
    }
    {
        rotate 180 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 -0.48 0 0
        ball 0.17 0.48 0 0
    }
}
{
    translate 0.7 -1.9 1
    rotate 52 0 0 1
    rotate -90 1 0 0
    cr 0.88 0.84 0.76
    object_flat meshes/die.obj
    cr 0.16 0.16 0.18
    {
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 0 0 0
    }
    {
        rotate 90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate 90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0 0 0
        ball 0.17 0.48 0.48 0
    }
    {
        rotate -90 0 1 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
    }
    {
        rotate -90 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 0 0 0
    }
    {
        rotate 180 1 0 0
        translate 0 0 1
        scale 1 1 0.15
        ball 0.17 -0.48 -0.48 0
        ball 0.17 0.48 0.48 0
        ball 0.17 -0.48 0.48 0
        ball 0.17 0.48 -0.48 0
        ball 0.17 -0.48 0 0
        ball 0.17 0.48 0 0
    }
}
end

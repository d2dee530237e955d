sce1.0
# A land of 80,000 triangles with lakes.
# `generate:terrain:TRIANGLES:SEED` makes the land, another one for every seed; the lakes are one
# mirroring plane that cuts through it. The sun stands low: mountains cast their shadows on each other.

eyepos 0 -1.5 0.42
eyedir 0.05 1.5 -0.44
eyeup 0 0 1
wdist 1
fovy_deg 38
nx 480
ny 320
max_recursion 1
aasample 4
background 0.72 0.80 0.88

pointlight -30 -8 17   0.84 0.74 0.58      # the sun
pointlight 20 -30 40   0.22 0.24 0.30      # the sky

{
    ca 0.24 0.28 0.34
    cr 0.62 0.60 0.42
    scale 1 1 0.7
    object_phong generate:terrain:80000:5
}
# The water, and beyond the land the sea.
{
    ca 0.3 0.3 0.3
    cr 0.06 0.15 0.20
    cp 0.50 0.54 0.56
    shininess 300
    translate 0 0 -0.04
    triangle -30 -5 0   30 -5 0   30 60 0
    triangle -30 -5 0   30 60 0   -30 60 0
}
end

sce1.0
# A coral as a scanner gives it: 110,000 triangles of about one size, closed, with detail all over.
# `generate:scan:TRIANGLES:SEED` grows another one for every seed. Meshes from scanners are kind to trees: what is near
# on the surface is near in space, and no triangle is much larger than another. The coral is furrowed all the same, so
# that a ray at its rim passes many boxes before it hits.

eyepos 0.5 -4.9 1.9
eyedir -0.5 4.9 -1.98
eyeup 0 0 1
wdist 1
fovy_deg 23
nx 480
ny 320
max_recursion 1
aasample 4
background 0.10 0.20 0.27

{
    translate -3.5 -3 4.5
    rotate 45 1 -1 0
    arealight 0.8   0.80 0.76 0.68
}
pointlight 5 -3 1.5    0.16 0.22 0.28
pointlight 1 5 3       0.22 0.26 0.30

# The ground of the sea.
{
    ca 0.14 0.22 0.28
    cr 0.62 0.60 0.50
    translate 0 0 -0.74
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
{
    ca 0.20 0.17 0.17
    cr 0.86 0.46 0.34
    cp 0.10 0.10 0.09
    shininess 30
    rotate -28 0 0 1
    object_phong generate:scan:110000:4
}
end

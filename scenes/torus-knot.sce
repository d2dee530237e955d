sce1.0
# A mesh of 70,000 triangles.
# The knot is made by rule, so there is no file to carry along: `generate:KIND:TRIANGLES`. Its soft
# shadow costs a shadow ray for every sample, which is why an acceleration structure is worth having:
# try `--accel none` once, with `--size 48x32`.

eyepos 0 -6.2 3.3
eyedir 0 6.2 -2.85
eyeup 0 0 1
wdist 1
fovy_deg 27
nx 480
ny 320
max_recursion 2
aasample 4
background 0.62 0.60 0.58

{
    translate -4 -2.5 6
    rotate 40 1 -1 0
    arealight 0.9   0.76 0.72 0.66
}
pointlight 3 -14 9   0.24 0.25 0.29

{
    ca 0.26 0.26 0.26
    cr 0.46 0.48 0.49
    cp 0.10 0.10 0.10
    shininess 300
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
{
    ca 0.24 0.22 0.22
    cr 0.76 0.42 0.16
    cp 0.24 0.18 0.12
    shininess 60
    translate 0 0.1 0.72
    rotate 8 1 0 0
    rotate 20 0 0 1
    scale 1.5 1.5 1.7
    object_phong generate:torus-knot:70000
}
end

sce1.0
# Hair: 12,000 strands, each a strip of sixteen long, thin triangles.
# `generate:hair:TRIANGLES:SEED` makes them by rule. They lie every way but along the axes, so that the box around a
# triangle is hardly filled by it, and boxes overlap wherever strands do. The more there are, the finer they become.

eyepos 0.3 -3.4 1.15
eyedir -0.3 3.4 -1.27
eyeup 0 0 1
wdist 1
fovy_deg 26
nx 480
ny 320
max_recursion 0
aasample 4
background 0.30 0.33 0.37

{
    translate -2.4 -2.2 3.4
    rotate 45 1 -1 0
    arealight 0.25   0.82 0.76 0.66
}
pointlight 3 -1.5 0.6   0.16 0.20 0.30
pointlight 0.5 3.5 2.2  0.50 0.46 0.40

{
    ca 0.12 0.09 0.08
    cr 0.30 0.17 0.11
    ball 0.42 0 0 0
}
{
    ca 0.20 0.17 0.15
    cr 0.80 0.46 0.20
    cp 0.24 0.20 0.14
    shininess 24
    object_phong generate:hair:192000:1
}
end

sce1.0
# Soft shadows of an area light.
# A low square light shines through a fence of rods. A shadow is sharp where it starts, at the foot
# of its rod, and the softer the farther it falls: there more of the light is half hidden. Each view
# sample asks one point of the light (`--light-samples 3` asks nine: less noise, more time).

eyepos 1.2 -8.2 4.4
eyedir -0.35 8.2 -3.8
eyeup 0 0 1
wdist 1
fovy_deg 32
nx 480
ny 320
max_recursion 0
aasample 4
background 0.60 0.56 0.54

{
    translate -2.5 8 4.2
    rotate 117 1 0 0.1
    arealight 1.1   0.84 0.76 0.64
}
pointlight 2 -14 8   0.30 0.31 0.36

{
    ca 0.28 0.28 0.28
    cr 0.86 0.82 0.76
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.24 0.24 0.26
{
    cr 0.70 0.30 0.22
    translate -3.2 1.2 0
    push_matrix
        scale 0.13 0.13 1.1
        cylinder
    pop_matrix
    ball 0.24 0 0 1.28
}
{
    cr 0.82 0.56 0.26
    translate -2.4 1.44089 0
    push_matrix
        scale 0.13 0.13 1.9
        cylinder
    pop_matrix
    ball 0.24 0 0 2.08
}
{
    cr 0.40 0.50 0.44
    translate -1.6 1.32888 0
    push_matrix
        scale 0.13 0.13 1.4
        cylinder
    pop_matrix
    ball 0.24 0 0 1.58
}
{
    cr 0.24 0.40 0.48
    translate -0.8 1.02806 0
    push_matrix
        scale 0.13 0.13 2.3
        cylinder
    pop_matrix
    ball 0.24 0 0 2.48
}
{
    cr 0.56 0.34 0.36
    translate 0 0.979136 0
    push_matrix
        scale 0.13 0.13 1.7
        cylinder
    pop_matrix
    ball 0.24 0 0 1.88
}
{
    cr 0.70 0.30 0.22
    translate 0.8 1.25378 0
    push_matrix
        scale 0.13 0.13 2.1
        cylinder
    pop_matrix
    ball 0.24 0 0 2.28
}
{
    cr 0.82 0.56 0.26
    translate 1.6 1.44964 0
    push_matrix
        scale 0.13 0.13 1.2
        cylinder
    pop_matrix
    ball 0.24 0 0 1.38
}
{
    cr 0.40 0.50 0.44
    translate 2.4 1.27977 0
    push_matrix
        scale 0.13 0.13 1.8
        cylinder
    pop_matrix
    ball 0.24 0 0 1.98
}
{
    cr 0.24 0.40 0.48
    translate 3.2 0.993043 0
    push_matrix
        scale 0.13 0.13 1.5
        cylinder
    pop_matrix
    ball 0.24 0 0 1.68
}
{
    cr 0.80 0.77 0.72
    ball 0.55 1.5 -0.9 0.55
    ball 0.3 -1.9 -1.2 0.3
}
end

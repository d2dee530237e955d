sce1.0
# Triangles: paper boats, ten triangles each.
# A triangle is seen and lit from both sides: look at the insides of the hulls. The water is two
# triangles of a material that mirrors (`cp`), and the boats stand a little in it.

eyepos 0 -9 3.2
eyedir 0 9 -2.5
eyeup 0 0 1
wdist 1
fovy_deg 30
nx 480
ny 320
max_recursion 2
aasample 4
background 0.62 0.74 0.80

{
    translate -5 -6 8
    rotate 45 1 -1 0
    arealight 0.5   0.72 0.70 0.64
}
pointlight 6 -12 8   0.20 0.21 0.23

# The water.
{
    ca 0.3 0.3 0.3
    cr 0.10 0.24 0.30
    cp 0.42 0.46 0.48
    shininess 400
    triangle -200 -60 0   200 -60 0   200 300 0
    triangle -200 -60 0   200 300 0   -200 300 0
}

ca 0.32 0.33 0.35
{
    cr 0.86 0.83 0.78
    translate -1.3 -1.5 -0.08
    rotate 24 0 0 1
    rotate 4 1 0 0
    scale 1.15 1.15 1.15
    triangle -1.35 0 0.62   -0.55 0 0   0 0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 0.5 0.42
    triangle -1.35 0 0.62   -0.55 0 0   0 -0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 -0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 -0.5 0.42
    triangle -0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle -0.68 0 0.25   0 -0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 -0.16 0.2   0 0 1.12
}
{
    cr 0.78 0.30 0.22
    translate 1.75 -0.3 -0.08
    rotate -32 0 0 1
    rotate 4 1 0 0
    scale 1.1 1.1 1.1
    triangle -1.35 0 0.62   -0.55 0 0   0 0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 0.5 0.42
    triangle -1.35 0 0.62   -0.55 0 0   0 -0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 -0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 -0.5 0.42
    triangle -0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle -0.68 0 0.25   0 -0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 -0.16 0.2   0 0 1.12
}
{
    cr 0.86 0.64 0.24
    translate -2.9 2.3 -0.08
    rotate -12 0 0 1
    rotate 4 1 0 0
    scale 1.1 1.1 1.1
    triangle -1.35 0 0.62   -0.55 0 0   0 0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 0.5 0.42
    triangle -1.35 0 0.62   -0.55 0 0   0 -0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 -0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 -0.5 0.42
    triangle -0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle -0.68 0 0.25   0 -0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 -0.16 0.2   0 0 1.12
}
{
    cr 0.30 0.46 0.52
    translate 0.5 3.2 -0.08
    rotate 48 0 0 1
    rotate 4 1 0 0
    scale 1.1 1.1 1.1
    triangle -1.35 0 0.62   -0.55 0 0   0 0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 0.5 0.42
    triangle -1.35 0 0.62   -0.55 0 0   0 -0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 -0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 -0.5 0.42
    triangle -0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle -0.68 0 0.25   0 -0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 -0.16 0.2   0 0 1.12
}
{
    cr 0.86 0.83 0.78
    translate 4.6 4.6 -0.08
    rotate 12 0 0 1
    rotate 4 1 0 0
    scale 1.1 1.1 1.1
    triangle -1.35 0 0.62   -0.55 0 0   0 0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 0.5 0.42
    triangle -1.35 0 0.62   -0.55 0 0   0 -0.5 0.42
    triangle -0.55 0 0   0.55 0 0   0 -0.5 0.42
    triangle 0.55 0 0   1.35 0 0.62   0 -0.5 0.42
    triangle -0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 0.16 0.2   0 0 1.12
    triangle -0.68 0 0.25   0 -0.16 0.2   0 0 1.12
    triangle 0.68 0 0.25   0 -0.16 0.2   0 0 1.12
}
end

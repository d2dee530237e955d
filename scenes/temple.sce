sce1.0
# Cylinders with caps under transforms: a round temple.
# Steps, columns, slabs and rings are the one canonical cylinder (radius 1 from z = 0 to z = 1),
# scaled and set in place. Each column is turned into its place by one more `rotate` of 36 degrees,
# so the transforms add up from one column to the next. Look at the caps on top of the steps.

eyepos -5.5 -11 3.1
eyedir 5.5 11 -0.85
eyeup 0 0 1
wdist 1
fovy_deg 31
nx 480
ny 320
max_recursion 0
aasample 4
background 0.52 0.66 0.80

{
    translate 45 -90 70
    rotate 45 1 0.5 0
    arealight 4   0.80 0.72 0.58     # the sun
}
pointlight -90 -60 60   0.20 0.22 0.27   # the sky

# The meadow.
{
    ca 0.3 0.32 0.34
    cr 0.46 0.54 0.34
    triangle -300 -300 0   300 -300 0   300 300 0
    triangle -300 -300 0   300 300 0   -300 300 0
}

ca 0.26 0.27 0.3
cr 0.86 0.82 0.75

# Three steps.
{
    scale 3.2 3.2 0.2
    cylinder
}
{
    translate 0 0 0.2
    scale 2.95 2.95 0.2
    cylinder
}
{
    translate 0 0 0.4
    scale 2.7 2.7 0.2
    cylinder
}

# Ten columns: foot, shaft, head.
{
    translate 0 0 0.6
    rotate 13 0 0 1
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
    rotate 36 0 0 1
    push_matrix
        translate 2.25 0 0
        push_matrix
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 0.12
            scale 0.19 0.19 2.1
            cylinder
        pop_matrix
        push_matrix
            translate 0 0 2.2
            scale 0.27 0.27 0.12
            cylinder
        pop_matrix
    pop_matrix
}

# The beam, the cornice, the drum and the dome.
{
    translate 0 0 2.92
    scale 2.5 2.5 0.3
    cylinder
}
{
    translate 0 0 3.22
    scale 2.7 2.7 0.1
    cylinder
}
{
    translate 0 0 3.32
    scale 2.2 2.2 0.58
    cylinder
}
{
    cr 0.60 0.36 0.28
    translate 0 0 3.9
    scale 2.1 2.1 0.97
    ball 1 0 0 0
}
{
    cr 0.85 0.66 0.25
    cp 0.4 0.35 0.2
    shininess 40
    ball 0.2 0 0 5.02
}

# What it was built for.
{
    cr 0.80 0.77 0.72
    translate 0 0 0.6
    scale 0.55 0.55 0.7
    cylinder
}
{
    cr 0.18 0.38 0.50
    cp 0.4 0.4 0.4
    shininess 60
    ball 0.6 0 0 1.9
}
end

sce1.0
# Transforms that add up: a spiral staircase.
# Every step is the one before it, `translate`d up and `rotate`d by 22.5 degrees more; what only one
# part of a step needs stands between `push_matrix` and `pop_matrix`.

eyepos -2 -12.5 5.8
eyedir 2 12.5 -2.45
eyeup 0 0 1
wdist 1
fovy_deg 35
nx 480
ny 320
max_recursion 1
aasample 4
background 0.76 0.79 0.80

{
    translate -50 -60 90
    rotate 40 1 -1 0
    arealight 4   0.74 0.70 0.62
}
pointlight 60 -80 60   0.17 0.19 0.23

{
    ca 0.28 0.28 0.28
    cr 0.72 0.70 0.66
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.24 0.24 0.26
cp 0.05 0.05 0.05
shininess 30

# The post.
{
    cr 0.24 0.32 0.36
    push_matrix
        scale 0.3 0.3 6.3
        cylinder
    pop_matrix
    ball 0.42 0 0 6.5
}

{
    rotate -60 0 0 1
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
    translate 0 0 0.28
    rotate 22.5 0 0 1
    push_matrix
        cr 0.66 0.42 0.24
        translate 1.35 0 0
        push_matrix
            scale 1.2 0.42 0.1
            cylinder
        pop_matrix
        translate 1.05 0 0.1
        cr 0.82 0.80 0.76
        push_matrix
            scale 0.035 0.035 0.95
            cylinder
        pop_matrix
        cr 0.80 0.62 0.28
        ball 0.1 0 0 1.0
    pop_matrix
}
end

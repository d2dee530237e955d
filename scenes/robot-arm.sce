sce1.0
# Nested transforms: a robot's arm.
# Each joint is a `rotate` within the braces of the joint before it. Change one angle and all that
# hangs on it follows; a `}` takes everything back, for the second finger of the hand. The joints have keys: it reaches
# down, and comes back, in the frames from 0 to 60: `srt scenes/robot-arm.sce frames/####.png --frames 0..60`.

eyepos -3.2 -9.4 3.6
eyedir 3.75 9.4 -2.0
eyeup 0 0 1
wdist 1
fovy_deg 31
nx 480
ny 320
max_recursion 2
aasample 4
background 0.70 0.76 0.80

{
    translate -60 -50 90
    rotate 40 1 -1 0
    arealight 8   0.74 0.72 0.68
}
pointlight 50 -90 60   0.18 0.19 0.22

{
    ca 0.28 0.28 0.28
    cr 0.66 0.68 0.68
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.22 0.22 0.24
cr 0.86 0.44 0.10
cp 0.10 0.10 0.10
shininess 60

{
    # The foot.
    {
        cr 0.26 0.28 0.30
        scale 1.05 1.05 0.3
        cylinder
    }
    translate 0 0 0.3
    {
        scale 0.7 0.7 0.5
        cylinder
    }
    translate 0 0 0.75

    at 0  rotate -28 0 0 1          # the waist
    to 20 rotate -36 0 0 1
    to 35 rotate -36 0 0 1
    to 60 rotate -28 0 0 1
    at 0  rotate -24 0 1 0          # the shoulder
    to 30 rotate 8 0 1 0
    to 60 rotate -24 0 1 0
    {
        cr 0.26 0.28 0.30
        translate 0 -0.5 0
        rotate -90 1 0 0
        scale 0.42 0.42 1.0
        cylinder
    }
    {
        scale 0.3 0.24 2.0
        cylinder
    }
    translate 0 0 2.0

    at 0  rotate 105 0 1 0          # the elbow
    to 30 rotate 88 0 1 0
    to 60 rotate 105 0 1 0
    {
        cr 0.26 0.28 0.30
        translate 0 -0.4 0
        rotate -90 1 0 0
        scale 0.34 0.34 0.8
        cylinder
    }
    {
        scale 0.21 0.19 1.8
        cylinder
    }
    translate 0 0 1.8

    at 0  rotate 42 0 1 0           # the wrist
    to 30 rotate 74 0 1 0
    to 60 rotate 42 0 1 0
    {
        cr 0.26 0.28 0.30
        ball 0.28 0 0 0
    }
    {
        scale 0.15 0.15 0.5
        cylinder
    }
    translate 0 0 0.5
    {
        cr 0.26 0.28 0.30
        translate 0 0 0
        scale 0.34 0.34 0.1
        cylinder
    }
    translate 0 0 0.1
    cr 0.70 0.72 0.74
    {
        translate 0.24 0 0          # a finger
        rotate 24 0 1 0
        push_matrix
            scale 0.07 0.07 0.34
            cylinder
        pop_matrix
        translate 0 0 0.34
        rotate -48 0 1 0
        ball 0.08 0 0 0
        scale 0.06 0.06 0.34
        cylinder
    }
    {
        translate -0.24 0 0         # the other
        rotate -24 0 1 0
        push_matrix
            scale 0.07 0.07 0.34
            cylinder
        pop_matrix
        translate 0 0 0.34
        rotate 48 0 1 0
        ball 0.08 0 0 0
        scale 0.06 0.06 0.34
        cylinder
    }
    cr 0.16 0.42 0.50
    cp 0.2 0.2 0.2
    ball 0.3 0 0 0.5                # what it holds
}

# What it has brought already.
{
    cr 0.16 0.42 0.50
    cp 0.2 0.2 0.2
    ball 0.3 2.5 -2.2 0.3
    ball 0.3 3.1 -1.9 0.3
    ball 0.3 2.9 -2.55 0.3
    ball 0.3 2.83 -2.2 0.78
}
end

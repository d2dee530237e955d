sce1.0
# Ellipsoids: balls under unequal scales.
# Every pebble is `ball 1 0 0 0`, flattened by `scale`. Normals do not scale as points do: they are
# carried by the inverse transpose, and the soft shading of the flat stones shows that they are.

eyepos 0 -8.5 3.0
eyedir 0 8.5 -1.55
eyeup 0 0 1
wdist 1
fovy_deg 30
nx 480
ny 320
max_recursion 0
aasample 4
background 0.74 0.77 0.78

{
    translate -30 -32 50
    rotate 40 1 -1 0
    arealight 7   0.80 0.76 0.70
}
pointlight 30 -80 90   0.20 0.21 0.24

# Sand.
{
    ca 0.28 0.28 0.28
    cr 0.78 0.73 0.65
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.2 0.2 0.21
cp 0.12 0.12 0.12
shininess 25

# The pile, each stone on top of the one before.
{
    translate 0.3 0 0.42
    {
        cr 0.36 0.38 0.40
        rotate 3 0 1 0
        scale 1.5 1.2 0.44
        ball 1 0 0 0
    }
    translate -0.1 0 0.74
    {
        cr 0.62 0.59 0.54
        rotate -4 0 1 0
        scale 1.12 0.95 0.34
        ball 1 0 0 0
    }
    translate 0.12 0 0.60
    {
        cr 0.48 0.30 0.24
        rotate 5 0 1 0
        scale 0.82 0.74 0.28
        ball 1 0 0 0
    }
    translate -0.06 0 0.48
    {
        cr 0.40 0.46 0.44
        rotate -6 0 1 0
        scale 0.56 0.52 0.22
        ball 1 0 0 0
    }
    translate 0.05 0 0.40
    {
        cr 0.82 0.80 0.76
        rotate 8 0 1 0
        scale 0.30 0.28 0.2
        ball 1 0 0 0
    }
}

# Those that lie about.
{
    translate -2.3 0.4 0.32
    cr 0.55 0.52 0.48
    rotate 25 0 0 1
    scale 0.85 0.55 0.33
    ball 1 0 0 0
}
{
    translate -1.75 -1.5 0.2
    cr 0.46 0.28 0.23
    rotate -30 0 0 1
    scale 0.45 0.3 0.2
    ball 1 0 0 0
}
{
    translate 2.35 -0.9 0.26
    cr 0.34 0.37 0.39
    rotate -15 0 0 1
    scale 0.62 0.42 0.26
    ball 1 0 0 0
}
{
    translate 3.0 1.5 0.4
    cr 0.66 0.62 0.56
    rotate 40 0 0 1
    scale 0.9 0.7 0.4
    ball 1 0 0 0
}
{
    translate 1.1 -1.7 0.13
    cr 0.80 0.77 0.72
    scale 0.24 0.18 0.13
    ball 1 0 0 0
}
end

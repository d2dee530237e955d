sce1.0
# Glass: `alpha` lets light through, `ri` bends it.
# The clear ball turns the room upside down, as a lens does, and darkens to its edge where Fresnel's
# equations mirror more and more. In the standing cylinder look for the places that shine like
# silver: light that meets the border of glass from inside at more than 42 degrees from the normal
# is mirrored whole. Shadow rays are dimmed by glass but not bent: there are no caustics.

eyepos 0 -8.4 2.3
eyedir 0 8.4 -1.15
eyeup 0 0 1
wdist 1
fovy_deg 30
nx 480
ny 320
max_recursion 10
aasample 4
background 0.70 0.78 0.82

{
    translate -50 -50 80
    rotate 40 1 -1 0
    arealight 5   0.70 0.68 0.64
}
pointlight 60 -80 60   0.20 0.20 0.22

{
    ca 0.28 0.28 0.28
    cr 0.74 0.72 0.68
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

# Rods behind, to be seen through the glass.
ca 0.26 0.26 0.28
{
    cr 0.76 0.32 0.22
    translate -4.2 3 0
    scale 0.16 0.16 2.2
    cylinder
}
{
    cr 0.86 0.62 0.22
    translate -3.5 3 0
    scale 0.16 0.16 2.74833
    cylinder
}
{
    cr 0.22 0.44 0.50
    translate -2.8 3 0
    scale 0.16 0.16 2.88169
    cylinder
}
{
    cr 0.76 0.32 0.22
    translate -2.1 3 0
    scale 0.16 0.16 2.49917
    cylinder
}
{
    cr 0.86 0.62 0.22
    translate -1.4 3 0
    scale 0.16 0.16 1.89024
    cylinder
}
{
    cr 0.22 0.44 0.50
    translate -0.7 3 0
    scale 0.16 0.16 1.51573
    cylinder
}
{
    cr 0.76 0.32 0.22
    translate -8.88178e-16 3 0
    scale 0.16 0.16 1.65906
    cylinder
}
{
    cr 0.86 0.62 0.22
    translate 0.7 3 0
    scale 0.16 0.16 2.21177
    cylinder
}
{
    cr 0.22 0.44 0.50
    translate 1.4 3 0
    scale 0.16 0.16 2.75557
    cylinder
}
{
    cr 0.76 0.32 0.22
    translate 2.1 3 0
    scale 0.16 0.16 2.87892
    cylinder
}
{
    cr 0.86 0.62 0.22
    translate 2.8 3 0
    scale 0.16 0.16 2.48848
    cylinder
}
{
    cr 0.22 0.44 0.50
    translate 3.5 3 0
    scale 0.16 0.16 1.87972
    cylinder
}
{
    cr 0.76 0.32 0.22
    translate 4.2 3 0
    scale 0.16 0.16 1.51334
    cylinder
}

# The glass.
{
    ca 0.1 0.1 0.1
    cr 0.9 0.95 0.95
    cp 0.03 0.03 0.03
    shininess 600
    alpha 0.04
    ri 1.5
    ball 1.05 -1.1 0 1.05
    {
        translate 1.55 0.1 0.002
        scale 0.62 0.62 1.75
        cylinder
    }
    {
        translate 0.45 -1.9 0.36
        scale 0.62 0.62 0.36
        ball 1 0 0 0
    }
}
# And a solid one.
{
    cr 0.20 0.42 0.48
    cp 0.2 0.2 0.2
    shininess 80
    ball 0.32 2.7 -1.4 0.32
    ball 0.32 -2.7 -1.3 0.32
}
end

sce1.0
# Mirrors that face each other.
# The two long walls mirror nine tenths of what they see, so the four balls go on behind the glass,
# a little greener with every bounce, for as long as `max_recursion` lets them. The large ball
# mirrors too: find both walls in it.

eyepos -1.6 -3.9 2.05
eyedir 1 1.18 -0.30
eyeup 0 0 1
wdist 1
fovy_deg 50
nx 480
ny 320
max_recursion 20
aasample 4
background 0.76 0.82 0.86

{
    translate 0 0 9
    arealight 1   0.62 0.60 0.56
}
pointlight 0 -5 4   0.24 0.23 0.22

# The floor: planks across.
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -6 0   1.8 -6 0   1.8 -5.5 0
    triangle -1.8 -6 0   1.8 -5.5 0   -1.8 -5.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -5.5 0   1.8 -5.5 0   1.8 -5 0
    triangle -1.8 -5.5 0   1.8 -5 0   -1.8 -5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -5 0   1.8 -5 0   1.8 -4.5 0
    triangle -1.8 -5 0   1.8 -4.5 0   -1.8 -4.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -4.5 0   1.8 -4.5 0   1.8 -4 0
    triangle -1.8 -4.5 0   1.8 -4 0   -1.8 -4 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -4 0   1.8 -4 0   1.8 -3.5 0
    triangle -1.8 -4 0   1.8 -3.5 0   -1.8 -3.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -3.5 0   1.8 -3.5 0   1.8 -3 0
    triangle -1.8 -3.5 0   1.8 -3 0   -1.8 -3 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -3 0   1.8 -3 0   1.8 -2.5 0
    triangle -1.8 -3 0   1.8 -2.5 0   -1.8 -2.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -2.5 0   1.8 -2.5 0   1.8 -2 0
    triangle -1.8 -2.5 0   1.8 -2 0   -1.8 -2 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -2 0   1.8 -2 0   1.8 -1.5 0
    triangle -1.8 -2 0   1.8 -1.5 0   -1.8 -1.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -1.5 0   1.8 -1.5 0   1.8 -1 0
    triangle -1.8 -1.5 0   1.8 -1 0   -1.8 -1 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 -1 0   1.8 -1 0   1.8 -0.5 0
    triangle -1.8 -1 0   1.8 -0.5 0   -1.8 -0.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 -0.5 0   1.8 -0.5 0   1.8 0 0
    triangle -1.8 -0.5 0   1.8 0 0   -1.8 0 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 0 0   1.8 0 0   1.8 0.5 0
    triangle -1.8 0 0   1.8 0.5 0   -1.8 0.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 0.5 0   1.8 0.5 0   1.8 1 0
    triangle -1.8 0.5 0   1.8 1 0   -1.8 1 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 1 0   1.8 1 0   1.8 1.5 0
    triangle -1.8 1 0   1.8 1.5 0   -1.8 1.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 1.5 0   1.8 1.5 0   1.8 2 0
    triangle -1.8 1.5 0   1.8 2 0   -1.8 2 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 2 0   1.8 2 0   1.8 2.5 0
    triangle -1.8 2 0   1.8 2.5 0   -1.8 2.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 2.5 0   1.8 2.5 0   1.8 3 0
    triangle -1.8 2.5 0   1.8 3 0   -1.8 3 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 3 0   1.8 3 0   1.8 3.5 0
    triangle -1.8 3 0   1.8 3.5 0   -1.8 3.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 3.5 0   1.8 3.5 0   1.8 4 0
    triangle -1.8 3.5 0   1.8 4 0   -1.8 4 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 4 0   1.8 4 0   1.8 4.5 0
    triangle -1.8 4 0   1.8 4.5 0   -1.8 4.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 4.5 0   1.8 4.5 0   1.8 5 0
    triangle -1.8 4.5 0   1.8 5 0   -1.8 5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 5 0   1.8 5 0   1.8 5.5 0
    triangle -1.8 5 0   1.8 5.5 0   -1.8 5.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 5.5 0   1.8 5.5 0   1.8 6 0
    triangle -1.8 5.5 0   1.8 6 0   -1.8 6 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 6 0   1.8 6 0   1.8 6.5 0
    triangle -1.8 6 0   1.8 6.5 0   -1.8 6.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 6.5 0   1.8 6.5 0   1.8 7 0
    triangle -1.8 6.5 0   1.8 7 0   -1.8 7 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 7 0   1.8 7 0   1.8 7.5 0
    triangle -1.8 7 0   1.8 7.5 0   -1.8 7.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 7.5 0   1.8 7.5 0   1.8 8 0
    triangle -1.8 7.5 0   1.8 8 0   -1.8 8 0
}
{
    ca 0.32 0.32 0.32
    cr 0.48 0.34 0.23
    triangle -1.8 8 0   1.8 8 0   1.8 8.5 0
    triangle -1.8 8 0   1.8 8.5 0   -1.8 8.5 0
}
{
    ca 0.32 0.32 0.32
    cr 0.60 0.44 0.31
    triangle -1.8 8.5 0   1.8 8.5 0   1.8 9 0
    triangle -1.8 8.5 0   1.8 9 0   -1.8 9 0
}

# The mirrors, and their skirting boards.
{
    cr 0.02 0.03 0.03
    cp 0.86 0.91 0.88
    shininess 4000
    triangle -1.8 -6 0.12   -1.8 9 0.12   -1.8 9 2.6
    triangle -1.8 -6 0.12   -1.8 9 2.6   -1.8 -6 2.6
    triangle 1.8 -6 0.12   1.8 9 0.12   1.8 9 2.6
    triangle 1.8 -6 0.12   1.8 9 2.6   1.8 -6 2.6
}
{
    ca 0.3 0.3 0.3
    cr 0.80 0.78 0.74
    triangle -1.8 -6 0   -1.8 9 0   -1.8 9 0.12
    triangle -1.8 -6 0   -1.8 9 0.12   -1.8 -6 0.12
    triangle 1.8 -6 0   1.8 9 0   1.8 9 0.12
    triangle 1.8 -6 0   1.8 9 0.12   1.8 -6 0.12
}

# The balls and their stands.
ca 0.24 0.24 0.24
{
    translate 0.35 -0.7 0
    {
        cr 0.80 0.78 0.74
        scale 0.22 0.22 0.6
        cylinder
    }
    cr 0.06 0.06 0.06
    cp 0.80 0.80 0.82
    shininess 80
    ball 0.5 0 0 1.1
}
{
    translate -0.7 0.6 0
    {
        cr 0.80 0.78 0.74
        scale 0.22 0.22 0.9
        cylinder
    }
    cr 0.74 0.28 0.18
    cp 0.08 0.08 0.08
    shininess 80
    ball 0.3 0 0 1.2
}
{
    translate 0.9 1.2 0
    {
        cr 0.80 0.78 0.74
        scale 0.22 0.22 0.5
        cylinder
    }
    cr 0.85 0.62 0.18
    cp 0.08 0.08 0.08
    shininess 80
    ball 0.32 0 0 0.82
}
{
    translate 1.0 -1.35 0
    {
        cr 0.80 0.78 0.74
        scale 0.22 0.22 0.25
        cylinder
    }
    cr 0.14 0.42 0.50
    cp 0.08 0.08 0.08
    shininess 80
    ball 0.24 0 0 0.49
}
end

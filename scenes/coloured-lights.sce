sce1.0
# Lights add up: red, green and blue make white.
# Three lights of one colour each, three shadows. Where red alone is hidden, green and blue make
# cyan; where two are hidden, the colour of the third is left.

eyepos 0 -8.5 5.2
eyedir 0 8.5 -4.6
eyeup 0 0 1
wdist 1
fovy_deg 25
nx 480
ny 320
max_recursion 0
aasample 4
background 0.30 0.30 0.32

{
    translate -4.5 -3.5 6
    arealight 0.25   0.72 0.14 0.12
}
{
    translate 0 -5.5 7
    arealight 0.25   0.12 0.66 0.18
}
{
    translate 4.5 -3.5 6
    arealight 0.25   0.14 0.20 0.74
}

{
    ca 0.06 0.06 0.06
    cr 0.94 0.94 0.94
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
ca 0.08 0.08 0.08
cr 0.94 0.94 0.94
{
    translate 0 -0.2 0
    push_matrix
        scale 0.16 0.16 1.2
        cylinder
    pop_matrix
    ball 0.55 0 0 1.6
}
ball 0.4 -1.9 -0.7 0.4
ball 0.4 1.9 -0.7 0.4
end

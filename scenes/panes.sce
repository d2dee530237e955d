sce1.0
# Panes that are partly transparent: `alpha 0.5`, `ri 1`.
# A pane adds half of its own colour to half of what is behind it; where two or three overlap the
# colours mix, the front one strongest. The shadows tell a limit of the model: a pane dims the light
# by its opacity, it does not colour it, so all shadows are grey - but darker where two panes overlap.

eyepos -1.6 -8.8 3.7
eyedir 1.75 8.8 -2.75
eyeup 0 0 1
wdist 1
fovy_deg 28
nx 480
ny 320
max_recursion 8
aasample 4
background 0.76 0.76 0.74

{
    translate 50 -35 70
    arealight 2.5   0.66 0.63 0.59
}
pointlight -20 -90 60   0.22 0.22 0.24

{
    ca 0.28 0.28 0.28
    cr 0.86 0.84 0.80
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.40 0.40 0.40
alpha 0.5
ri 1
{
    cr 0.86 0.30 0.20
    translate -1.1 -0.9 0.001
    rotate 14 0 0 1
    triangle -1.1 0 0   1.1 0 0   1.1 0 2.1
    triangle -1.1 0 0   1.1 0 2.1   -1.1 0 2.1
}
{
    cr 0.90 0.68 0.16
    translate 0.2 0.3 0.001
    rotate -6 0 0 1
    triangle -1.15 0 0   1.15 0 0   1.15 0 2.6
    triangle -1.15 0 0   1.15 0 2.6   -1.15 0 2.6
}
{
    cr 0.12 0.44 0.62
    translate 1.2 1.6 0.001
    rotate 10 0 0 1
    triangle -1.2 0 0   1.2 0 0   1.2 0 2.3
    triangle -1.2 0 0   1.2 0 2.3   -1.2 0 2.3
}
{
    alpha 1
    ca 0.26 0.26 0.26
    cr 0.80 0.78 0.74
    ball 0.45 -0.2 2.9 0.45
    ball 0.3 2.0 -0.4 0.3
    cr 0.30 0.32 0.34
    ball 0.3 -1.2 1.0 0.3
}
end

sce1.0
# Many balls: 20,000 of them, most small, a few large, some within others.
# `scatter balls:COUNT:SEED` makes them by rule; the more there are, the smaller they become, and they fill the unit
# ball alike. Their sizes follow a power law, as those of bubbles in a foam do: no division of space suits all of them.

eyepos 0.8 -4.6 1.7
eyedir -0.8 4.6 -1.72
eyeup 0 0 1
wdist 1
fovy_deg 26
nx 480
ny 320
max_recursion 2
aasample 4
background 0.93 0.91 0.87

{
    translate -4 -3 5
    rotate 45 1 -1 0
    arealight 1.0   0.62 0.59 0.54
}
pointlight 4 -6 3   0.24 0.25 0.28

{
    ca 0.30 0.29 0.28
    cr 0.76 0.74 0.70
    translate 0 0 -1.02
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}
{
    ca 0.26 0.26 0.27
    cr 0.95 0.95 0.95
    cp 0.16 0.16 0.16
    shininess 90
    scatter balls:20000:3
}
end

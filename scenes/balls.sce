sce1.0
# Balls in the light of two points.
# The three differ in `shininess` alone: from left to right 6, 40 and 300. The higher the exponent,
# the smaller the highlight. Look too at where the light ends on each ball, and at the shadows,
# which are sharp because the lights are points.

eyepos 0 -9.5 3.2
eyedir 0 9.5 -2.2
eyeup 0 0 1
wdist 1
fovy_deg 31
nx 480
ny 320
max_recursion 0
aasample 4
background 0.56 0.60 0.64

pointlight -50 -60 75   0.80 0.75 0.68    # the sun, from the left
pointlight 60 -40 60   0.22 0.24 0.28    # the sky, from the right

# The floor.
{
    ca 0.25 0.25 0.25
    cr 0.72 0.69 0.64
    triangle -60 -60 0   60 -60 0   60 60 0
    triangle -60 -60 0   60 60 0   -60 60 0
}

ca 0.2 0.2 0.22
cp 0.5 0.5 0.5
{
    cr 0.72 0.28 0.18      # terracotta
    shininess 6
    ball 1 -2.4 0 1
}
{
    cr 0.80 0.58 0.20      # ochre
    shininess 40
    ball 1 0 0 1
}
{
    cr 0.12 0.44 0.46      # teal
    shininess 300
    ball 1 2.4 0 1
}
# Three small ones in front.
{
    cr 0.85 0.82 0.76
    shininess 100
    ball 0.3 -1.2 -1.5 0.3
    ball 0.3 1.2 -1.5 0.3
}
end

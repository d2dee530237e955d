sce1.0
# Deformations with keys: a knot that is wrung, rings with waves, and is itself again after 60 frames.
# Render it with `srt scenes/twist.sce frames/####.png --frames 0..59`.

at 0  eyepos -1.9 -4.6 2.2
to 30 eyepos 1.9 -4.6 2.2
to 60 eyepos -1.9 -4.6 2.2
at 0  eyedir 1.9 4.6 -2.0
to 30 eyedir -1.9 4.6 -2.0
to 60 eyedir 1.9 4.6 -2.0
eyeup 0 0 1
wdist 1
fovy_deg 32
nx 480
ny 320
max_recursion 2
aasample 3
background .72 .78 .84

{
    translate -4 -5 7
    rotate -30 0 1 0
    rotate 35 1 0 0
    arealight 1.5   .75 .72 .66
}
pointlight 6 -5 5   .18 .2 .24

{
    cr .62 .64 .66
    ca .25 .25 .25
    triangle -30 -30 -.75   30 -30 -.75   30 30 -.75
    triangle -30 -30 -.75   30 30 -.75   -30 30 -.75
}

ca .22 .22 .24
cr .80 .34 .12
cp .12 .12 .12
shininess 60
at 0  twist 0
to 15 twist 170
to 45 twist -170
to 60 twist 0
every 60
at 0  wave .05 .9 0
to 30 wave .16 .9 1
to 60 wave .05 .9 2
at 0  rotate 0 0 0 1
to 60 rotate 120 0 0 1
object_phong generate:torus-knot:24k
end

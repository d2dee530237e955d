sce1.0
# A ball that bursts: every triangle of the mesh flies, and tumbles. Frames 0 to 60.

eyepos 0 -7.5 2.6
eyedir 0 7.5 -2.0
eyeup 0 0 1
wdist 1
at 0  fovy_deg 26
to 60 fovy_deg 40
nx 480
ny 320
max_recursion 1
aasample 3
background .06 .07 .10

at 0 pointlight 0 0 .6   .9 .7 .4          # the flash within
to 8 pointlight 0 0 .6   1.1 .8 .5
to 40 pointlight 0 0 .6  .1 .06 .04
{
    translate -5 -6 9
    rotate -25 0 1 0
    rotate 30 1 0 0
    arealight 1.6   .7 .7 .74
}

{
    cr .5 .5 .54
    ca .2 .2 .22
    triangle -60 -60 -1.02   60 -60 -1.02   60 60 -1.02
    triangle -60 -60 -1.02   60 60 -1.02   -60 60 -1.02
}

ca .25 .22 .2
cr .75 .55 .25
cp .15 .15 .15
shininess 40
at 0  explode 0
to 6  explode 0
to 14 explode .45
to 30 explode .95
to 60 explode 1.4
object_flat generate:icosphere:5k
{
    cr .2 .45 .7
    scale .6 .6 .6
    at 0 explode 0
    to 5 explode 0
    to 14 explode .5
    to 60 explode 2.0
    object_flat generate:icosphere:1k
}
end

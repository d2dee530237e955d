sce1.0
# A crowd that walks: 400 people of two meshes and cylinders, each out of step with the others, because `delay` adds up
# in a `repeat`. Render it with `srt scenes/crowd.sce frames/####.png --frames 0..95`.

eyepos -3.2 -8.6 3.4
eyedir 2.6 9 -2.5
eyeup 0 0 1
wdist 1
fovy_deg 38
nx 480
ny 320
max_recursion 1
aasample 3
background .76 .82 .88

{
    translate -20 -25 30
    rotate -32 0 1 0
    rotate 38 1 0 0
    arealight 4   .76 .72 .64
}
pointlight 30 -40 30   .16 .18 .22

{
    cr .58 .57 .54
    ca .25 .25 .25
    triangle -90 -90 0   90 -90 0   90 90 0
    triangle -90 -90 0   90 90 0   -90 90 0
}

ca .22 .22 .24
cp .04 .04 .04
shininess 20
at 0   translate -14.5 .5 0              # all of them come nearer
to 240 translate -14.5 -9.5 0
repeat 10
    push_matrix
    repeat 20
        delay 7
        translate 1.5 .07 0
        {
            every 24
            at 0  translate 0 0 0                  # up and down with each step
            to 6  translate 0 0 .05
            to 12 translate 0 0 0
            to 18 translate 0 0 .05
            to 24 translate 0 0 0
            {
                cr .16 .34 .58
                translate 0 0 1.2
                scale .21 .13 .37
                object_phong generate:icosphere:500
            }
            {
                cr .72 .54 .42
                translate 0 -.02 1.74
                scale .12 .13 .16
                object_phong generate:icosphere:500
            }
            {
                cr .16 .16 .2
                translate .11 0 .95                # a leg
                at 0  rotate -28 1 0 0
                to 12 rotate 28 1 0 0
                to 24 rotate -28 1 0 0
                scale .08 .08 -.92
                cylinder
            }
            {
                cr .16 .16 .2
                translate -.11 0 .95               # the other
                at 0  rotate 28 1 0 0
                to 12 rotate -28 1 0 0
                to 24 rotate 28 1 0 0
                scale .08 .08 -.92
                cylinder
            }
            {
                cr .16 .34 .58
                translate .25 0 1.47               # an arm
                at 0  rotate 24 1 0 0
                to 12 rotate -24 1 0 0
                to 24 rotate 24 1 0 0
                rotate -9 0 1 0
                scale .05 .05 -.68
                cylinder
            }
            {
                cr .16 .34 .58
                translate -.25 0 1.47              # the other
                at 0  rotate -24 1 0 0
                to 12 rotate 24 1 0 0
                to 24 rotate -24 1 0 0
                rotate 9 0 1 0
                scale .05 .05 -.68
                cylinder
            }
        }
    end_repeat
    pop_matrix
    push_matrix
    translate .7 1.1 0
    repeat 20
        delay 11
        translate 1.5 -.06 0
        {
            every 24
            at 0  translate 0 0 0                  # up and down with each step
            to 6  translate 0 0 .05
            to 12 translate 0 0 0
            to 18 translate 0 0 .05
            to 24 translate 0 0 0
            {
                cr .66 .24 .16
                translate 0 0 1.2
                scale .21 .13 .37
                object_phong generate:icosphere:500
            }
            {
                cr .72 .54 .42
                translate 0 -.02 1.74
                scale .12 .13 .16
                object_phong generate:icosphere:500
            }
            {
                cr .24 .22 .2
                translate .11 0 .95                # a leg
                at 0  rotate -28 1 0 0
                to 12 rotate 28 1 0 0
                to 24 rotate -28 1 0 0
                scale .08 .08 -.92
                cylinder
            }
            {
                cr .24 .22 .2
                translate -.11 0 .95               # the other
                at 0  rotate 28 1 0 0
                to 12 rotate -28 1 0 0
                to 24 rotate 28 1 0 0
                scale .08 .08 -.92
                cylinder
            }
            {
                cr .66 .24 .16
                translate .25 0 1.47               # an arm
                at 0  rotate 24 1 0 0
                to 12 rotate -24 1 0 0
                to 24 rotate 24 1 0 0
                rotate -9 0 1 0
                scale .05 .05 -.68
                cylinder
            }
            {
                cr .66 .24 .16
                translate -.25 0 1.47              # the other
                at 0  rotate -24 1 0 0
                to 12 rotate 24 1 0 0
                to 24 rotate -24 1 0 0
                rotate 9 0 1 0
                scale .05 .05 -.68
                cylinder
            }
        }
    end_repeat
    pop_matrix
    translate .2 2.3 0
end_repeat
end

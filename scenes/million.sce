sce1.0
# A million torus knots, all of one mesh, laid out on a cone as a sunflower lays out its seeds: each
# is turned by the golden angle against the one before it, and a little larger.
eyepos 0 -1.03 .175
eyedir 0 1 -.24
eyeup 0 0 1
wdist 1
fovy_deg 44
nx 480
ny 320
max_recursion 0
aasample 4
background .74 .82 .92

pointlight -3 -4 5  .8 .77 .7
pointlight 4 -2 3  .25 .25 .33

ca .3 .3 .34

# What the spiral leaves free in the middle.
cr .35 .2 .1
ball .03 0 0 -.012

# Five colours in turn: the eye sees them as arms.
scale .03 .03 .03
cp .25 .25 .25
shininess 20
repeat 200000
  cr .9 .25 .12
  rotate 137.507764 0 0 1
  scale 1.0000036 1.0000036 1.0000036
  push_matrix
    translate 1 0 .12
    rotate 70 .3 1 .2
    scale .0023 .0023 .0023
    object_phong generate:torus-knot:600
  pop_matrix

  cr .95 .6 .15
  rotate 137.507764 0 0 1
  scale 1.0000036 1.0000036 1.0000036
  push_matrix
    translate 1 0 .12
    rotate 70 .3 1 .2
    scale .0023 .0023 .0023
    object_phong generate:torus-knot:600
  pop_matrix

  cr .2 .5 .3
  rotate 137.507764 0 0 1
  scale 1.0000036 1.0000036 1.0000036
  push_matrix
    translate 1 0 .12
    rotate 70 .3 1 .2
    scale .0023 .0023 .0023
    object_phong generate:torus-knot:600
  pop_matrix

  cr .15 .35 .65
  rotate 137.507764 0 0 1
  scale 1.0000036 1.0000036 1.0000036
  push_matrix
    translate 1 0 .12
    rotate 70 .3 1 .2
    scale .0023 .0023 .0023
    object_phong generate:torus-knot:600
  pop_matrix

  cr .85 .82 .75
  rotate 137.507764 0 0 1
  scale 1.0000036 1.0000036 1.0000036
  push_matrix
    translate 1 0 .12
    rotate 70 .3 1 .2
    scale .0023 .0023 .0023
    object_phong generate:torus-knot:600
  pop_matrix
end_repeat
end

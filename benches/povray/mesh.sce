sce1.0
# A floor of two triangles, a mirror ball, a mesh and an area light: the picture that POV-Ray renders
# from balls.pov with a mesh. Rendered with --light-samples 4.
eyepos 0 -7 3
eyedir 0 7 -2.2
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 600
ny 300
max_recursion 5
aasample 4
background .2 .3 .5

ca .1 .1 .1
cr .8 .8 .7
triangle -6 -6 0   6 -6 0   6 6 0
triangle -6 -6 0   6 6 0   -6 6 0

cr .2 .2 .2
cp .6 .6 .6
shininess 50
ball 1 -1.2 0 1
{
  cr .8 .8 .7
  cp 0 0 0
  translate 1.2 0 1.2
  scale 1.6 1.6 1.6
  object_flat generate:torus-knot:70000
}

translate -3 -3 6
arealight 1 .9 .9 .9
end

sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 60
ny 40
pointlight 2 -3 5  1 1 1
{
scale 1e-30 1 1
scale 1e-30 1 1
ball 1 0 0 0
cylinder
arealight 1 1 1 1
}
{
scale 1e30 1e30 1e30
scale 1e30 1e30 1e30
pointlight 1 1 1  1 1 1
}
{
translate 3e38 0 0
translate 3e38 0 0
triangle 0 0 0 1 0 0 0 1 0
}
ball 1 0 0 0
end

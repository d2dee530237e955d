sce1.0
# A columned hall: 100,000 triangles, seen from inside.
# Twelve triangles make the room, all others the fluted columns, arches and vases: huge and tiny ones
# in one mesh, as in models of buildings, which is hard on acceleration structures. The lights stand
# in the room; only what lies between a point and a light casts a shadow.

eyepos -0.90 -0.12 0.26
eyedir 1.8 0.22 0.10
eyeup 0 0 1
wdist 1
fovy_deg 62
nx 480
ny 320
max_recursion 2
aasample 4
background 0 0 0

{
    translate 0.6 0 0.62
    rotate 180 1 0 0
    arealight 0.12   0.48 0.42 0.33
}
{
    translate -0.45 0 0.62
    rotate 180 1 0 0
    arealight 0.12   0.40 0.37 0.32
}
pointlight -0.95 0 0.3   0.26 0.26 0.28

{
    ca 0.20 0.20 0.22
    cr 0.84 0.76 0.64
    object_phong generate:hall:100000
}
{
    cr 0.10 0.08 0.06
    cp 0.62 0.56 0.46
    shininess 200
    ball 0.1 0.12 0.02 0.1
}
end

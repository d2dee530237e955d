sce1.0
# A town of 16,384 boxes, all instances of one mesh: towers of four boxes, blocks of towers, quarters of blocks.
# `scatter city:COUNT:SEED` builds it by rule. Objects are in clusters of three scales, with streets and avenues
# between them, and the town is high in the middle and flat beside it: a structure over the objects has all the work,
# since each mesh is twelve triangles.

eyepos 0.44 -0.92 0.33
eyedir -0.44 0.95 -0.28
eyeup 0 0 1
wdist 1
fovy_deg 44
nx 480
ny 320
max_recursion 0
aasample 4
background 0.78 0.82 0.86

pointlight -26 -12 14   0.80 0.66 0.48
pointlight 30 -30 40    0.20 0.23 0.30

# The ground: an island.
{
    ca 0.26 0.28 0.32
    cr 0.42 0.43 0.42
    triangle -1.2 -1.2 0   1.2 -1.2 0   1.2 1.2 0
    triangle -1.2 -1.2 0   1.2 1.2 0   -1.2 1.2 0
}
{
    ca 0.30 0.31 0.36
    cr 1 1 1
    scatter city:16384:2
}
end

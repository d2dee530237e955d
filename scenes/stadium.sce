sce1.0
# A teapot in a stadium: one fine thing in a large place.
# The stands are of few, long triangles; of 100,000 triangles nearly all are the teapot's, which is a hundredth as large
# as the stadium. What divides the whole evenly has the teapot in one cell: `srt compare` this with
# `--accel bvh,kdtree,grid,grid2,octree`, or look at it with `--view heatmap --accel grid`.

eyepos 0.012 -0.034 0.0075
eyedir -0.0125 0.034 0.0035
eyeup 0 0 1
wdist 1
fovy_deg 50
nx 480
ny 320
max_recursion 2
aasample 4
background 0.55 0.70 0.86

{
    translate -0.45 -0.45 0.5
    rotate 120 1 -1 0
    arealight 0.05   0.80 0.74 0.62
}
pointlight 0.3 0.1 0.5   0.26 0.28 0.34

{
    ca 0.26 0.27 0.28
    cr 0.60 0.64 0.56
    cp 0.16 0.16 0.15
    shininess 60
    object_flat generate:stadium:100000
}
end

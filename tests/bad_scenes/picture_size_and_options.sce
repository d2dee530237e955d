sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 60
ny 40
pointlight 2 -3 5  1 1 1
nx 0
ny -4
nx 65536
ny 40.5
max_recursion -1
max_recursion 5000
aasample 0.5
aasample 257
ball 1 0 0 0
end

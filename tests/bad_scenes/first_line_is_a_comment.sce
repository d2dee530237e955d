# my scene
sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 60
ny 40
pointlight 2 -3 5  1 1 1
ball 1 0 0 0
end

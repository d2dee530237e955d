sce1.0
eyepos 0 0 0
eyedri 0 1 0
wdist x
nx 10
ball 1 0 0 0
pointlight 2 -3 5  1 1 1
end

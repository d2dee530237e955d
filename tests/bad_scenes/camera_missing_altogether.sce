sce1.0
ball 1 0 0 0
pointlight 2 -3 5  1 1 1

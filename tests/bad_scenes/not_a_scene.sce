# made by a modeller
v 0 0 0
v 1 0 0
f 1 2 3

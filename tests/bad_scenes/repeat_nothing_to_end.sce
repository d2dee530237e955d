sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 4
ny 3
pointlight 0 0 5  1 1 1
ball 1 0 0 0
end_repeat
repeat x
  ball 1 0 0 0
end_repeat
repeat 0
  ball 1 0 0 0
end_repeat
repeat
  ball 1 0 0 0
end_repeat
for 3
  ball 1 0 0 0
end_repeat

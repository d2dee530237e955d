sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 4
ny 3
pointlight 0 0 5  1 1 1
repeat 2
  repeat 3
    ball 1 0 0 0
  end_repeat
  repeat 4
    ball 1 0 0 0
end

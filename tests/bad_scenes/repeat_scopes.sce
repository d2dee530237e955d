sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 4
ny 3
pointlight 0 0 5  1 1 1
{
push_matrix
repeat 3
  }
  pop_matrix
  {
    ball 1 0 0 0
  push_matrix
end_repeat
pop_matrix
}
repeat 5
  ball 1 0 0 0
  scale 1e-30 1 1
end_repeat

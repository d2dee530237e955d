sce1.0
eyepos 0 -5 2
eyedir 0 5 -2
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 48
ny 32
scatter bals:10
scatter trees:10:1
scatter balls:0
scatter city:17M
scatter knots:10:one
scatter mixed
scatter balls 10 1
at 0 scatter balls:10
{
  scale 2e-38 2e-38 2e-38
  scatter city:5
}
repeat 2000
  scatter balls:10k
end_repeat
pointlight 0 0 5 1 1 1
end

sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
nx 9
ny 9
repeat 3
    at -10 scale 1 1 1      # in frame 0 it is flat
    to 10 scale 1 -1 1
    ball 1 0 0 0
end_repeat
at -1 rotate 9 0 0 1
to 1 rotate 9 0 0 -1
pointlight 0 0 9 1 1 1
end

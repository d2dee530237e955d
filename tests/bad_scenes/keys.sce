sce1.0
eyepos 0 -5 1
eyedir 0 1 0
eyeup 0 0 1
wdist 1
fovy_deg 40
at 0 nx 9
ny 9
to 5 rotate 9 0 0 1
at 0 rotate 0 0 0 1
to 30 rotate 90 0 0 1

to 20 rotate 45 0 0 1      # too early
to 40 rotate 45 0 0 1
at 0 translate 0 0 0
to 9 rotate 1 0 0 1
at
at 5
at x ball 1 0 0
at 0 balll 1 0 0 0
to 5 ball 1 0 0 0
at 0 object_flat a.obj
at 0 {
at 0 at 5 ball 1 0 0 0
at 0 repeat 3
at 0 delay 5
every 0
explode -1
end

// The picture of balls.sce. POV-Ray's "specular" is the highlight of Blinn and Phong, its roughness
// the reciprocal of the exponent.
#version 3.7;
global_settings { max_trace_level 6 assumed_gamma 1.0 }
background { rgb <.2, .3, .5> }
camera {
  location <0, -7, 3>
  right -2*x up z sky z
  angle 2*degrees(atan2(2*tan(radians(20)), 1))
  look_at <0, 0, .8>
}
light_source { <-3, -3, 6> rgb .9 area_light <2, 0, 0>, <0, 2, 0>, 4, 4 jitter }
#declare Floor = texture { pigment { rgb <.8, .8, .7> } finish { ambient .1 diffuse 1 } }
#declare Mirror = texture {
  pigment { rgb .2 }
  finish { ambient .1 diffuse 1 reflection .6 specular .6 roughness 1/50 }
}
triangle { <-6, -6, 0>, <6, -6, 0>, <6, 6, 0> texture { Floor } }
triangle { <-6, -6, 0>, <6, 6, 0>, <-6, 6, 0> texture { Floor } }
sphere { <-1.2, 0, 1>, 1 texture { Mirror } }
#ifdef (MeshFile)
  #include MeshFile
  object { Knot scale 1.6 translate <1.2, 0, 1.2> texture { Floor } }
#else
  sphere { <1.2, 0, 1>, 1 texture { Mirror } }
#end

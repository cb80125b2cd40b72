#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <-1.2, 1, 0>, 0.9 pigment { rgbf <0.9, 0.2, 0.1, 0.8> } }
box { <0.2, 0.3, -0.5>, <1.6, 1.7, 0.2> pigment { rgbt <0.1, 0.6, 0.9, 0.5> } }
sphere { <2.6, 0.7, 0>, 0.6 pigment { checker rgbf <1, 0.9, 0.1, 0.9> rgb <0.1, 0.2, 0.6> scale 0.3 } no_shadow }
cylinder { <0, 0, 2>, <0, 2, 2>, 0.4 pigment { gradient y color_map { [0 rgb 1] [1 rgbt <1, 1, 1, 1>] } scale 2 } }

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
box { <-3, 0, 1.5>, <3, 3, 1.6> pigment { rgb <0.05, 0.1, 0.05> } finish { reflection 0.85 } }
box { <-3, 0, -7.6>, <3, 4, -7.5> pigment { rgb <0.1, 0.05, 0.05> } finish { reflection 0.85 } }
sphere { <-0.8, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.3, 0.2> } finish { reflection 0.3 } }
sphere { <1, 0.5, -0.5>, 0.5 pigment { rgbt <0.3, 0.5, 0.9, 0.6> } interior { ior 1.2 } no_image }
sphere { <2, 0.5, -0.5>, 0.5 pigment { rgb <0.9, 0.9, 0.1> } no_reflection }

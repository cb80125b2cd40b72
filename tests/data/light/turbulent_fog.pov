#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
fog { fog_type 2 distance 3 color rgb <0.9, 0.9, 0.9> fog_offset 0.5 fog_alt 0.8 turbulence <1.5, 0.8, 1.2> turb_depth 0.7 octaves 4 omega 0.6 lambda 2.3 }
fog { distance 20 color rgb <0.2, 0.3, 0.6> turbulence 0.4 }
sphere { <-1.2, 1, 0>, 1 pigment { rgb <0.8, 0.5, 0.1> } }
cylinder { <1.5, 0, 1>, <1.5, 2.5, 1>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } }

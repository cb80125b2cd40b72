#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
fog { distance 9 color rgbft <0.7, 0.75, 0.8, 0.3, 0.1> }
sphere { <-1.2, 1, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.7 } }
sphere { <1.2, 1, 0>, 1 hollow pigment { rgbt <1, 0.7, 0.7, 0.7> } finish { ambient 0 } interior { ior 1.3 } }
sphere { <3, 1, 5>, 1 pigment { rgbt <0.7, 0.7, 1, 0.8> } finish { ambient 0 } }

#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <-1.2, 1, 0>, 1 pigment { rgb 0.1 } normal { bumps 0.6 scale 0.2 } finish { reflection 0.8 } }
box { <0.4, 0, -0.6>, <1.9, 1.8, 0.6> pigment { rgbt 0.9 } normal { ripples 0.3 scale 0.5 } finish { reflection 0.2 } interior { ior 1.3 } }

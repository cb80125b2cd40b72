#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <-1, 1, 0>, 0.9 pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { ior 1.5 caustics 0.7 } }
sphere { <1.2, 1, 0>, 0.9 pigment { rgbf <1, 0.8, 0.6, 0.9> } finish { ambient 0 diffuse 0.1 } interior { caustics 0.2 fade_distance 2 fade_power 1 } }

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <0, 1.2, 0>, 1.2 pigment { rgbt 0.95 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } } interior { ior 1.33 } }
sphere { <0.2, 1.2, 0>, 0.6 pigment { rgbf <1, 0.8, 0.6, 0.9> } finish { ambient 0 diffuse 0.2 } interior { ior 1 } }
difference { box { <1.4, 0, -0.5>, <2.6, 1.4, 0.5> } sphere { <2, 1.2, 0>, 0.4 } pigment { rgbf <0.7, 1, 0.8, 0.8> } interior { ior 1.4 } }
merge { sphere { <-2, 0.6, 0>, 0.6 } cylinder { <-2, 0, 0>, <-2, 1.8, 0>, 0.3 } material { texture { pigment { rgbf <0.8, 0.8, 1, 0.9> } } interior { ior 1.3 fade_distance 1 fade_power 2 } } }

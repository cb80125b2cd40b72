#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
#macro Block(X, Power) box { <-0.55, 0, -0.7>, <0.55, 1.8, 0.7> rotate y*25 translate x*X pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { ior 1.2 fade_distance 0.8 fade_power Power fade_color rgb <0.9, 0.5, 0.2> } } #end
Block(-1.7, 1) Block(0, 2) Block(1.7, 1001)

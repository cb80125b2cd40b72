#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
prism { 0, 2, 4, <-1.5, -1>, <1.5, -1>, <0, 0.5>, <-1.5, -1> translate <0, 0.2, 0.4>
  pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { ior 1.6 } rotate y*10 }
sphere { <0, 1, 3>, 1 pigment { rgb <0.8, 0.2, 0.2> } }

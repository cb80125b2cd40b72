#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
#declare Glass = material {
  texture { pigment { rgbf <0.95, 1, 0.97, 0.95> } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy specular 0.4 roughness 0.01 } }
  interior { ior 1.5 } }
sphere { <-1.1, 1, 0>, 1 material { Glass } }
box { <0.4, 0, -0.6>, <1.8, 1.6, 0.6> material { Glass } rotate y*20 }

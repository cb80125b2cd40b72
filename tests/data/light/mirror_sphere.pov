#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.3, 0.1, 0.1> } finish { reflection { 0.1, 0.8 falloff 2 } phong 0.5 } }
box { <-2.6, 0, -0.5>, <-1.4, 1.5, 1> pigment { rgb <0.9, 0.6, 0.1> } finish { reflection rgb <0.2, 0.3, 0.5> } }
isosurface { function { sqrt(x*x + y*y + z*z) - 0.8 } contained_by { box { -1, 1 } } max_gradient 1.1
  translate <2, 0.8, 0> pigment { rgb 0.1 } finish { reflection 0.7 } }

#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
sphere { <-1, 1, 0>, 1
  texture { pigment { rgbf <0.9, 0.9, 1, 0.7> } finish { reflection 0.2 } }
  texture { pigment { bozo color_map { [0.4 rgbt <1, 0.3, 0.2, 1>] [0.6 rgbft <1, 0.3, 0.2, 0.3, 0.2>] } scale 0.4 } finish { phong 0.6 reflection 0.1 } } }
box { <0.4, 0, -0.6>, <1.9, 1.8, 0.6>
  texture { gradient x texture_map { [0.4 pigment { rgbt <1, 1, 0.6, 0.8> } finish { reflection { 0.1, 0.5 } conserve_energy }] [0.6 pigment { rgb <0.2, 0.6, 0.3> }] } scale 0.7 } }

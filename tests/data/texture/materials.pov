// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { rgb <0.9, 0.8, 0.6> } finish { ambient 0.1 diffuse 0.8 } }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 50 }
light_source { <6, 9, -8> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
#declare Bright = texture { pigment { rgb <1, 0.3, 0.2> } }
#declare Wavy = texture { pigment { rgb <0.3, 0.7, 1> } normal { ripples 0.6 scale 0.2 } rotate 40*x }
#declare Glow = finish { ambient 0.6 phong 1 }
#declare Striped = texture { gradient x texture_map { [0.4 Bright] [0.6 Wavy] } rotate 20*z scale 0.4 }
// Materials are moved whole, maps with their patterns.
sphere { 0, 1 texture { Striped scale 0.8 } translate <-3, 1, 0> }
sphere { 0, 1 texture { Striped rotate 60*y } translate <-3, -1, 0> }
sphere { 0, 1 material { texture { pigment { checker rgb 1, rgb <0.1, 0.4, 0.1> } normal { bumps 0.4 scale 0.1 } }
  interior { ior 1.3 } scale 0.4 rotate 30*z } translate <-1, 1, 0> }
// The normal keeps what moved it when another one is laid upon its texture.
sphere { 0, 1 texture { Wavy Glow normal { scale 0.5 } } translate <-1, -1, 0> }
sphere { 0, 0.3 texture { pigment { rgb <0.8, 0.8, 0.3> } normal { bumps 1 scale 0.1 } no_bump_scale } scale 3 translate <1, 1, 0> }
sphere { 0, 1 texture { Bright } interior_texture { pigment { rgb <0.2, 1, 0.4> } }
  interior_texture { pigment { checker rgbt <1, 1, 1, 1>, rgb <0.2, 0.2, 0.8> scale 0.4 } }
  clipped_by { plane { <0, 1, -1>, 0.2 } } translate <1, -1.2, 0> }
mesh { triangle { <2, 0, 0>, <4, 0, 0>, <3, 2, 0> texture_list { Bright, Wavy, Striped } }
  triangle { <2, -0.2, 0>, <4, -0.2, 0>, <3, -2, 0> texture { Bright } } }

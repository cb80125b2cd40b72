// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// `uv_mapping` of the shapes that have places of their own, and of some that have not.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
#declare Laid = pigment { uv_mapping image_map { png "image.png" } scale <0.5, 0.5, 1> }
sphere { 0, 0.95 pigment { Laid } rotate <20, 30, 0> Place() }
box { -0.7, <0.7, 0.9, 0.7> pigment { uv_mapping checker rgb 1, rgb <0.8, 0.2, 0.1> scale 1/12 } rotate <-30, 35, 0> Place() }
torus { 0.65, 0.28 pigment { Laid scale 0.5 } rotate -50*x Place() }
lathe { linear_spline 4, <0.9, -0.9>, <0.5, 0>, <0.7, 0.5>, <0.1, 0.9> pigment { Laid } rotate <-20, 40, 0> Place() }
lathe { bezier_spline 4, <0.9, -0.9>, <0.5, -0.2>, <0.9, 0.5>, <0.1, 0.9> texture { uv_mapping pigment { bozo color_map { Map } scale 0.1 } } rotate -20*x Place() }
sor { 6, <0.9, -1>, <0.9, -0.8>, <0.4, 0>, <0.6, 0.5>, <0.3, 0.8>, <0.1, 0.9> pigment { Laid } rotate <-40, 40, 0> Place() }
mesh { triangle { <-0.9, -0.8, 0>, <0.9, -0.8, 0>, <0, 0.8, -0.3> uv_vectors <0, 0>, <1, 0>, <0.5, 1> }
  triangle { <-0.9, -0.8, 0>, <0, 0.8, -0.3>, <-0.9, 0.8, 0.4> uv_vectors <0, 0>, <0.5, 1>, <0, 1> } pigment { Laid } Place() }
mesh2 { vertex_vectors { 4, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <0.9, 0.9, 0>, <-0.9, 0.9, 0.3> } uv_vectors { 4, <0, 0>, <2, 0>, <1, 1>, <0, 1.5> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> } pigment { Laid } rotate 20*y Place() }
bicubic_patch { type 1 flatness 0 u_steps 5 v_steps 5 <-0.9, -0.9, 0>, <-0.3, -0.9, -0.8>, <0.3, -0.9, 0>, <0.9, -0.9, 0>, <-0.9, -0.3, 0>, <-0.3, -0.3, 0>, <0.3, -0.3, 0.9>, <0.9, -0.3, 0>,
  <-0.9, 0.3, 0>, <-0.3, 0.3, -0.7>, <0.3, 0.3, 0>, <0.9, 0.3, 0>, <-0.9, 0.9, 0>, <-0.3, 0.9, 0>, <0.3, 0.9, -0.4>, <0.9, 0.9, 0> pigment { Laid } Place() }
union { sphere { <-0.4, 0, 0>, 0.5 } box { <0, -0.5, -0.4>, <0.8, 0.5, 0.4> rotate 30*y } pigment { Laid } Place() }
difference { sphere { 0, 0.9 } cylinder { -z, z, 0.4 } pigment { Laid } rotate 30*y Place() }
sphere { 0, 0.6 uv_mapping texture { pigment { wood color_map { Map } scale 0.2 } scale 0.7 } scale <1.5, 1, 1> Place() }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Textures of parts: components of blobs, faces of meshes, insides.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
#declare T1 = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 0.8 } }
#declare T2 = texture { pigment { checker rgb 1, rgb <0.1, 0.3, 0.8> scale 0.2 } }
#declare T3 = texture { pigment { granite color_map { Map } scale 0.4 } }
blob { threshold 0.4 sphere { <-0.4, 0, 0>, 0.8, 1 texture { T1 } } sphere { <0.4, 0.2, 0>, 0.8, 1 texture { T2 } } cylinder { <-0.5, -0.5, 0>, <0.5, -0.5, 0>, 0.5, 1 } texture { T3 } Place() }
blob { threshold 0.4 sphere { <-0.3, 0, 0>, 0.8, 1.4 pigment { rgb <1, 1, 0> } rotate 30*z } sphere { <0.3, 0, 0>, 0.8, 1 texture { T2 } scale <1, 1.2, 1> } pigment { rgb <0, 0.6, 0.5> } rotate 20*y Place() }
mesh { triangle { <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <0.9, 0.9, 0> texture { T1 } } triangle { <-0.9, -0.9, 0>, <0.9, 0.9, 0>, <-0.9, 0.9, 0> } texture { T2 } rotate 30*y Place() }
mesh2 { vertex_vectors { 4, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <0.9, 0.9, 0>, <-0.9, 0.9, 0> } texture_list { 3, texture { T1 } texture { T2 } texture { T3 } } face_indices { 2, <0, 1, 2>, 0, 1, 2, <0, 2, 3>, 1 } scale 0.9 Place() }
mesh2 { vertex_vectors { 4, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <0.9, 0.9, 0.5>, <-0.9, 0.9, 0> } normal_vectors { 4, <-1, -1, -3>, <1, -1, -3>, <1, 1, -3>, <-1, 1, -3> } texture_list { 2, texture { T1 } texture { T3 } } face_indices { 2, <0, 1, 2>, 0, 1, 1, <0, 2, 3>, 0 } Place() }
difference { sphere { 0, 0.95 } plane { z, -0.4 } hollow texture { T1 } interior_texture { T2 } Place() }
sphere { 0, 0.95 clipped_by { plane { -z, 0.1 rotate 30*x } } material { texture { T3 } interior_texture { T1 } } Place() }
union { sphere { -0.4*x, 0.6 } cylinder { <0.4, -0.7, 0>, <0.4, 0.7, 0>, 0.4 open } interior_texture { T1 } texture { T2 } clipped_by { plane { -z, 0.1 } } Place() }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Normals by images, textures by images, checkers of textures.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
sphere { 0, 0.95 pigment { rgb 0.8 } normal { bump_map { png "gray.png" bump_size 1 } } Place() }
sphere { 0, 0.95 pigment { rgb 0.8 } normal { bump_map { png "gray.png" bump_size 3 interpolate 2 } scale 0.5 } Place() }
sphere { 0, 0.95 pigment { rgb 0.8 } normal { bump_map { png "image.png" bump_size -2 interpolate 2 } rotate 40*y } Place() }
sphere { 0, 0.95 pigment { rgb 0.8 } finish { phong 1 } normal { bump_map { png "gray.png" map_type 1 bump_size 2 interpolate 2 } } Place() }
sphere { 0, 0.95 texture { material_map { png "palette.png" texture { pigment { rgb <1, 0, 0> } } texture { pigment { granite scale 0.3 } } texture { pigment { rgb <0, 0, 1> } finish { phong 1 } } } } Place() }
sphere { 0, 0.95 texture { material_map { png "palette.png" texture { pigment { rgb <1, 0, 0> } } texture { pigment { rgb <0, 1, 0> } } texture { pigment { rgb <0, 0, 1> } } texture { pigment { rgb <1, 1, 0> } } texture { pigment { rgb <0, 1, 1> } } texture { pigment { rgb <1, 0, 1> } } } scale 2 } Place() }
sphere { 0, 0.95 texture { tiles { texture { pigment { rgb <0.9, 0.8, 0.2> } finish { phong 1 } } tile2 texture { pigment { wood scale 0.2 } } } scale 0.4 } Place() }
sphere { 0, 0.95 pigment { rgb 0.8 } normal { gradient x normal_map { [0.3 bump_map { png "gray.png" bump_size 2 }] [0.7 bumps 0.3] } } Place() }

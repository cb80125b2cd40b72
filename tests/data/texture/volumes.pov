// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Patterns of files and objects.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
sphere { 0, 0.95 pigment { density_file df3 "density.df3" interpolate 0 color_map { Map } scale 1.8 translate -0.9 } Place() }
sphere { 0, 0.95 pigment { density_file df3 "density.df3" interpolate 1 color_map { Map } scale 1.8 translate -0.9 } Place() }
sphere { 0, 0.95 pigment { density_file df3 "density.df3" interpolate 2 color_map { Map } scale 1.8 translate -0.9 } Place() }
sphere { 0, 0.95 pigment { density_file df3 "density.df3" interpolate 1 turbulence 0.2 color_map { Map } scale 1.8 translate -0.9 } Place() }
sphere { 0, 0.95 pigment { object { torus { 0.7, 0.25 rotate 60*x } pigment { rgb <0.2, 0.3, 0.8> }, pigment { rgb <1, 0.7, 0.2> } } } Place() }
sphere { 0, 0.95 pigment { object { text { ttf "cyrvetic.ttf", "Ab", 2, 0 translate <-0.5, -0.3, -1> } rgb 1, rgb <0.7, 0, 0> } } Place() }
sphere { 0, 0.95 texture { object { union { cylinder { -2*z, 2*z, 0.4 } box { <-2, -0.1, -2>, <2, 0.1, 2> } } texture { pigment { granite } } texture { pigment { rgb <0, 0.7, 0.3> } finish { phong 1 } } } } Place() }
sphere { 0, 0.95 pigment { object { isosurface { function { x*x + y*y*y - 0.2 } contained_by { box { -1.5, 1.5 } } max_gradient 8 } rgb 0.9, rgb <0.1, 0.5, 0.6> } } Place() }

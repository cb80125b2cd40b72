// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Images as patterns, inside maps, and how they are read.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
sphere { 0, 0.95 pigment { image_pattern { png "image.png" } color_map { Map } } Place() }
sphere { 0, 0.95 pigment { image_pattern { png "gray.png" interpolate 2 } color_map { Map } scale 0.7 } Place() }
sphere { 0, 0.95 pigment { checker pigment { image_map { png "image.png" } scale 0.2 } pigment { rgb 0.8 } scale 0.5 } Place() }
sphere { 0, 0.95 pigment { gradient y pigment_map { [0.2 image_map { png "image.png" } scale 0.5] [0.8 granite] } } Place() }
sphere { 0, 0.95 pigment { image_map { png "gray.png" interpolate 3 } } Place() }
sphere { 0, 0.95 pigment { image_map { png "gray.png" interpolate 4 } } Place() }
sphere { 0, 0.95 pigment { image_map { png "image.png" gamma 1 } } Place() }
sphere { 0, 0.95 pigment { image_map { png "image.png" gamma 2.2 map_type 1 } } Place() }
sphere { 0, 0.95 texture { pigment { rgb <0.2, 0.6, 0.3> } } texture { pigment { image_map { png "palette.png" transmit 1, 0.7 filter 2, 0.5 } } } Place() }
sphere { 0, 0.95 pigment { pigment_pattern { image_map { png "image.png" interpolate 2 } } color_map { Map } } Place() }
sphere { 0, 0.95 pigment { average pigment_map { [1 image_map { png "image.png" }] [2 rgb <1, 0.5, 0>] } } Place() }
#declare Grey = function { pigment { image_map { png "gray.png" interpolate 2 } } }
sphere { 0, 0.95 pigment { function { Grey(x, y, z).gray } color_map { Map } } Place() }

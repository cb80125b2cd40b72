// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Patterns that know how the surface leans.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
sphere { 0, 0.95 pigment { slope y color_map { Map } } Place() }
sphere { 0, 0.95 pigment { slope { <1, 1, 0>, 0.2, 0.9 } color_map { Map } } Place() }
sphere { 0, 0.95 pigment { slope { y, 0, 1 altitude <1, 0.5, 0>, -1, 1 } color_map { Map } scale 0.8 rotate 30*z } Place() }
sphere { 0, 0.95 pigment { slope -x sine_wave frequency 3 color_map { Map } } Place() }
sphere { 0, 0.95 pigment { aoi color_map { Map } } Place() }
sphere { 0, 0.95 pigment { aoi frequency 2 triangle_wave color_map { Map } } Place() }
sphere { 0, 0.95 pigment { slope y pigment_map { [0.3 checker scale 0.3] [0.7 aoi] } } Place() }
sphere { 0, 0.95 texture { slope { y } texture_map { [0.4 pigment { rgb <0.9, 0.2, 0.1> }] [0.6 pigment { rgb <0.1, 0.6, 0.2> } finish { phong 1 }] } } Place() }
sphere { 0, 0.95 pigment { slope y color_map { Map } } normal { bumps 0.6 scale 0.3 } Place() }
sphere { 0, 0.95 normal { slope y 0.5 normal_map { [0.3 bumps 0.8 scale 0.2] [0.6 dents 0.1] } } pigment { rgb 0.8 } Place() }
sphere { 0, 0.95 texture { pigment { slope x color_map { Map } } } texture { pigment { slope y color_map { [0.4 rgbt 1] [0.6 rgbt <1, 0, 0, 0.3>] } } } Place() }
difference { sphere { 0, 0.95 } sphere { -0.5*z, 0.8 } pigment { slope -z color_map { Map } } Place() }

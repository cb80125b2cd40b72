// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Thin films, and finishes with `albedo`.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { ambient 0 diffuse 0.5 irid { 0.4 thickness 0.3 } } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { ambient 0 diffuse 0.6 irid { 0.6 thickness 0.7 } phong 0.4 } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse albedo 0.4 brilliance 3 } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.3 phong albedo 0.05 phong_size 30 } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.3 specular albedo 0.1 roughness 0.03 } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse albedo 0.3, 0.2 brilliance 2 } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { ambient 0 diffuse 0.6 irid { 0.6 thickness 0.4 turbulence 0.5 } } Place() }
sphere { 0, 0.95 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.6 irid { 0.5 thickness 0.5 turbulence 1.5 } phong 0.3 } scale 0.5 rotate 40 scale 2 Place() }
sphere { 0, 0.95 pigment { bozo scale 0.3 } normal { bumps 0.3 scale 0.2 } finish { diffuse 0.6 irid { 0.5 thickness 0.3 turbulence -0.7 } } Place() }
sphere { 0, 0.95 texture { gradient y texture_map { [0.3 pigment { rgb 1 } finish { irid { 0.5 thickness 0.3 turbulence 1 } }] [0.7 pigment { rgb <1, 0.5, 0> } finish { diffuse 0.7 }] } } Place() }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
// Mirrors and glass whose normals are bent away from the viewer.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, 1 }
sphere { 0, 60 pigment { checker rgb 0.2 rgb <1, 0.6, 0.2> scale 15 } finish { ambient 1 diffuse 0 } hollow }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
#declare Mirror = finish { ambient 0 diffuse 0 reflection 0.8 }
#declare Glass = finish { ambient 0.2 diffuse 0 }
sphere { 0, 0.95 pigment { rgb 0.1 } normal { onion 0.744 frequency 3 } finish { Mirror } Place() }
sphere { 0, 0.95 pigment { rgb 0.1 } normal { bumps 2 scale 0.2 } finish { Mirror } Place() }
sphere { 0, 0.95 pigment { rgb 0.1 } normal { granite 1 } finish { Mirror } Place() }
sphere { 0, 0.95 pigment { rgb 0.1 } normal { facets coords 1.5 scale 3 } finish { Mirror } Place() }
sphere { 0, 0.95 pigment { rgbf <1, 0.9, 0.8, 0.8> } normal { onion 0.744 frequency 3 } finish { Glass } interior { ior 1.5 } Place() }
sphere { 0, 0.95 pigment { rgbf <1, 0.9, 0.8, 0.8> } normal { bumps 2 scale 0.4 } finish { Glass } interior { ior 1.5 } Place() }
sphere { 0, 0.95 pigment { rgbf <1, 0.9, 0.8, 0.8> } normal { onion 0.744 frequency 3 } finish { Glass } interior { ior 0.6 } Place() }
box { -0.6, 0.6 pigment { rgbf <1, 0.9, 0.8, 0.8> } normal { gradient x 1 triangle_wave scale 0.3 } finish { Glass } interior { ior 1.5 } rotate <20, 30, 0> Place() }
sphere { 0, 0.95 texture { pigment { rgb <0.7, 0.9, 0.1> } finish { ambient 0 diffuse 0 reflection 0.5 } } texture { pigment { gradient x color_map { [0 rgbf <1, 0.5, 0.2, 0>] [1 rgbf <1, 0.5, 0.2, 0.04>] } translate 0.5 } } Place() }

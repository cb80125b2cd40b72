// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Normals with flat places, of tilings, and with formulas of their own, which slope maps leave as they are.
camera { location <0, 0, -12> look_at 0 angle 52 }
light_source { <-20, 30, -40>, rgb <1, 0.8, 0.6> }
light_source { <30, -10, -20>, rgb <0.2, 0.4, 0.6> }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 5) - 4, 3 - 2*int(Count/5), 0> #declare Count = Count + 1; #end
#default { pigment { rgb 1 } finish { ambient 0 diffuse 0.6 specular 0.4 } }
sphere { 0, 0.95 normal { facets } Place() }
sphere { 0, 0.95 normal { facets size 0.4 } Place() }
sphere { 0, 0.95 normal { facets coords 0.5 } Place() }
sphere { 0, 0.95 normal { facets 0.3 coords 0.5 size 0.3 } Place() }
sphere { 0, 0.95 normal { facets size 0.3 bump_size 3 rotate 30 } Place() }
sphere { 0, 0.95 normal { facets coords 1 scale 2 } Place() }
sphere { 0, 0.95 normal { facets size 0.3 scale <1, 3, 1> } Place() }
sphere { 0, 0.95 normal { facets coords 0.5 scale <1, 3, 1> turbulence 0.2 } Place() }
sphere { 0, 0.95 normal { facets size 0.3 metric 1 } Place() }
sphere { 0, 0.95 normal { facets coords 0.4 metric 1 no_bump_scale scale 1.5 } Place() }
sphere { 0, 0.95 normal { facets size 0 } Place() }
sphere { 0, 0.95 normal { facets coords -0.5 } Place() }
box { -0.6, 0.6 normal { facets coords 0.4 scale 2 } rotate <-20, 40, 0> Place() }
box { -0.6, 0.6 normal { tiling 7 0.4 scale 0.3 rotate 90*x } rotate <-20, 40, 0> Place() }
sphere { 0, 0.95 normal { checker normal { facets size 0.2 }, normal { bumps 0.6 scale 0.1 } scale 0.5 } Place() }
torus { 0.6, 0.3 normal { facets size 0.4 } rotate -50*x scale <1, 1.4, 1> Place() }
#declare Slopes = slope_map { [0.15 <0.5, -0.5>] [0.55 <0.5, -2>] [1 <0.8, 0.7>] }
sphere { 0, 0.95 normal { bumps 0.5 slope_map { Slopes } scale 0.3 } Place() }
sphere { 0, 0.95 normal { quilted 0.5 slope_map { Slopes } scale 0.5 } Place() }
sphere { 0, 0.95 normal { wrinkles 0.5 slope_map { Slopes } scale 0.3 } Place() }
plane { -z, -4 normal { facets coords 0.6 scale 5 } }

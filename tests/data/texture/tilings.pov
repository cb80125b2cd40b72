// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// The tilings, triangles, and lists whose values fall between their entries.
camera { orthographic location <0, 10, 0> look_at 0 up 24*z right 28*x }
#declare Map = color_map { [0 rgb <0.1, 0.1, 0.5>] [0.3 rgb <0.9, 0.4, 0.1>] [0.7 rgb <0.2, 0.7, 0.3>] [1 rgb <1, 1, 0.8>] }
#default { finish { ambient 1 diffuse 0 } }
#declare Tile = box { <-1.87, -1, -1.87>, <1.87, 0, 1.87> }
#declare Count = 0;
#macro Place() translate <4*mod(Count, 7) - 12, 0, 10 - 4*int(Count/7)> #declare Count = Count + 1; #end
#for (N, 1, 27) object { Tile pigment { tiling N color_map { Map } scale 0.6 rotate 7*N*y } Place() } #end
object { Tile pigment { triangular rotate 20*y } Place() }
object { Tile pigment { triangular rgb 1 rgb 0.1 rgb <1, 0.5, 0> turbulence 0.3 } Place() }
object { Tile pigment { square rgb 1 rgb 0.1 rgb <1, 0.5, 0> rgb <0, 0.5, 1> frequency 0.7 } Place() }
object { Tile pigment { hexagon rgb 1 rgb 0.1 rgb <1, 0.5, 0> frequency 0.5 phase 0.4 } Place() }
object { Tile pigment { checker rgb 1, rgb 0.1 sine_wave } Place() }
object { Tile pigment { quilted color_map { Map } phase 0.4 } Place() }
object { Tile pigment { object { sphere { 0, 1 } rgb 1, rgb <1, 0, 0> } phase 0.4 } Place() }
object { Tile pigment { tiling 9 color_map { Map } frequency 1.5 phase 0.2 sine_wave } Place() }
object { Tile texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb <0.8, 0.2, 0> } } frequency 0.6 } Place() }
object { Tile texture { triangular texture { pigment { rgb 1 } } texture { pigment { rgb <0.8, 0.2, 0> } } } Place() }
object { Tile texture { tiling 7 texture_map { [0.2 pigment { rgb 1 }] [0.8 pigment { wood scale 0.2 }] } } Place() }
object { Tile pigment { pavement number_of_tiles 6 pattern 7 color_map { Map } scale 0.6 rotate 20*y } Place() }
object { Tile pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 12 color_map { Map } scale 0.6 } Place() }
object { Tile pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 3 color_map { Map } turbulence 0.2 scale 0.4 } Place() }
object { Tile pigment { rgb 0.5 } normal { pavement 0.7 number_of_sides 4 number_of_tiles 3 pattern 2 scale 0.6 } finish { ambient 0.1 diffuse 0.8 } Place() }
light_source { <-20, 30, 10>, 1 }

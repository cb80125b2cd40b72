// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Maps of pigments, lists, averages, functions.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { gradient x pigment_map { [0.3 rgb <0.6, 0.6, 0.2>] [0.7 checker rgb <0.5, 0.2, 0.1> rgb 1 scale 0.2] } scale 2 translate -x } })
Show(texture { pigment { average pigment_map { [1 rgb <1, 0, 0>] [2 gradient y scale 0.3] [1 bozo scale 0.2] } } })
Show(texture { pigment { checker pigment { wood scale 0.1 }, pigment { granite } scale 0.5 translate 0.01 } })
Show(texture { pigment { function { x*x + y*y - z } color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { pigment_pattern { bozo scale 0.3 color_map { [0 rgb 0] [1 rgb <1, 0.5, 0>] } } color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { gradient x scale 0.3 translate 1 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { gradient y color_map { [0.2 rgb 1] [0.2 rgb <1, 0, 0>] [0.8 rgb <0, 0, 1>] [0.8 rgb 0] } scale 0.9 } })
Show(texture { pigment { hexagon pigment { rgb 1 }, pigment { marble scale 0.1 }, pigment { rgb <0, 0.5, 0> } scale 0.3 rotate 90*x } })
Show(texture { pigment { spiral1 2 pigment_map { [0 gradient x scale 0.2] [1 onion scale 0.1] } turbulence 0.3 scale 0.5 } })
Show(texture { pigment { planar color_map { [0.0 0.5 color rgb 1 color rgb <1, 0, 0>] [0.5 1.0 color rgb <0, 0, 1> color rgb 0.5] } } })
Show(texture { pigment { color rgb <0.4, 0.7, 0.3> } })
Show(texture { pigment { bozo color_map { [0.4 rgb 1] [0.6 rgb 0] } scale 0.2 rotate 40*z translate 3 } })

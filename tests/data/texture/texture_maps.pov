// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Maps of whole textures.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
#declare Dull = texture { pigment { rgb <0.7, 0.3, 0.1> } finish { ambient 0.2 diffuse 0.5 } }
#declare Shiny = texture { pigment { bozo scale 0.1 color_map { [0.3 rgb <0.2, 0.4, 0.9>] [0.7 rgb 1] } } finish { phong 1 phong_size 60 } }
#declare Rough = texture { pigment { rgb <0.3, 0.7, 0.3> } normal { bumps 0.8 scale 0.1 } finish { specular 0.5 } }
Show(texture { gradient x texture_map { [0.3 Dull] [0.7 Shiny] } scale 2 translate -x })
Show(texture { checker texture { Dull } texture { Rough } scale 0.5 translate 0.01 })
Show(texture { bozo turbulence 0.5 texture_map { [0.4 Dull] [0.4 Shiny] [0.6 Rough] } scale 0.4 })
Show(texture { average texture_map { [1 Dull] [2 Shiny] [1 Rough] } })
Show(texture { hexagon texture { Dull } texture { Shiny } texture { Rough } scale 0.3 rotate 70*x })
Show(texture { marble turbulence 0.4 texture_map { [0 Shiny scale 3] [0.5 pigment { gradient y scale 0.2 }] [1 Rough] } scale 0.5 rotate 30*z })
Show(texture { gradient y texture_map { [0.2 gradient x texture_map { [0.5 Dull] [0.5 Rough] } scale 0.3] [0.8 Shiny] } })
Show(texture { brick texture { Dull } texture { Rough } scale 0.1 })

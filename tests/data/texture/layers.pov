// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Layers: what is transparent in one shows the next.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
#declare Ground = texture { pigment { granite color_map { [0 rgb <0.3, 0.2, 0.1>] [1 rgb <0.9, 0.8, 0.5>] } } }
#declare Veins = texture { pigment { marble turbulence 0.7 color_map { [0 rgbt 1] [0.7 rgbt <0.3, 0.5, 0.9, 0.6>] [1 rgb <0.1, 0.1, 0.4>] } scale 0.4 } finish { phong 0.7 } }
#declare Tint = texture { pigment { gradient y color_map { [0 rgbf <1, 0.3, 0.3, 0.9>] [1 rgbf <0.3, 1, 0.3, 0.7>] } } }
#declare Both = texture { Ground } texture { Veins }
#declare All = texture { Both } texture { Tint scale 0.6 }
#macro Ball() sphere { 0, 0.95 translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
Ball() texture { Ground } texture { Veins } }
Ball() texture { Both } }
Ball() texture { All } }
Ball() texture { Ground } texture { Tint } }
Ball() texture { Both scale 0.5 } }
Ball() texture { Both } rotate 40*z translate 0 }
Ball() texture { pigment { rgb <0.9, 0.7, 0.2> } normal { bumps 0.7 scale 0.1 } } texture { Veins finish { diffuse 0.3 ambient 0.4 } } }
Ball() texture { Ground } texture { pigment { checker rgbt 1, rgb <0.7, 0, 0> scale 0.3 translate 0.01 } finish { specular 0.8 roughness 0.02 } } }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Textures of the library that comes with POV-Ray.
#include "colors.inc"
#include "textures.inc"
#include "woods.inc"
#include "stones.inc"
#include "metals.inc"
#include "golds.inc"
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { T_Wood3 scale 0.5 })
Show(texture { T_Wood10 })
Show(texture { T_Wood24 rotate 80*x })
Show(texture { DMFWood4 })
Show(texture { T_Stone8 })
Show(texture { T_Stone25 scale 0.3 })
Show(texture { T_Grnt9 })
Show(texture { White_Marble scale 0.5 })
Show(texture { Blood_Marble })
Show(texture { Jade scale 0.4 })
Show(texture { Cork scale 0.2 })
Show(texture { PinkAlabaster scale 0.6 })

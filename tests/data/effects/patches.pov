// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Patches as parts of solids: they have neither inside nor outside. Bicubic ones are not clipped.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, 1 }
background { rgb <0.1, 0.15, 0.3> }
#default { pigment { rgb <0.9, 0.8, 0.6> } finish { ambient 0.1 diffuse 0.7 } }
#declare Count = 0;
#macro Place() scale 0.8 translate <2*mod(Count, 4) - 3, 3 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
#declare Faces = mesh { triangle { <-1, -1, 0>, <1, -1, 0.2>, <0, 1, -0.2> } triangle { <-1, 0, 0.5>, <0.3, 1, -0.5>, <1, 0.5, 0> } pigment { rgb <1, 0.3, 0.2> } }
#declare Flat = polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> rotate <20, 30, 0> pigment { rgb <0.2, 0.3, 1> } }
#declare Curved = bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3 <-1,-1,0>, <-.3,-1,.5>, <.3,-1,-.5>, <1,-1,0>, <-1,-.3,.3>, <-.3,-.3,.5>, <.3,-.3,-.5>, <1,-.3,0>, <-1,.3,.2>, <-.3,.3,.5>, <.3,.3,-.5>, <1,.3,0>, <-1,1,0>, <-.3,1,.5>, <.3,1,-.5>, <1,1,0> pigment { rgb <0.3, 0.9, 0.2> } }
#declare Ball = sphere { <0.2, 0.1, -0.2>, 0.7 }
merge { object { Faces } object { Ball } Place() }
difference { object { Ball } object { Faces } Place() }
intersection { object { Ball } object { Faces } Place() }
difference { object { Faces } object { Ball } Place() }
merge { object { Faces inverse } object { Ball } Place() }
intersection { object { Ball } object { Faces inverse } Place() }
difference { object { Ball } union { box { 0, 1 } object { Flat } } Place() }
merge { object { Curved inverse } object { Ball } Place() }
object { Curved clipped_by { plane { x + y, 0.1 } } Place() }
union { object { Curved } object { Ball } clipped_by { plane { x + y, 0.1 } } Place() }
object { Flat clipped_by { plane { x + y, 0.1 } } Place() }
object { Faces clipped_by { plane { x + y, 0.1 } } Place() }
difference { object { Curved } object { Ball } Place() }

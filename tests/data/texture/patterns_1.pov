// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Patterns with the colours they have when nothing is said.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { agate scale 0.7 } })
Show(texture { pigment { boxed } })
Show(texture { pigment { bozo scale 0.4 } })
Show(texture { pigment { brick scale 0.15 } })
Show(texture { pigment { bumps scale 0.3 } })
Show(texture { pigment { cells scale 0.3 } })
Show(texture { pigment { checker rgb 1, rgb 0.2 scale 0.4 translate 0.013 } })
Show(texture { pigment { crackle scale 0.4 } })
Show(texture { pigment { cylindrical } })
Show(texture { pigment { dents scale 0.3 } })
Show(texture { pigment { gradient <1, 2, 0> scale 0.5 } })
Show(texture { pigment { granite } })

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Fractals, tilings and crackle with settings.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { cubic rgb 1, rgb 0, rgb <1, 0, 0>, rgb <0, 1, 0>, rgb <0, 0, 1>, rgb 0.5 rotate 20 } })
Show(texture { pigment { mandel 30 scale 0.6 } })
Show(texture { pigment { julia <0.353, 0.288>, 30 scale 0.6 } })
Show(texture { pigment { magnet 1 mandel 20 scale 0.3 } })
Show(texture { pigment { spiral2 3 scale 0.4 } })
Show(texture { pigment { spotted scale 0.2 } })
Show(texture { pigment { wrinkles scale 0.3 } })
Show(texture { pigment { square rgb 1, rgb 0, rgb <1, 0, 0>, rgb <0, 1, 0> scale 0.4 } })
Show(texture { pigment { magnet 2 julia <0.3, 0.2>, 20 scale 0.4 } })
Show(texture { pigment { brick rgb 1, rgb <0.7, 0.2, 0.1> brick_size <0.6, 0.3, 0.4> mortar 0.05 } })
Show(texture { pigment { crackle form <1, 0, 0> metric 1 scale 0.4 } })
Show(texture { pigment { crackle solid scale 0.3 } })

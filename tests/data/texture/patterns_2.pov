// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// The other patterns.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { hexagon rgb 1, rgb 0.5, rgb <1, 0, 0> scale 0.4 rotate 30*x } })
Show(texture { pigment { leopard scale 0.15 } })
Show(texture { pigment { marble scale 0.4 } })
Show(texture { pigment { onion scale 0.4 } })
Show(texture { pigment { planar } })
Show(texture { pigment { quilted scale 0.4 } })
Show(texture { pigment { radial frequency 6 } })
Show(texture { pigment { ripples scale 0.2 } })
Show(texture { pigment { spherical scale 2 } })
Show(texture { pigment { spiral1 3 scale 0.4 } })
Show(texture { pigment { waves scale 0.3 } })
Show(texture { pigment { wood scale 0.3 } })

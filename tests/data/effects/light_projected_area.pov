// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Areas of light that come through a disc; what lies behind it casts no shadow, whatever the kind of the light.
camera { location <1, 3, -7> look_at 0 angle 50 }
#macro Lit(Place, Light)
  light_group {
    light_source { Light }
    box { <-1.4, -1.2, -2>, <1.4, -1.03, 2> pigment { rgb 0.8 } translate Place }
    cone { 0, 0.5, y, 0.1 pigment { rgb <1, 0.5, 0.3> } translate Place }
    sphere { <0.7, 0, 0>, 0.3 pigment { rgb <0.3, 0.5, 1> } translate Place }
    global_lights off
  }
#end
Lit(-1.5*x, light_source { <-6, 5, -3>, 1 area_light 2*x, 2*y, 3, 3 projected_through { disc { -1.5*x - 0.2*y, y, 1 } } })
Lit(1.5*x, light_source { <6, 5, -3>, 1 area_light 2*x, 2*y, 2, 2 shadowless projected_through { disc { 1.5*x - 0.2*y, y, 1 } } })

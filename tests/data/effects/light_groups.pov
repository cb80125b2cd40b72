// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Lights that reach some objects only, shadows of all the others included.
camera { location <0, 4, -9> right x*4/3 up y look_at <0, 0.5, 0> angle 45 }
light_source { <-5, 8, -6>, rgb 0.6 }
light_group {
    light_source { <6, 6, -4>, rgb <1, 0.3, 0.2> }
    sphere { <-1.5, 1, 0>, 0.9 pigment { rgb 1 } }
    box { <-3.4, 0, -0.4>, <-2.6, 1.5, 0.4> texture { pigment { granite } finish { phong 0.5 } } }
    global_lights off
}
light_group {
    light_source { <0, 7, -4>, rgb <0.2, 0.5, 0.9> }
    union { sphere { <1, 0.7, -0.5>, 0.7 } cylinder { <2.5, 0, 0>, <2.5, 1.6, 0>, 0.5 } pigment { rgb 1 } }
    light_group { light_source { <8, 3, -2>, rgb <0.3, 0.9, 0.3> } cone { <0.2, 0, 1.5>, 0.8, <0.2, 2, 1.5>, 0 pigment { rgb 1 } } }
    global_lights
}
plane { y, 0 pigment { checker rgb 0.9, rgb <0.4, 0.5, 0.7> } }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> right x*4/3 up y look_at <0, 0.5, 0> angle 45 }
light_source { <4, 8, -5>, rgb 0.8 }
light_source { <-4, 3, -5>, rgb <0.3, 0.2, 0.1> }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.5> } finish { crand 0.05 } }
sphere { <-0.5, 0.5, -1>, 0.9 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 crand 0.04 brilliance 2 } }

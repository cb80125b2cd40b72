// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> right x*4/3 up y look_at <0, 0.5, 0> angle 45 }
light_source { <1, 3, -1>, rgb 0.9 area_light 4*x, 3*z, 5, 4 area_illumination on fade_distance 4 fade_power 2 }
sphere { <-0.8, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.6 } }
box { <0.6, 0, -0.4>, <1.4, 1.1, 0.4> pigment { rgb 0.8 } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.4, 0.5, 0.7> } }

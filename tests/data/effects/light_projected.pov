// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Light that comes through an object only, and lights of both sides.
camera { location <0, 5, -9> right x*4/3 up y look_at <0, 0.5, 0> angle 45 }
light_source { <0, 9, -2>, rgb 1 projected_through { union { box { <-0.8, 5, -2>, <0.8, 5.1, -0.6> } sphere { <1.2, 5, 0.2>, 0.4 } } } }
sphere { <0.2, 7, -1.5>, 0.3 pigment { rgb 1 } }
sphere { <-0.8, 1, -0.5>, 0.6 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.6 } }
light_source { <5, 3, 8>, rgb 0.7 }
disc { <2.5, 1, 0>, <-0.2, 0.3, -1>, 0.8 pigment { rgb <0.3, 0.8, 0.4> } double_illuminate }
union { triangle { <-3.5, 0, 0>, <-1.5, 0, 0.5>, <-2.5, 2, 0> } disc { <-3.5, 1.5, 0>, <0.2, 0, -1>, 0.4 } double_illuminate texture { pigment { granite } } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.4, 0.5, 0.7> } }

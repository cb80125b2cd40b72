// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    location <0, 2, -6> right x*4/3 up y look_at <0, 0.5, 0> angle 45
    aperture 1.2 blur_samples 120 focal_point <-0.5, 0.5, -1> confidence 0.95 variance 1/200
}
light_source { <4, 8, -5>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.5> } }
sphere { <-0.5, 0.5, -1>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.5 } }
box { <1, 0, 2>, <2, 1.5, 3> pigment { rgb <0.3, 0.7, 0.3> } }
cylinder { <-1.4, 0, -3>, <-1.4, 1.2, -3>, 0.15 pigment { rgb <0.9, 0.8, 0.2> } }
background { rgb <0.4, 0.6, 0.9> }

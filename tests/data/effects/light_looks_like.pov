// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> right x*4/3 up y look_at <0, 0.5, 0> angle 45 }
#declare Bulb = sphere { 0, 0.4 pigment { rgb <1, 0.9, 0.4> } finish { ambient 1 diffuse 0 } }
light_source { <0, 1, 1>, rgb 0.6 looks_like { Bulb } translate <1, 0.5, -1> media_interaction off }
union {
    light_source { <-1, 2, 0>, rgb 0.4 looks_like { box { -0.2, 0.2 pigment { rgb <0.3, 0.9, 1> } finish { ambient 1 } } } }
    box { <-0.3, 0, -0.3>, <0.3, 0.8, 0.3> pigment { rgb <0.8, 0.4, 0.3> } }
    rotate 20*y
}
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.5> } }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -20> right x*4/3 up y look_at <0, 8, 0> angle 80 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.2, 0.3, 0.6>] } } }
light_source { <-50, 90, -200>, rgb 1 }
#declare Colors = color_map { [0 rgbt <0.8, 0.2, 0.9, 1>] [0.2 rgbt <0.4, 0.2, 1, 0.4>] [0.5 rgbt <0.1, 0.9, 0.2, 0.3>] [0.8 rgbt <1, 0.6, 0, 0.3>] [1 rgbt <1, 0, 0, 1>] }
rainbow { angle 36 width 9 arc_angle 140 falloff_angle 60 distance 40 direction <0.1, -0.1, 1> up <0.2, 1, 0> color_map { Colors } }
rainbow { angle 22 width 5 distance 15 direction <0.1, -0.1, 1> color_map { Colors } }
sphere { <6, 7, 5>, 4 pigment { rgb 0.8 } finish { reflection 0.5 } }
sphere { <-12, 10, 30>, 6 pigment { rgbt <1, 0.9, 0.8, 0.6> } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.6, 0.3> scale 4 } }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// The fog lies before the rainbow; and a camera in the half of space that is a disc's inside has fog all the same.
camera { location <0, 1, -5> right x*4/3 up y look_at <0, 1, 0> angle 70 }
light_source { <5, 9, -9>, 1 }
background { rgb <0.3, 0.5, 0.9> }
fog { fog_type 1 distance 15 color rgbft <0.8, 0.7, 0.6, 0.2, 0.3> }
fog { fog_type 2 distance 30 fog_offset 0.2 fog_alt 0.5 color rgb <0.4, 0.6, 0.4> }
rainbow { direction <-0.2, -0.1, 1> angle 20 width 12 distance 40
  color_map { [0 rgbt <1, 0, 0, 0.8>] [0.5 rgbt <0, 1, 0, 0.2>] [1 rgbt <0, 0, 1, 1>] } }
plane { y, -1.01 pigment { checker rgb 0.3 rgb 0.8 } hollow }
disc { <0, 1, 2>, <0.2, 0.1, 1>, 1.2, 0.4 pigment { rgb <1, 0.6, 0.3> } }
sphere { <-1.5, 0, 1>, 0.7 pigment { rgb <0.9, 0.3, 0.4> } }

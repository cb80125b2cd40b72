// SPDX-License-Identifier: GPL-3.0-or-later
// Media of all space: beams of light divide the ways through them, and what stands in a beam throws a shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <2, 4, 1>, 1 spotlight point_at <0.5, -1, 1> radius 8 falloff 12 tightness 2 }
light_source {
  <-2, 4, 0>, <0.9, 0.6, 0.3> spotlight point_at <0, -1, 1> radius 10 falloff 14 media_attenuation on
}
light_source { <-1.7, 4, 0>, <0, 0.5, 0.9> cylinder point_at <-1.7, -1, 0> radius 0.3 falloff 0.5 }
light_source { <0, 9, -9>, 0.3 media_interaction off }
media { scattering { 1, 0.12 } absorption <0.02, 0.01, 0> intervals 5 }
plane { y, -1 pigment { checker rgb 1, rgb <0.3, 0.6, 0.9> } }
sphere { <1, 1, 1>, 0.4 pigment { rgb 1 } }
box { <-0.4, -1, 0.5>, <0.4, 0, 1.2> pigment { rgb <0.8, 0.3, 0.2> } }

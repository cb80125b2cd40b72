// SPDX-License-Identifier: GPL-3.0-or-later
// Media of all space with a density, behind fog, in mirrors and where rays meet nothing; lights that reach
// everywhere leave ways undivided.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <4, 6, -5>, 1 media_attenuation on }
light_source { <2, 4, 1>, 1 spotlight point_at <0, -1, 1> radius 10 falloff 14 }
sky_sphere { pigment { gradient y color_map { [0 rgb <1, 0.8, 0.6>] [1 rgb <0.2, 0.4, 0.9>] } } }
fog { distance 40 rgb <0.5, 0.5, 0.6> }
media {
  absorption 0.1 emission <0.02, 0.01, 0> scattering { 4, 0.02 } method 2 intervals 3 samples 4
  density { planar density_map { [0 rgb 0] [1 rgb 1] } scale 1.5 }
}
plane { y, -1 pigment { checker rgb 1, rgb <0.3, 0.6, 0.9> } }
sphere { 0, 1 pigment { rgb <0.8, 0.2, 0.2> } finish { reflection 0.5 } }
box { <1.5, -1, 0>, <3.5, 1, 1> pigment { rgb 1 } }

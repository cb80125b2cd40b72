// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 }
// Light that media_attenuation dims is dimmed by fogs as well, by one without a distance not at all.
light_source { <6, 8, -4> rgb 1.5 media_attenuation on }
light_source { <-6, 5, -4> rgb 0.5 }
fog { distance 12 rgb <0.4, 0.5, 0.9> turbulence 0.3 turb_depth 0.4 }
fog { fog_type 2 distance 9 rgbft <0.9, 0.5, 0.4, 0.4, 0.1> fog_offset -0.5 fog_alt 0.4 }
fog { distance 0 rgb 1 }
plane { y, -1 pigment { rgb <1, 0.8, 0.6> } }
sphere { 0, 1 pigment { rgb <1, 0.3, 0.3> } }

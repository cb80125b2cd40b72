// SPDX-License-Identifier: GPL-3.0-or-later
// Media of objects glow and swallow light: densities that are multiplied, moved with their object, declared,
// and what is solid keeps them out.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at 0 angle 40 }
light_source { <5, 8, -6>, 1 }
plane { y, -1 pigment { checker rgb 1, rgb <0.3, 0.6, 0.9> } finish { reflection 0.2 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Embers = density {
  spherical turbulence 0.2
  density_map { [0 rgb 0] [0.4 rgb <1, 0.3, 0>] [1 rgb <1, 1, 0.5>] }
}
#declare Glow = media { emission 0.8 absorption 0.3 density { Embers } density { granite scale 2 } }
sphere {
  0, 1 hollow texture { Clear } interior { media { Glow samples 20 } media { absorption <0, 0.2, 0.4> } }
  scale <1, 0.7, 1> rotate 30*z translate -2*x
}
union {
  sphere { 0, 1 }
  box { -0.5, <0.5, 1.5, 0.5> }
  hollow material {
    texture { Clear }
    interior { ior 1.2 media { Glow emission rgb <0.2, 0.5, 0.1> method 2 intervals 4 samples 3 } }
    scale 1.3
  }
  translate 0.3*y
}
sphere { 2.4*x, 0.7 pigment { rgbt <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } }
sphere { 2.4*x, 1 hollow texture { Clear } interior { media { emission <0.5, 0.3, 0> } } }

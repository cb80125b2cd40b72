// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// The sky where no ray meets anything, in layers.
camera { location <0, 1, -6> look_at <0, 2, 0> angle 80 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.3, 0, 0> }
#declare Clouds = pigment { bozo turbulence 0.6 color_map { [0 rgb 1] [0.4 rgbt <1, 1, 1, 0.6>] [0.6 rgbt 1] } scale <0.4, 0.2, 0.4> }
sky_sphere {
    pigment { gradient y color_map { [0 rgbt <0.7, 0.8, 1, 0.2>] [0.6 rgb <0.1, 0.2, 0.7>] } }
    pigment { Clouds rotate 20*y }
    rotate 10*z
    emission 0.9
}
sphere { <0, 1, 0>, 1 pigment { checker rgb 1, rgb <0.8, 0.2, 0.1> scale 0.4 translate 0.01 } }

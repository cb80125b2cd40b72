// SPDX-License-Identifier: GPL-3.0-or-later
// Samples are added up in the colour space of the scene, not as light.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { location -10*z look_at 0 right x*image_width/image_height aperture 3 focal_point -5*z blur_samples 100 variance 0 }
plane { z, 0 pigment { gradient x color_map { [0.5 rgb 0] [0.5 rgb 1] } scale 6 } finish { ambient 0 emission 1 diffuse 0 } }

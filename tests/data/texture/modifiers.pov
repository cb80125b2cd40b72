// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Turbulence, waves, frequency, phase, noise generators, one map for all.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { marble turbulence 0.8 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.5 } })
Show(texture { pigment { wood turbulence <0.1, 0.2, 0.3> octaves 3 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.3 } })
Show(texture { pigment { bozo turbulence 1 lambda 3 omega 0.7 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.5 } })
Show(texture { pigment { agate agate_turb 0.4 turbulence 0.3 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.6 } })
Show(texture { pigment { onion sine_wave frequency 2 phase 0.3 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.6 } })
Show(texture { pigment { gradient y scallop_wave color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.4 } })
Show(texture { pigment { gradient x triangle_wave phase 0.2 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.5 } })
Show(texture { pigment { radial cubic_wave frequency 4 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { spherical poly_wave 3 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 1.5 } })
Show(texture { pigment { gradient z ramp_wave frequency -2 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { granite noise_generator 1 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } } })
Show(texture { pigment { wrinkles noise_generator 3 turbulence 0.4 color_map { [0.1 rgb <1, 0.9, 0.7>] [0.5 rgb <0.7, 0.3, 0.1>] [0.5 rgb <0.1, 0.3, 0.6>] [0.9 rgb <0.9, 1, 1>] } scale 0.4 } })

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Maps of normals and slopes.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { gradient y 1 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.4 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { gradient x normal_map { [0.3 bumps 0.5 scale 0.1] [0.7 wrinkles 0.8 scale 0.2] } scale 2 translate -x } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { average normal_map { [1 bumps 1 scale 0.2] [2 ripples 0.8 frequency 3] } } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { function { sin(10*x)*sin(10*y) } 0.6 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { checker normal { bumps 0.5 scale 0.1 } normal { gradient x 1 scale 0.1 } scale 0.5 translate 0.01 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { granite bump_size 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { bumps 0.5 scale 0.2 no_bump_scale } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { spherical 0.9 sine_wave frequency 3 accuracy 0.01 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { marble 0.6 turbulence 0.4 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { radial 0.5 frequency 8 sine_wave } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { ripples 0.5 turbulence 0.2 phase 0.4 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { quilted 0.9 control0 0.5 scale 0.4 } })

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Warps.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { gradient x color_map { [0 rgb 1] [1 rgb 0] } warp { repeat 0.7*x flip x } scale 0.5 } })
Show(texture { pigment { wood warp { turbulence 0.4 octaves 4 } scale 0.3 } })
Show(texture { pigment { checker rgb 1, rgb 0 scale 0.25 warp { black_hole <0.3, 0.2, -0.7>, 0.6 strength 1.5 falloff 1 } translate 0.01 } })
Show(texture { pigment { gradient x triangle_wave scale 0.1 warp { spherical orientation z } } })
Show(texture { pigment { checker rgb 1, rgb 0 scale <0.125, 0.2, 1> warp { cylindrical } translate 0.003 } })
Show(texture { pigment { gradient y scale 0.2 warp { toroidal orientation y major_radius 0.5 } } })
Show(texture { pigment { brick scale 0.03 warp { planar z, 0 } } })
Show(texture { pigment { spherical scale 0.4 warp { repeat x } warp { repeat y offset 0.5*x } warp { repeat z } scale 0.6 } })
Show(texture { pigment { bozo scale 0.2 warp { turbulence <1, 0, 0.5> lambda 2.5 } scale <1, 2, 1> } })
Show(texture { pigment { checker rgb <1, 1, 0>, rgb <0, 0, 1> scale 0.3 warp { black_hole 0, 1.2 inverse } translate 0.02 } })
Show(texture { pigment { onion scale 0.4 warp { repeat 0.8*y offset <0.2, 0, 0> } } })
Show(texture { pigment { marble turbulence 0.5 scale 0.3 warp { turbulence 0.2 } rotate 45*z } })

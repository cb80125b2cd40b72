// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Textures that move with their objects, and those that parts inherit.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Look = pigment { gradient y color_map { [0 rgb <1, 0.8, 0.2>] [0.5 rgb <0.6, 0.1, 0.1>] [1 rgb <0.1, 0.2, 0.5>] } scale 0.6 }
#declare Ball = sphere { 0, 0.9 pigment { checker rgb 1, rgb <0.8, 0.1, 0.1> scale 0.4 translate 0.01 } }
object { Ball rotate 30 scale <1, 0.7, 1> translate <-3, 2, 0> }
object { Ball translate <-1, 2, 0> pigment { Look } }
union {
    sphere { <0, 0.4, 0>, 0.5 }
    box { -0.5, <0.5, 0, 0.5> pigment { rgb <0, 0.6, 0.3> } }
    pigment { Look }
    rotate 40
    translate <1, 2, 0>
}
difference {
    box { -0.7, 0.7 pigment { bozo scale 0.2 } }
    sphere { <0, 0, -0.7>, 0.6 pigment { Look } }
    rotate <-20, 30, 0>
    translate <3, 2, 0>
}
intersection {
    box { -0.7, 0.7 }
    sphere { 0, 0.9 }
    pigment { granite color_map { [0 rgb 0] [0.6 rgb <1, 0.9, 0.6>] } }
    rotate <-20, 30, 0>
    translate <-3, 0, 0>
}
isosurface {
    function { sqrt(x*x + y*y + z*z) - 0.8 + 0.1*sin(9*x)*sin(9*y)*sin(9*z) }
    contained_by { sphere { 0, 1 } }
    max_gradient 2.5
    pigment { marble turbulence 0.6 scale 0.4 }
    translate <-1, 0, 0>
}
merge {
    cylinder { -0.8*y, 0.8*y, 0.4 pigment { radial frequency 8 } }
    torus { 0.6, 0.2 }
    pigment { Look }
    rotate -30*x
    translate <1, 0, 0>
}
cone { -0.8*y, 0.8, 0.8*y, 0.2 texture { pigment { Look rotate 90*z } scale 0.5 } rotate 20*z translate <3, 0, 0> }
union {
    #declare I = 0;
    #while (I < 40)
        sphere { <0.5*mod(I, 8) - 2, 0.4*int(I/8) - 0.8, 0>, 0.2 }
        #declare I = I + 1;
    #end
    pigment { onion scale 0.7 }
    scale 0.8
    translate <-2, -2, 0>
}
box { -0.6, 0.6 clipped_by { sphere { 0, 0.8 } } pigment { Look } rotate 45 translate <2, -2, 0> }

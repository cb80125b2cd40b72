// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Bent normals.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#macro Show(Look)
    sphere { 0, 0.95 texture { Look } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
    #declare Count = Count + 1;
#end
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { bumps 0.6 scale 0.2 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { dents 1 scale 0.2 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { ripples 0.7 frequency 4 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { waves 0.5 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { wrinkles 0.8 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { granite 0.4 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { crackle 1 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { gradient x 0.7 sine_wave scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { onion 1 scale 0.2 rotate 30 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { bozo 0.8 turbulence 0.5 scale 0.3 } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { bumps 0.6 scale <0.1, 0.4, 0.1> rotate 30*z } })
Show(texture { pigment { rgb <0.8, 0.6, 0.4> } finish { phong 0.5 } normal { wood 1 sine_wave scale 0.2 } })

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Thin films over mirrors and highlights.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb <0.9, 0.8, 0.7> }
light_source { <30, 10, -30>, rgb <0.2, 0.3, 0.5> }
background { rgb <0.5, 0.4, 0.3> }
plane { y, -5 pigment { checker rgb 0.3, rgb <0.9, 0.6, 0.4> } }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> #declare Count = Count + 1; #end
#macro Ball(Finish) sphere { 0, 0.95 pigment { rgb <0.6, 0.4, 0.3> } finish { Finish ambient 0.1 } interior { ior 1.5 } Place() } #end
Ball(finish { reflection 0.4 irid { 0.5 thickness 0.3 } })
Ball(finish { reflection { 0.1, 0.7 } irid { 0.4 thickness 0.6 turbulence 0.8 } })
Ball(finish { reflection { 0.6 metallic } metallic specular 0.8 roughness 0.05 irid { 0.5 thickness 0.2 } })
Ball(finish { phong 0.9 phong_size 5 irid { 0.8 thickness 0.4 } })
Ball(finish { reflection { 0.2, 0.9 fresnel } conserve_energy irid { 0.3 thickness 0.5 } })
Ball(finish { reflection 0.5 reflection_exponent 0.7 irid { 0.5 thickness 0.25 } })
Ball(finish { specular 0.7 roughness 0.02 brilliance 2 irid { -0.6 thickness 0.3 turbulence 1 } })
box { -0.7, 0.7 rotate <20, 35, 10> pigment { rgb <0.3, 0.5, 0.6> } finish { reflection 0.6 phong 0.5 irid { 0.6 thickness 0.35 turbulence 0.5 } } Place() }
sphere { 0, 0.95 pigment { rgb <0.6, 0.4, 0.3> } normal { bumps 0.4 scale 0.3 } finish { reflection 0.4 phong 0.5 irid { 0.5 thickness 0.3 } } Place() }
sphere { 0, 0.95 texture { pigment { rgb 1 } finish { reflection 0.3 irid { 0.5 thickness 0.4 } } } texture { pigment { granite color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.3>] } } finish { reflection 0.3 irid { 0.4 thickness 0.2 } } } Place() }
sphere { 0, 0.95 texture { gradient y texture_map { [0.3 pigment { rgb 1 } finish { reflection 0.5 irid { 0.5 thickness 0.3 } }] [0.7 pigment { rgb <1, 0.5, 0> } finish { reflection 0.2 phong 1 }] } } Place() }
sphere { 0, 0.95 pigment { rgbf <0.9, 0.9, 0.9, 0.7> } finish { reflection 0.3 specular 0.6 irid { 0.5 thickness 0.3 } } interior { ior 1.3 } Place() }

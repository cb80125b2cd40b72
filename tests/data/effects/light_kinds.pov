// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// The words for the kinds of a light in all orders, each with a floor and a ball of its own.
camera { orthographic location <0, 9, -9> right x*8 up y*6 look_at 0 }
#declare Count = 0;
#macro Place() translate <2*mod(Count, 4) - 3, 0, 2.8 - 2.8*int(Count/4)> #declare Count = Count + 1; #end
#macro Lit(Light)
  light_group {
    light_source { Light }
    box { <-0.9, -1, -1.3>, <0.9, 0, 1.3> pigment { rgb <0.9, 0.8, 0.7> } }
    sphere { 0.4*y, 0.3 pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.5 } }
    global_lights off
    Place()
  }
#end
Lit(light_source { <1, 4, -1>, 1 spotlight point_at 0 radius 5 falloff 15 shadowless })
Lit(light_source { <1, 4, -1>, 1 shadowless spotlight point_at 0 radius 5 falloff 15 })
Lit(light_source { <1, 4, -1>, 1 cylinder point_at 0 })
Lit(light_source { <1, 4, -1>, 1 cylinder point_at 0 spotlight })
Lit(light_source { <1, 4, -1>, 1 cylinder point_at 0 shadowless })
Lit(light_source { <1, 4, -1>, 1 spotlight point_at 0 radius 5 falloff 15 cylinder })
Lit(light_source { <1, 4, -1>, 1 parallel point_at 0 spotlight radius 5 falloff 15 })
Lit(light_source { <1, 4, -1>, 1 parallel point_at 0 shadowless })
Lit(light_source { <1, 4, -1>, 1 cylinder point_at 0 radius 0.3 falloff 0.8 tightness 2 parallel })
Lit(light_source { <1, 4, -1>, 1 spotlight point_at 0 tightness 8 area_light 0.5*x, 0.5*y, 3, 3 shadowless })
Lit(light_source { <1, 4, -1>, 1 shadowless area_light 0.5*x, 0.5*y, 3, 3 spotlight point_at 0 radius 5 falloff 15 })
Lit(light_source { <1, 4, -1>, 1 cylinder radius 0.5 falloff 0.7 point_at 0 spotlight cylinder tightness 1 })

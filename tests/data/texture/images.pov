// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
global_settings { assumed_gamma 1 }
// Images as pigments: map types, once, interpolation, transparency in layers.
camera { location <0, 0, -12> look_at 0 angle 45 }
light_source { <-20, 30, -40>, rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#declare Count = 0;
#declare Ground = texture { pigment { rgb <0.2, 0.6, 0.3> } }
#macro Show(Settings)
   sphere { 0, 0.95 texture { Ground } texture { pigment { Settings } } translate <2*mod(Count, 4) - 3, 2 - 2*int(Count/4), 0> }
   #declare Count = Count + 1;
#end
Show(pigment { image_map { png "image.png" map_type 0 } })
Show(pigment { image_map { png "image.png" map_type 1 } })
Show(pigment { image_map { png "image.png" map_type 2 } })
Show(pigment { image_map { png "image.png" map_type 5 } })

Show(pigment { image_map { png "image.png" map_type 0 interpolate 2 } })
Show(pigment { image_map { png "image.png" map_type 1 interpolate 2 } })
Show(pigment { image_map { png "image.png" map_type 2 interpolate 2 } })
Show(pigment { image_map { png "image.png" map_type 5 interpolate 2 } })

Show(pigment { image_map { png "image.png" once interpolate 2 } })
Show(pigment { image_map { png "image.png" once } scale 1.4 translate -0.7 })
Show(pigment { image_map { png "image.png" transmit all 0.3 } turbulence 0.1 rotate 30*z })
Show(pigment { image_map { png "image.png" filter all 0.8 } warp { repeat x flip x } scale 0.5 })

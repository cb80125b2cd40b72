// A heart.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <4.5, -1.9, 1.2>
  sky z
  right x*image_width/image_height
  direction 1.94*z
  look_at <0, -0.05, 0.18>
}
light_source { <6, -4, 5>*1.2 rgb 0.9 }
light_source { <3, 6, 2>*1.2 rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

isosurface {
  function { f_heart(x, y, z, -1) }
  contained_by { sphere { 0, 1.6 } }
  threshold 0
  max_gradient 71
  pigment { rgb <0.85, 0.10, 0.18> }
  finish { ambient 0.12 diffuse 0.75 phong 0.7 phong_size 70 }
}

// Klein's bottle, cut open.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <7.5, 6.0, -8.5>
  right x*image_width/image_height
  direction 1.83*z
  look_at <0, 0.45, 0>
}
light_source { <4, 6, -5>*3 rgb 0.9 }
light_source { <-6, 2, -3>*3 rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

isosurface {
  function { f_klein_bottle(x, y, z, -1) }
  contained_by { box { <-4.5, -4.5, 0>, <4.5, 4.5, 4.5> } }
  open
  max_gradient 2000
  pigment { rgb <0.50, 0.55, 0.90> }
  finish { ambient 0.12 diffuse 0.75 phong 0.5 phong_size 50 }
}

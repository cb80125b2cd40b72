// A cylinder and a bar, blended by multiplication.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <3.6, 2.8, -4.6>
  right x*image_width/image_height
  direction 1.74*z
  look_at <0, 0, 0>
}
light_source { <4, 6, -5>*1.2 rgb 0.9 }
light_source { <-6, 2, -3>*1.2 rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Seam = 0.03;
#declare Cylinder = function { sqrt(y*y + z*z) - 0.8 }
#declare Bar = function { abs(x) + abs(y) - 1 }

isosurface {
  function { Cylinder(x, y, z)*Bar(x, y, z) - Seam }
  contained_by { sphere { 0, 2 } }
  max_gradient 2.9
  pigment { rgb <0.90, 0.70, 0.30> }
  finish { ambient 0.1 diffuse 0.8 phong 0.5 phong_size 40 }
}

// A gyroid shell: many sheets along each ray.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <13.9, 11.6, -18.9>
  right x*image_width/image_height
  direction 1.83*z
  look_at <0, 0, 0>
}
light_source { <4, 6, -5>*5 rgb 0.9 }
light_source { <-6, 2, -3>*5 rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Thickness = 0.35;

isosurface {
  function { abs(sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)) - Thickness }
  contained_by { sphere { 0, 6 } }
  max_gradient 1.8
  pigment { rgb <0.45, 0.75, 0.50> }
  finish { ambient 0.1 diffuse 0.8 phong 0.4 phong_size 40 }
}

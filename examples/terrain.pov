// Mountains from a ridged multifractal.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <6.5, 4.7, -9.1>
  right x*image_width/image_height
  direction 2.05*z
  look_at <0, -0.4, -0.2>
}
light_source { <4, 6, -5>*2 rgb 0.9 }
light_source { <-6, 2, -3>*2 rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Relief = 0.6;

isosurface {
  function { y - Relief*f_ridged_mf(x, 0, z, 0.6, 2.2, 6, 0.7, 0.8, 2) }
  contained_by { box { <-2.4, -0.3, -2.4>, <2.4, 1.2, 2.4> } }
  max_gradient 3
  pigment { rgb <0.60, 0.55, 0.42> }
  finish { ambient 0.08 diffuse 0.85 }
}

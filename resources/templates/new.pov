#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <2.4, 1.8, -3.2>
  right x*image_width/image_height
  look_at 0
  angle 40
}
light_source { <4, 6, -5> rgb 0.9 }
light_source { <-6, 2, -3> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }


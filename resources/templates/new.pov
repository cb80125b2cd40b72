#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <2.4, 1.8, -3.2>
  right x*image_width/image_height
  look_at 0
  angle 40
}
// Far away, so that they suit a scene of any size.
light_source { <4000, 6000, -5000> rgb 0.9 }
light_source { <-6000, 2000, -3000> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }


// A twisted box.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <2.8, 2.1, -3.6>
  right x*image_width/image_height
  direction 1.74*z
  look_at <0, 0, 0>
}
light_source { <4, 6, -5> rgb 0.9 }
light_source { <-6, 2, -3> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Turns = 0.25;    // per unit of height
#declare Side = 0.45;
#declare Height = 1.2;

#declare Box = function { max(abs(x) - Side, abs(y) - Height, abs(z) - Side) }

isosurface {
  function {
    Box(x*cos(y*Turns*2*pi) - z*sin(y*Turns*2*pi),
        y,
        x*sin(y*Turns*2*pi) + z*cos(y*Turns*2*pi))
  }
  contained_by { box { <-1, -1.4, -1>, <1, 1.4, 1> } }
  max_gradient 1.9
  pigment { rgb <0.30, 0.65, 0.85> }
  finish { ambient 0.1 diffuse 0.8 phong 0.6 phong_size 60 }
}

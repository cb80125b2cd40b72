// A ball and a ring that melt into each other.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <1.8, 1.6, -2.6>
  right x*image_width/image_height
  direction 1.83*z
  look_at <0, -0.05, 0>
}
light_source { <4, 6, -5> rgb 0.9 }
light_source { <-6, 2, -3> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Radius = 0.55;   // of the ball
#declare Melt = 0.015;    // how far the shapes run into each other

#declare Ball = function { sqrt(x*x + y*y + z*z) - Radius }
#declare Ring = function { f_torus(x, y, z, 0.8, 0.18) }

isosurface {
  // Negative inside, positive outside: the surface is where the value equals the threshold.
  function { Ball(x, y, z)*Ring(x, y, z) - Melt }
  contained_by { sphere { 0, 1.3 } }
  threshold 0
  accuracy 0.001
  max_gradient 2.1
  pigment { rgb <0.90, 0.36, 0.07> }
  finish { ambient 0.15 diffuse 0.75 phong 0.5 phong_size 60 }
}

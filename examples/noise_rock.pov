// A rock, roughened by two sizes of noise.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <2.2, 1.5, -2.9>
  right x*image_width/image_height
  direction 1.83*z
  look_at <0, -0.05, 0>
}
light_source { <4, 6, -5> rgb 0.9 }
light_source { <-6, 2, -3> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

#declare Rough = 0.55;    // size of the large bumps
#declare Grain = 0.08;    // size of the small ones

isosurface {
  function {
    sqrt(x*x + y*y*1.4 + z*z) - 0.75
    - Rough*(f_noise3d(x*1.8, y*1.8, z*1.8) - 0.5)
    - Grain*f_noise3d(x*11, y*11, z*11)
  }
  contained_by { sphere { 0, 1.3 } }
  max_gradient 2.8
  pigment { rgb <0.62, 0.58, 0.52> }
  finish { ambient 0.1 diffuse 0.85 }
}

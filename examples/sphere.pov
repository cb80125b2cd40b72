// A lesson: a ball with holes, and how to close them.
// POV-Ray skips what it believes too far away: max_gradient says how steep the function may be, and here it is
// steeper. The window shows what POV-Ray will draw. Move the slider of max_gradient: at 2.4, the value that the
// Gradient panel proves, the last hole is gone.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera {
  location <2.2, 1.6, -2.9>
  right x*image_width/image_height
  direction 1.83*z
  look_at <0, 0, 0>
}
light_source { <4, 6, -5> rgb 0.9 }
light_source { <-6, 2, -3> rgb <0.2, 0.24, 0.32> shadowless }
background { rgb <0.020, 0.022, 0.028> }

isosurface {
  function { x*x + y*y + z*z - 1 }
  contained_by { sphere { 0, 1.2 } }
  max_gradient 1.1
  pigment { rgb <0.85, 0.30, 0.25> }
  finish { ambient 0.1 diffuse 0.8 phong 0.5 }
}

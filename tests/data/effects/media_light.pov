// SPDX-License-Identifier: GPL-3.0-or-later
// Media of objects scatter light, by all types, and cast shadows; a light within is not dimmed.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at 0 angle 45 }
light_source { <5, 8, -3>, 0.8 }
light_source { <-1.6, 0.8, 0>, rgb <0.7, 0.3, 0.1> fade_distance 1 fade_power 2 }
light_source { <0, 9, 9>, 0.3 media_interaction off }
light_source { <0, 9, -9>, 0.2 shadowless }
plane { y, -1 pigment { checker rgb 1, rgb <0.3, 0.6, 0.9> } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#macro Cloud(Kind, Place)
  box {
    -0.7, 0.7 hollow texture { Clear }
    interior { media { scattering { Kind, <0.6, 0.5, 0.4> #if (Kind = 5) eccentricity 0.4 #end extinction 0.7 } samples 4 } }
    translate Place
  }
#end
Cloud(1, <-3, 0, 0>)
Cloud(2, <-1.5, 0, 0>)
Cloud(3, <0, 0, 0>)
Cloud(4, <1.5, 0, 0>)
Cloud(5, <3, 0, 0>)
sphere { <-1.5, 0.2, 0>, 0.3 pigment { rgb <1, 0.4, 0.4> } }
sphere {
  <0, 1.8, 0>, 0.8 hollow texture { Clear }
  interior { media { scattering { 1, 1 } absorption 0.5 density { wrinkles scale 0.4 } } }
}

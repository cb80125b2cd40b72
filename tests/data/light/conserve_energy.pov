#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
#macro Pane(X, F) box { <-0.7, 0, 0>, <0.7, 2, 0.1> rotate y*40 translate x*X pigment { rgbf <0.8, 1, 0.8, 0.9> } finish { F } } #end
Pane(-1.6, finish { reflection rgb <0.6, 0.3, 0.1> conserve_energy }) Pane(0.1, finish { reflection { 0.1, 0.9 } conserve_energy }) Pane(1.8, finish { reflection 0.5 })

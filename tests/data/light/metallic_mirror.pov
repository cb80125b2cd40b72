#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7> rgb <0.25, 0.3, 0.35> } finish { ambient 0.1 } }
#macro Ball(X, M) sphere { <X, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.6, 0.2> } finish { ambient 0.05 diffuse 0.2 metallic specular 0.6 reflection { 0.3, 0.9 falloff 2 metallic M } } } #end
Ball(-1.8, 1) Ball(0, 0.5) Ball(1.8, 0)
sphere { <0, 0.4, -1.6>, 0.4 texture { pigment { agate color_map { [0 rgb <0.8, 0.2, 0.1>] [1 rgb <0.3, 0.6, 0.9>] } scale 0.3 } finish { reflection { 0.8 metallic } } } }

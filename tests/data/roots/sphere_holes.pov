// The unit sphere with a max_gradient M below its true 2.4; sphere_holes_M.pbm are the pixels that POV-Ray 3.7.0.10
// shows, made with `povray +Isphere_holes.pov Declare=M=0.7 +W160 +H120 +WT1 +FP -D` and a threshold of one half.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
isosurface {
  function { x*x + y*y + z*z - 1 }
  accuracy 0.0001
  max_gradient M
  contained_by { sphere { 0, 1.2 } }
  pigment { rgb 1 }
  finish { ambient 1 diffuse 0 }
}

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 2.2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, 0 pigment { rgb 0.2 } }
prism { 0.05, 2, 4, <-1.5, -1>, <1.5, -1>, <1.5, 0.8>, <-1.5, -1>
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 dispersion 1.08 dispersion_samples 12 } }
union { box { <-4, 0, 6>, <-1, 4, 7> } box { <0.5, 0, 6>, <1.5, 4, 7> } box { <2, 0, 6>, <5, 4, 7> }
  pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.9 } }

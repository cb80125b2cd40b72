// SPDX-License-Identifier: GPL-3.0-or-later
// 10 000 spheres and cylinders in one union: what finding the nearest of many shapes costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 14, -26> look_at <0, -1, 0> angle 50 }
light_source { <20, 40, -30>, 1 shadowless }
#declare Seed = seed(2024);
union {
  #for (I, 1, 5000)
    #local Place = <24*rand(Seed) - 12, 16*rand(Seed) - 8, 24*rand(Seed) - 12>;
    sphere { Place, 0.05 + 0.15*rand(Seed) pigment { rgb <0.9, 0.6, 0.3> } }
    #local Other = <24*rand(Seed) - 12, 16*rand(Seed) - 8, 24*rand(Seed) - 12>;
    cylinder {
      Other, Other + <rand(Seed) - 0.5, rand(Seed) - 0.5, 2*rand(Seed) + 0.1>, 0.03 + 0.06*rand(Seed)
      pigment { rgb <0.4, 0.6, 0.9> }
    }
  #end
}

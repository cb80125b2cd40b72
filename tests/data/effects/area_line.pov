// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "area_scene.inc"
light_source { <3, 7, -4>, rgb 1 area_light 3*x, 2*z, 7, 1 spotlight point_at <0, 0, 0> radius 20 falloff 30 }

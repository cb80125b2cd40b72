// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "area_scene.inc"
light_source { <3, 7, -4>, rgb 1 area_light 1*x, 1*z, 5, 5 scale <1, 1, 2> rotate 20*y }

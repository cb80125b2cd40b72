// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "area_scene.inc"
light_source { <3, 7, -4>, rgb 1 area_light <0.4, 0.2, 0>, <0, 0, 3>, 6, 4 orient }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "area_scene.inc"
light_source { <3, 7, -4>, rgb 1 area_light 2*x, 2*z, 5, 5 jitter }

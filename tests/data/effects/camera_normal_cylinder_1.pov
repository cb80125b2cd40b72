// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "camera_scene.inc"
camera { cylinder 1 location <0.3, 0.2, -0.5> right x*4/3 up 1.5*y angle 150 look_at <1, 0.5, 2> normal { bumps 0.4 scale 0.15 } }

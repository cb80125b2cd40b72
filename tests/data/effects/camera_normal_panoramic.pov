// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "camera_scene.inc"
camera { panoramic location <0.3, 0.2, -0.5> right x*4/3 up y look_at <1, 0.5, 2> normal { bumps 0.4 scale 0.15 } }

// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
camera { location <0, 0, -4> right x*4/3 up y look_at 0 angle 60 normal { bumps 0.4 scale 0.15 } }
#include "camera_scene.inc"

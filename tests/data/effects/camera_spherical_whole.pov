// SPDX-License-Identifier: GPL-3.0-or-later
#version 3.7;
#include "camera_scene.inc"
camera { spherical location <0.3, 0.2, -0.5> right -x*4/3 up y rotate 20*z }

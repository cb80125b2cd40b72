// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/patterns/pattern_warp.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// A transformation as a warp: patterns are looked up through its inverse.
TransformWarp transformWarp(const Transform& transform);

}  // namespace isoscope

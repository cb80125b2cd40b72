// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// By instruction of a tape with these values of its uniform slots: of u - floor(u + c) and u - ceil(u + c),
/// which repeat space, the value just before a step of 1; NaN for all else.
std::vector<double> roundingCuts(const Tape& tape, std::span<const double> uniforms);

}  // namespace isoscope

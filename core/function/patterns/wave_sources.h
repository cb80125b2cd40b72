// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace isoscope {

/// A point of the unit sphere from which waves spread, and how many of them to a unit of length.
struct WaveSource {
    std::array<double, 3> position;
    double frequency;
};

/// The first `count` sources of the patterns ripples and waves (docs/povray/patterns.md, 2.3). `count` is
/// held in 1..1000.
std::vector<WaveSource> waveSources(int count);

}  // namespace isoscope

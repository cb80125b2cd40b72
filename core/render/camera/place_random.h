// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>

namespace isoscope {

/// Random numbers that depend on nothing but a place and a number: the same whichever thread asks, and
/// whenever. SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class PlaceRandom {
  public:
    explicit PlaceRandom(const glm::dvec3& place, std::uint64_t number = 0) : state_(number) {
        for (int c = 0; c < 3; ++c) state_ = mixed(state_ ^ std::bit_cast<std::uint64_t>(place[c]));
    }

    /// Evenly from 0 to 1, 1 excluded.
    double next() {
        state_ += 0x9e3779b97f4a7c15;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

  private:
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

}  // namespace isoscope

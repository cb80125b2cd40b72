// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace isoscope {

/// The tables of lattice noise folded to what one cell reads: small enough to stay in the first-level cache.
/// latticeHash() repeats after 4096 entries, so indices, which begin 10000 lattice points below 0, may be
/// taken modulo 4096.
struct LatticeLookup {
    std::array<std::uint16_t, 4097> hash;  ///< latticeHash(); one more entry for index + 1
    std::array<std::uint8_t, 4096> entry;  ///< latticeHash() & 255, the place in latticeValues()
    /// hash[hash[index] ^ 10000 % 4096], for y = 0: landscapes are made of noise(x, 0, z).
    std::array<std::uint16_t, 4097> ground;
};

// Built by the compiler, and seen as they are: a call in between would have vectors stored and loaded again.
extern const LatticeLookup latticeLookup;
extern const std::array<double, 267> latticeValueTable;  ///< latticeValues()

}  // namespace isoscope

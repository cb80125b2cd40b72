// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/numeric/linear_congruential.h"
#include "core/numeric/noise.h"
#include "core/numeric/noise_lookup.h"

namespace isoscope {

namespace {

consteval std::array<unsigned short, 8192> buildLatticeHash() {
    std::array<unsigned short, 8192> hash{};
    for (unsigned i = 0; i < 4096; ++i) hash[i] = static_cast<unsigned short>(i);
    LinearCongruential random(0);
    for (unsigned i = 4096; i-- > 0;) std::swap(hash[i], hash[random.next() % 4096]);
    for (unsigned i = 0; i < 4096; ++i) hash[4096 + i] = hash[i];
    return hash;
}

/// CRC-16 (reflected, polynomial 0xA001, register 0) of the big-endian bytes of `value`, three times in a
/// row.
consteval unsigned tripleCrc(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    unsigned crc = 0;
    for (int byte = 0; byte < 24; ++byte) {
        crc ^= static_cast<unsigned>(bits >> (56 - 8 * (byte % 8))) & 0xffu;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1u) ? (crc >> 1) ^ 0xa001u : crc >> 1;
    }
    return crc;
}

/// crc*2/65535 - 1 rounded to six significant decimal digits. The fraction is never half-way between two
/// such numbers (the numerator is even, 65535 is odd), so whole-number arithmetic decides exactly, and the
/// quotient of two exact doubles is the double nearest to the decimal figure.
consteval double sixDigits(unsigned crc) {
    const bool negative = 2 * crc < 65535;
    const std::uint64_t numerator = negative ? 65535 - 2 * crc : 2 * crc - 65535;
    std::uint64_t scale = 1;
    while (numerator * scale < 65535ull * 100'000 && scale < 10'000'000'000) scale *= 10;
    const std::uint64_t figure = (2 * numerator * scale + 65535) / (2 * 65535);
    const double magnitude = static_cast<double>(figure) / static_cast<double>(scale);
    return negative ? -magnitude : magnitude;
}

consteval std::array<double, 267> buildLatticeValues() {
    std::array<double, 267> values{};
    for (std::size_t i = 0; i < 267; ++i) values[i] = sixDigits(tripleCrc(static_cast<double>(i) * 0.12345));
    return values;
}

// Built by the compiler: looking it up costs no guard in the inner loop.
constexpr std::array<unsigned short, 8192> hashTable = buildLatticeHash();
consteval LatticeLookup buildLookup() {
    LatticeLookup lookup{};
    for (unsigned i = 0; i < 4096; ++i) {
        lookup.hash[i] = hashTable[i];
        lookup.entry[i] = static_cast<std::uint8_t>(hashTable[i] & 255u);
    }
    lookup.hash[4096] = hashTable[4096];
    for (unsigned i = 0; i <= 4096; ++i) lookup.ground[i] = lookup.hash[lookup.hash[i] ^ 10000 % 4096];
    return lookup;
}

GradientNoiseTables buildGradientTables() {
    GradientNoiseTables tables;
    LinearCongruential random(1);
    for (auto& gradient : tables.gradients) {
        double squared = 0;
        do {
            for (double& component : gradient)
                component = (static_cast<double>(random.next() % 4096) - 2048) / 2048;
            squared = gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
        } while (squared > 1 || squared < 1e-5);
        const double scale = 1 / std::sqrt(squared);
        for (double& component : gradient) component *= scale;
    }
    auto& hash = tables.hash;
    for (unsigned i = 0; i < 2048; ++i) hash[i] = static_cast<unsigned short>(i);
    hash[2048] = 0;
    for (unsigned i = 2048; i > 0; i -= 2) std::swap(hash[i], hash[random.next() % 2048]);
    for (unsigned i = 0; i < 2050; ++i) hash[2048 + i] = hash[i];
    return tables;
}

}  // namespace

constexpr std::array<double, 267> latticeValueTable = buildLatticeValues();
constexpr LatticeLookup latticeLookup = buildLookup();

const std::array<unsigned short, 8192>& latticeHash() { return hashTable; }

const std::array<double, 267>& latticeValues() { return latticeValueTable; }

const GradientNoiseTables& gradientNoiseTables() {
    static const GradientNoiseTables tables = buildGradientTables();
    return tables;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "core/evaluate/affine_evaluator.h"
#include "tests/support/exact_evaluator.h"

namespace isoscope::test {

inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Pieces of rays near the origin, from a millionth to five units long.
inline RayPieces randomPieces(std::mt19937_64& random) {
    RayPieces pieces;
    for (std::size_t i = 0; i < batchLanes; ++i) {
        for (int k = 0; k < 3; ++k) {
            pieces.origin[k][i] = uniform(random, -4, 4);
            pieces.direction[k][i] = uniform(random, -1, 1);
        }
        pieces.start[i] = uniform(random, 0, 3);
        pieces.length[i] = std::pow(10.0, uniform(random, -6, 0.7));
    }
    return pieces;
}

/// start + share * length, exactly.
inline ExactNumber distanceAt(const RayPieces& pieces, std::size_t lane, double share) {
    ExactNumber t(share);
    mpfr_mul_d(t.get(), t.get(), pieces.length[lane], MPFR_RNDN);
    mpfr_add_d(t.get(), t.get(), pieces.start[lane], MPFR_RNDN);
    return t;
}

/// The point at that distance, exactly.
inline std::array<ExactNumber, 3> pointAt(const RayPieces& pieces, std::size_t lane, double share) {
    const ExactNumber t = distanceAt(pieces, lane, share);
    std::array<ExactNumber, 3> point;
    for (int k = 0; k < 3; ++k) {
        mpfr_mul_d(point[k].get(), t.get(), pieces.direction[k][lane], MPFR_RNDN);
        mpfr_add_d(point[k].get(), point[k].get(), pieces.origin[k][lane], MPFR_RNDN);
    }
    return point;
}

/// Whether the form admits `value` at the share (0 to 1) of the piece.
inline bool admits(const AffineForm& form, const ExactNumber& share, const ExactNumber& value) {
    if (form.e == -INFINITY) return value.isNan();
    if (!(form.e < INFINITY)) return true;
    if (value.isNan()) return false;
    // |value - a - b s| <= e, at 200 bits.
    ExactNumber rest(share);
    mpfr_mul_d(rest.get(), rest.get(), 2, MPFR_RNDN);
    mpfr_sub_d(rest.get(), rest.get(), 1, MPFR_RNDN);
    mpfr_mul_d(rest.get(), rest.get(), form.b, MPFR_RNDN);
    mpfr_add_d(rest.get(), rest.get(), form.a, MPFR_RNDN);
    mpfr_sub(rest.get(), value.get(), rest.get(), MPFR_RNDN);
    return mpfr_cmpabs(rest.get(), ExactNumber(form.e).get()) <= 0;
}

inline bool admits(const AffineForm& form, double share, const ExactNumber& value) {
    return admits(form, ExactNumber(share), value);
}

}  // namespace isoscope::test

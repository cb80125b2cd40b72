// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/operation.h"

namespace isoscope {

/// Whether SlopeAlgebra and TaylorAlgebra have a rule for the operation, noise aside.
constexpr bool hasSlopeRule(Operation operation) {
    switch (operation) {
        case Operation::negate:
        case Operation::absolute:
        case Operation::square:
        case Operation::squareRoot:
        case Operation::exponential:
        case Operation::sine:
        case Operation::cosine:
        case Operation::add:
        case Operation::subtract:
        case Operation::multiply:
        case Operation::divide:
        case Operation::minimum:
        case Operation::maximum: return true;
        default: return false;
    }
}

}  // namespace isoscope

// The other operations of one and of two operands, for algebras that have to name them all.
// clang-format off
#define ISOSCOPE_WITHOUT_SLOPE_RULE(UNARY, BINARY) \
    UNARY(naturalLogarithm) UNARY(decimalLogarithm) UNARY(tangent) \
    UNARY(arcSine) UNARY(arcCosine) UNARY(arcTangent) \
    UNARY(hyperbolicSine) UNARY(hyperbolicCosine) UNARY(hyperbolicTangent) \
    UNARY(areaSine) UNARY(areaCosine) UNARY(areaTangent) \
    UNARY(floor) UNARY(ceiling) UNARY(truncate) \
    BINARY(power) BINARY(arcTangent2) BINARY(remainder) BINARY(integerDivide) \
    BINARY(equal) BINARY(notEqual) BINARY(less) BINARY(lessEqual) BINARY(greater) BINARY(greaterEqual) \
    BINARY(logicalAnd) BINARY(logicalOr)
// clang-format on

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/function/patterns/pattern.h"

namespace isoscope {

/// What the raw value of a pattern (docs/povray/patterns.md, section 3) is made from: the pattern, the point
/// behind the warp, and the noise generator in force.
struct PatternCall {
    const Pattern& pattern;
    Expression x, y, z;
    int generator = 2;

    /// A constant of the point's graph.
    Expression number(double value) const { return x.number(value); }
};

/// A setting that POV-Ray stores in single precision.
inline double singlePrecision(double value) { return static_cast<double>(static_cast<float>(value)); }

/// sin(2 pi t), evaluated after reduction to one period.
Expression cycle(Expression t);

/// The triangle wave of period 1 between 0 and 1.
Expression triangle(Expression t);

/// Noise of the call's generator at the point times `factor`.
Expression patternNoise(const PatternCall& call, double factor = 1);

/// Scalar turbulence at the call's point, with the pattern's octaves, lambda and omega (docs/povray/noise.md,
/// section 7).
Expression turbulence(const PatternCall& call);

/// One component (0, 1, 2) of the vector turbulence there, with the same settings.
Expression turbulenceComponent(const PatternCall& call, std::size_t axis);

/// Raw values by family; each handles the kinds it is named for.
Expression fractalPattern(const PatternCall& call);
Expression noisePattern(const PatternCall& call);
Expression shapePattern(const PatternCall& call);
Expression spiralPattern(const PatternCall& call);
Expression tilePattern(const PatternCall& call);
Expression wavePattern(const PatternCall& call);

}  // namespace isoscope

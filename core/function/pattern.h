// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/function/graph_builder.h"

namespace isoscope {

/// The patterns of spec/patterns.md.
enum class PatternKind {
    agate, boxed, bozo, brick, bumps, checker, crackle, cylindrical, dents, gradient, granite, hexagon, leopard,
    mandel, marble, onion, planar, radial, ripples, spherical, spiral1, spiral2, spotted, waves, wood, wrinkles
};

enum class WaveForm { ramp, triangle, sine, scallop, cubic, poly };

/// A pattern with its modifiers; every number has POV-Ray's default. Single-precision settings are rounded
/// by buildPattern, as the specification says, not by the caller.
struct Pattern {
    PatternKind kind = PatternKind::bozo;
    std::optional<WaveForm> wave;       ///< default: triangle for marble, wood, spiral1, spiral2, else ramp
    double waveExponent = 1;
    std::optional<double> frequency;    ///< default 1; 0 for checker, brick, hexagon
    std::optional<double> phase;
    std::optional<std::array<double, 3>> turbulence;
    int octaves = 6;
    double lambda = 2;
    double omega = 0.5;
    int noiseGenerator = 0;             ///< 0: the scene's
    std::array<double, 3> gradient{1, 0, 0};
    double agateTurbulence = 1;
    std::array<double, 3> brickSize{8, 3, 4.5};
    double mortar = 0.5;
    CrackleSettings crackle;
    int iterations = 25;                ///< of mandel
    int arms = 2;                       ///< of spiral1, spiral2
    int numberOfWaves = 10;
};

/// Most iterations of the Mandelbrot pattern that are honoured; more act like this number.
constexpr int mandelIterationLimit = 4096;

/// The value of the pattern at (x, y, z), pipeline included. Octaves are held in 1..10, waves in 1..1000. POV-Ray's
/// limit of coordinates to +-1e17 is left out.
Expression buildPattern(const Pattern& pattern, Expression x, Expression y, Expression z, int sceneNoiseGenerator);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/function/graph_builder.h"
#include "core/function/patterns/pattern_warp.h"

namespace isoscope {

/// The patterns of docs/povray/patterns.md.
enum class PatternKind {
    agate,
    boxed,
    bozo,
    brick,
    bumps,
    checker,
    crackle,
    cylindrical,
    dents,
    gradient,
    granite,
    hexagon,
    leopard,
    mandel,
    marble,
    onion,
    planar,
    radial,
    ripples,
    spherical,
    spiral1,
    spiral2,
    spotted,
    waves,
    wood,
    wrinkles,
    // Patterns that docs/povray/patterns.md leaves out; their values were measured.
    cells,
    cubic,
    quilted,
    square,
    triangular,
    tiling,
    pavement,
    julia,
    magnetMandel,
    magnetJulia,
    slope,    ///< how the surface leans, which only textures know (surface_variables.h)
    aoi,      ///< how far it is turned away from the viewer, likewise
    function  ///< Pattern::function in place of a formula: `function { }`, and what is made into one
};

/// What a pattern's value is put through last, behind frequency and phase (docs/povray/patterns.md, the
/// pipeline's step 5).
enum class WaveForm { ramp, triangle, sine, scallop, cubic, poly };

/// Which tiles `pavement` lays (pavement.h): of how many cells with 3, 4 or 6 sides, and in which way.
struct PavementChoice {
    int sides = 3, tiles = 1, layout = 1;

    friend bool operator==(const PavementChoice&, const PavementChoice&) = default;
};

/// `exterior type, factor` and `interior type, factor` of the fractal patterns. With u the point reached, m
/// the least |u| on the way and k of N steps done: type 0 is the factor, 1 is k/N (exterior) or m*factor
/// (interior), 2 and 3 are the real and the imaginary part times the factor, 4 and 5 their squares times the
/// factor; 6 is |u|*factor (exterior) or re^2 + im^2*factor (interior). Other types act as 0.
struct FractalColoring {
    int type = 0;
    double factor = 1;
};

/// The settings of PatternKind::slope. Where low and high are the same, the value counts as it is. The
/// lengths of the directions are the weights of slope and altitude.
struct SlopeSettings {
    /// The values that become 0 and 1 of the pattern.
    struct Range {
        double low = 0, high = 0;
    };

    std::array<double, 3> direction{0, 1, 0};
    Range slopes;
    std::optional<std::array<double, 3>> altitude;  ///< how far the point is along this counts as well
    Range altitudes;
};

/// A pattern with its modifiers; every number has POV-Ray's default. Single-precision settings are rounded
/// by buildPattern, as the specification says, not by the caller.
struct Pattern {
    PatternKind kind = PatternKind::bozo;
    std::optional<WaveForm> wave;  ///< default: triangle for marble, wood, spiral1, spiral2, else ramp
    double waveExponent = 1;
    std::optional<double> frequency;  ///< default 1; 0 for quilted, and where isDiscrete()
    std::optional<double> phase;
    std::optional<std::array<double, 3>> turbulence;
    int octaves = 6;
    double lambda = 2;
    double omega = 0.5;
    int noiseGenerator = 0;  ///< 0: the scene's
    std::array<double, 3> gradient{1, 0, 0};
    double agateTurbulence = 1;
    std::array<double, 3> brickSize{8, 3, 4.5};
    double mortar = 0.5;
    CrackleSettings crackle;
    int iterations = 25;             ///< of the fractals
    FractalColoring exterior{1, 1};  ///< of the fractals: mandel, julia and the magnet ones
    FractalColoring interior{0, 1};
    int exponent = 2;                        ///< of mandel and julia; outside 2..33 it acts as 2
    int magnetType = 1;                      ///< 1 or 2
    std::array<double, 2> juliaPoint{0, 0};  ///< of julia and magnetJulia
    double control0 = 1;                     ///< of quilted
    double control1 = 1;
    SlopeSettings slope;
    Function function;               ///< of PatternKind::function: one result, three arguments
    std::vector<PatternWarp> warps;  ///< transformations and warps in the order in which they are written
    int arms = 2;                    ///< of spiral1, spiral2
    int tiling = 1;                  ///< number 1 to rhombTiling (tilings.h)
    PavementChoice pavement;
    int numberOfWaves = 10;
};

/// Most iterations of the fractal patterns that are honoured; more act like this number.
constexpr int fractalIterationLimit = 100'000;
/// Patterns with up to so many become operations of a graph, with bounds; the others are looked up.
constexpr int unrolledIterations = 1024;

/// The value of the pattern at (x, y, z), pipeline included. Octaves are held in 1..10, waves in 1..1000.
/// POV-Ray's limit of coordinates to +-1e17 is left out.
Expression buildPattern(const Pattern& pattern, Expression x, Expression y, Expression z,
                        int sceneNoiseGenerator);

/// The two halves of buildPattern, for maps whose entries are looked up at the pattern's place too: where the
/// pattern is looked up for a point, and its value there.
PatternPoint patternPoint(const Pattern& pattern, const PatternPoint& point);
Expression patternValue(const Pattern& pattern, const PatternPoint& at, int sceneNoiseGenerator);

/// Whether the raw values are whole numbers that count the entries of a list: checker, brick, hexagon,
/// square, cubic, triangular.
bool isDiscrete(PatternKind kind);

/// Whether frequency, phase and wave form leave such numbers as they are.
bool keepsWholeNumbers(const Pattern& pattern);

}  // namespace isoscope

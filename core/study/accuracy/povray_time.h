// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "core/evaluate/tape/tape.h"
#include "core/render/render_request.h"

namespace isoscope {

/// How much one evaluation of a function does, counted by what POV-Ray takes about equally long for. Steps of
/// loops count as often as they are run, where their bounds are known; else ten times.
struct FunctionWork {
    double products = 0;       ///< by POV-Ray's interpreter
    double sums = 0;           ///< choices and comparisons, too, by the interpreter
    double nativeSteps = 0;    ///< all of these inside of built-in functions and pigments, which are compiled
    double calls = 0;          ///< of built-in functions
    double declaredCalls = 0;  ///< of functions of the text
    double patternCalls = 0;   ///< of pattern functions
    double pigmentCalls =
        0;                 ///< of pigments as functions, which the text has declared: those with a component
    double quotients = 0;  ///< divisions, square roots, roundings
    double waves = 0;      ///< trigonometric and exponential functions
    double powers = 0;     ///< pow, atan2, mod
    double noises = 0;     ///< lookups of the noise
    double vectorNoises = 0;  ///< components of the vector noise
    double cells = 0;         ///< lookups of crackle and of tables
    double timedCalls = 0;    ///< nanoseconds in calls whose time is known by itself (povrayCallTime)

    FunctionWork& operator+=(const FunctionWork& other);
    FunctionWork operator*(double factor) const;
};

/// As if the interpreter did it all, without any call.
FunctionWork workOf(const Tape& tape, std::span<const double> parameters);

/// By what is written (WrittenWork) where that is all: operators, and calls whose time is known
/// (povrayCallTime). Elsewhere it tells the steps of the interpreter from those of built-in functions and
/// pigments: only as many operators as are written are the interpreter's.
FunctionWork workOf(const SceneIsosurface& isosurface, std::span<const double> parameters);

/// What a small picture by POV-Ray's method took; deterministic.
struct PovrayCounts {
    std::uint64_t pixels = 0;
    std::uint64_t hits = 0;                ///< pixels that show something
    std::uint64_t rays = 0;                ///< of the camera and of shadows, mirrors and glass
    std::uint64_t evaluations = 0;         ///< by all of them
    std::uint64_t primaryEvaluations = 0;  ///< by the camera's
    std::uint64_t shadowEvaluations = 0;   ///< by those towards lights
    double repeatedEvaluations = 0;        ///< those that POV-Ray takes twice: see countForPovray()
    FunctionWork work;                     ///< of one evaluation; the mean where there are several functions
    bool complete = false;

    /// How many evaluations all rays take for one by the camera's.
    double lightFactor() const;
};

/// Draws the request at `width` pixels across, with POV-Ray's method and without smooth edges, and counts.
/// From the first shadow on POV-Ray asks the object that has thrown the last one first, and, if it is not in
/// the way, all objects, that one again: its count of intersection tests is one for each ray in a shadow and
/// two for each other ray.
PovrayCounts countForPovray(RenderRequest request, int width, std::stop_token stop = {});

/// Processor seconds that POV-Ray 3.7 needs for a picture of so many pixels with one sample each, on this
/// machine. What it is off by: povrayTimeError. The figures behind it were fitted to measured times by
/// tools/povray-time, which also prints how well they do.
double povraySeconds(const PovrayCounts& counts, double pixels);

/// The same when the camera's rays take `evaluationsPerPixel` instead of what was counted.
double povraySeconds(const PovrayCounts& counts, double pixels, double evaluationsPerPixel);

/// What a prediction may be off by, as a person is told. 24 of 25 of the scenes that the figures were
/// fitted to are within half of that, but a machine that others use takes half as long again now and then.
constexpr double povrayTimeError = 0.5;

/// How much longer this machine takes for scalar arithmetic than the one that the figures were fitted on;
/// measured once, in some milliseconds of processor time.
double machineSlowness();

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope::bench {

/// Functions like those of the bench scenes; the formulas are in bench_formulas-inl.h.
enum class BenchFunction { sphere, torus, klein, barth, gyroid, blend, csg };

constexpr BenchFunction benchFunctions[] = {
    BenchFunction::sphere, BenchFunction::torus, BenchFunction::klein, BenchFunction::barth,
    BenchFunction::gyroid, BenchFunction::blend, BenchFunction::csg};

constexpr const char* name(BenchFunction function) {
    constexpr const char* names[] = {"sphere", "torus", "klein", "barth", "gyroid", "blend", "csg"};
    return names[static_cast<int>(function)];
}

}  // namespace isoscope::bench

// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of overlaid waves from several sources: ripples and waves.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/function/builtins/formula_blocks.h"
#include "core/function/patterns/pattern_call.h"
#include "core/function/patterns/wave_sources.h"
#include "core/numeric/linear_congruential.h"
#include "core/numeric/noise.h"

namespace isoscope {

namespace {

constexpr int mostWaves = 1000;

}  // namespace

std::vector<WaveSource> waveSources(int count) {
    std::vector<WaveSource> sources;
    count = std::clamp(count, 1, mostWaves);
    LinearCongruential random(3734115329u);
    for (int i = 0; i < count; ++i) {
        const auto d = vectorNoise(i, 0, 0);
        const double size = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        sources.push_back(
            {{d[0] / size, d[1] / size, d[2] / size}, random.next() * 0.000030518509476 + 0.01});
    }
    return sources;
}

namespace {

Expression distanceFrom(const PatternCall& call, const WaveSource& source) {
    const auto& s = source.position;
    const Expression distance = length(call.x - s[0], call.y - s[1], call.z - s[2]);
    return select(distance, distance, call.number(1), distance);
}

}  // namespace

Expression wavePattern(const PatternCall& call) {
    const Pattern& pattern = call.pattern;
    const std::vector<WaveSource> sources = waveSources(pattern.numberOfWaves);
    const double frequency = singlePrecision(pattern.frequency.value_or(1));
    const double phase = singlePrecision(pattern.phase.value_or(0));
    const bool isRipples = pattern.kind == PatternKind::ripples;
    Expression sum = call.number(0);
    for (const WaveSource& source : sources) {
        Expression t = distanceFrom(call, source);
        if (frequency != 1) t = t * frequency;
        if (!isRipples) t = t * source.frequency;
        if (phase != 0) t = t + phase;
        const Expression wave = cycle(t);
        sum = sum + (isRipples ? wave : wave / source.frequency);
    }
    const Expression mean = sum / static_cast<double>(sources.size());
    return isRipples ? 0.5 * (1 + mean) : 0.2 * (2.5 + mean);
}

}  // namespace isoscope

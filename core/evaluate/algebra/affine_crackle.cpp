// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_crackle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/algebra/distance_lines.h"
#include "core/function/scalar_operations.h"
#include "core/numeric/crackle.h"
#include "core/numeric/crackle_candidates.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr AffineForm unknownForm{0, 0, infinite};
constexpr double roundings = DistanceLines::roundings;
/// The same after powers.
constexpr double powerRoundings = 1e-12;
/// Beyond these, coordinates have no cell, give or take.
constexpr double lastCell = 4e18;

AffineForm between(double low, double high) {
    const double center = low + (high - low) / 2;
    return {center, 0, (high - low) / 2 + roundings * std::max(std::abs(low), std::abs(high))};
}

LinePiece pieceOf(std::span<const AffineForm> operands) {
    LinePiece piece;
    double slopes = 0, errors = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const AffineForm& p = operands[k];
        piece.center[k] = p.a;
        piece.slope[k] = p.b;
        piece.error[k] = p.e;
        piece.reach = std::max(piece.reach, (std::abs(p.b) + p.e) * (1 + roundings));
        slopes += p.b * p.b;
        errors += p.e * p.e;
    }
    piece.length = std::sqrt(slopes) * (1 + roundings);
    piece.spread = std::sqrt(errors) * (1 + roundings);
    return piece;
}

/// In other metrics a distance is between those of the nearest and the furthest coordinates.
DistanceLine generalLine(const LinePiece& piece, double x, double y, double z,
                         const CrackleSettings& settings) {
    const std::array<double, 3> point{x, y, z};
    std::array<double, 3> least, furthest;
    for (std::size_t k = 0; k < 3; ++k) {
        const double apart = std::abs(piece.center[k] - point[k]);
        const double reach = std::abs(piece.slope[k]) + piece.error[k] + roundings;
        least[k] = std::max(0.0, apart - reach);
        furthest[k] = apart + reach;
    }
    const auto finished = [&](const std::array<double, 3>& d) {
        const double distance = crackleNorm(d[0], d[1], d[2], settings.metric);
        if (settings.offset == 0) return distance;
        return crackleNorm(distance, settings.offset, 0, settings.metric);
    };
    const double low = finished(least), high = finished(furthest);
    const double rounding = powerRoundings * high + roundings;
    return {0, low - rounding, high + rounding};
}

void writeGeneralLines(const LinePiece& piece, const CrackleCandidates& found,
                       const CrackleSettings& settings, DistanceLines& lines) {
    lines.count = found.count;
    for (std::size_t i = 0; i < found.count; ++i) {
        const DistanceLine line = generalLine(piece, found.x[i], found.y[i], found.z[i], settings);
        lines.slope[i] = line.slope;
        lines.low[i] = line.low;
        lines.high[i] = i < found.always ? line.high : infinite;
    }
}

bool hasCrackleMetric(const CrackleSettings& settings) {
    // A power of an offset below 0 has no value.
    return settings.metric >= 1 / greatestCrackleMetric && settings.metric <= greatestCrackleMetric &&
           (settings.metric == 2 || settings.offset >= 0);
}

/// How many of the distances count.
int orderOf(const CrackleSettings& settings) {
    return settings.form[2] != 0 ? 3 : settings.form[1] != 0 ? 2 : 1;
}

/// min(1, max(0, p)).
AffineForm clipped(AffineForm p) {
    const double reach = std::abs(p.b) + p.e, low = p.a - reach, high = p.a + reach;
    if (!(low < 0 || high > 1)) return p;
    if (high <= 0) return {0, 0, 0};
    if (low >= 1) return {1, 0, 0};
    if (low < 0 && high > 1) return {0.5, 0, 0.5};
    // Between the chord and the line without a slope.
    const double part = low < 0 ? high / (high - low) : (1 - low) / (high - low);
    const double rest = low < 0 ? -low * part : (high - 1) * part;
    AffineForm result{p.a * part, p.b * part, p.e * part + rest / 2};
    result.a += low < 0 ? rest / 2 : 1 - part - rest / 2;
    const double bottom = std::max(low, 0.0), top = std::min(high, 1.0);
    const AffineForm flat = between(bottom, top);
    if (!(result.e <= flat.e / 2)) return flat;
    result.e += roundings * (1 + reach);
    return result;
}

}  // namespace

bool hasCrackleBounds(const CrackleSettings& settings) {
    return !settings.table && !settings.cells && !settings.solid && hasCrackleMetric(settings);
}

AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    if (settings.table) return between(settings.table->low(), settings.table->high());
    for (const AffineForm& p : operands)
        if (!(std::abs(p.a) + std::abs(p.b) + p.e < lastCell)) return unknownForm;
    constexpr AffineForm anywhere{0.5, 0, 0.5};
    if (settings.cells || settings.solid) return anywhere;
    const LinePiece piece = pieceOf(operands);
    const int order = orderOf(settings);
    if (!hasCrackleMetric(settings)) return unknownForm;
    const CrackleCube cube{piece.center, std::max(piece.reach, thriftyCrackleReach)};
    const CrackleCandidates* found = crackleCandidates(cube, settings.metric, order);
    if (!found) return anywhere;
    DistanceLines lines;
    if (settings.metric == 2)
        writeEuclideanLines(piece, *found, settings.offset, static_cast<std::size_t>(order), lines);
    else
        writeGeneralLines(piece, *found, settings, lines);
    AffineForm sum{0, 0, 0};
    double low = 0, high = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double form = settings.form[k];
        if (form == 0) continue;
        const DistanceLine line = orderedDistance(lines, k);
        sum.b += form * line.slope;
        low += form * (form > 0 ? line.low : line.high);
        high += form * (form > 0 ? line.high : line.low);
        size += std::abs(form) * (std::abs(line.high) + std::abs(line.slope));
    }
    sum.a = (low + high) / 2;
    sum.e = (high - low) / 2 + roundings * size;
    return clipped(sum);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_crackle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/evaluate/algebra/affine_form.h"
#include "core/function/scalar_operations.h"
#include "core/numeric/crackle.h"
#include "core/numeric/crackle_candidates.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr AffineForm unknownForm{0, 0, infinite};
/// More than what the roundings of a few operations amount to, as a part of the largest number among them.
constexpr double roundings = 1e-14;
/// The same after powers.
constexpr double powerRoundings = 1e-12;
/// Beyond these, coordinates have no cell, give or take.
constexpr double lastCell = 4e18;

AffineForm between(double low, double high) {
    const double center = low + (high - low) / 2;
    return {center, 0, (high - low) / 2 + roundings * std::max(std::abs(low), std::abs(high))};
}

/// A piece of a ray: center + slope s, each coordinate give or take its error.
struct Piece {
    std::array<double, 3> center, slope, error;
    double reach = 0;   ///< no coordinate is further from the center
    double length = 0;  ///< Euclidean, of slope
    double spread = 0;  ///< and of the errors
};

Piece pieceOf(std::span<const AffineForm> operands) {
    Piece piece;
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

/// A distance along a piece: center + slope s + [low, high].
struct DistanceLine {
    double center, slope, low, high;
};

/// sqrt(|p - point|^2 + offset^2) and its tangent in the middle: d'' is all that makes it rise above.
DistanceLine euclideanLine(const Piece& piece, double x, double y, double z, double offset) {
    const double dx = piece.center[0] - x, dy = piece.center[1] - y, dz = piece.center[2] - z;
    const double middle = std::sqrt(dx * dx + dy * dy + dz * dz + offset * offset);
    const double along = dx * piece.slope[0] + dy * piece.slope[1] + dz * piece.slope[2];
    const double rounding = roundings * (middle + piece.length) + piece.spread;
    if (!(middle > 1.001 * piece.length)) {
        const double reach = std::min(middle, piece.length);
        return {middle, 0, -reach - rounding, piece.length + rounding};
    }
    const double slope = along / middle;
    // d^2 - tangent^2 = (length^2 - slope^2) s^2, and neither is less than middle - |slope|.
    double bend = (piece.length * piece.length - slope * slope) / (2 * (middle - std::abs(slope)));
    bend = std::min(bend, 2 * piece.length);
    return {middle, slope, -rounding, bend + rounding};
}

/// In other metrics a distance is between those of the nearest and the furthest coordinates.
DistanceLine generalLine(const Piece& piece, double x, double y, double z, const CrackleSettings& settings) {
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
    const double center = (low + high) / 2, rounding = powerRoundings * high + roundings;
    return {center, 0, low - center - rounding, high - center + rounding};
}

/// The least three of many numbers.
class LeastThree {
  public:
    void add(double number, std::size_t index) {
        if (!(number < numbers[2])) return;
        put(2, number, index);
        if (!(number < numbers[1])) return;
        put(2, numbers[1], indices[1]);
        put(1, number, index);
        if (!(number < numbers[0])) return;
        put(1, numbers[0], indices[0]);
        put(0, number, index);
    }

    std::array<double, 3> numbers{infinite, infinite, infinite};
    std::array<std::size_t, 3> indices{};

  private:
    void put(std::size_t place, double number, std::size_t index) {
        numbers[place] = number;
        indices[place] = index;
    }
};

/// The distances to the candidates that count along a piece.
struct Lines {
    std::size_t count = 0;
    std::size_t always = 0;  ///< of them, those to points that are looked at from everywhere
    std::array<DistanceLine, CrackleCandidates::most> line;
    std::array<std::size_t, 3> nearest{};  ///< lines of the nearest in the middle
};

/// Fills `lines`, but for those who are further from all of the piece than the `order` nearest.
void euclideanLines(const Piece& piece, const CrackleCandidates& found, double offset, std::size_t order,
                    Lines& lines) {
    std::array<double, CrackleCandidates::most> squares;
    LeastThree nearest;
    for (std::size_t i = 0; i < found.count; ++i) {
        const double dx = piece.center[0] - found.x[i], dy = piece.center[1] - found.y[i],
                     dz = piece.center[2] - found.z[i];
        squares[i] = dx * dx + dy * dy + dz * dz;
    }
    for (std::size_t i = 0; i < found.always; ++i) nearest.add(squares[i], i);
    // Distances change by no more than the piece is long.
    const double furthest =
        (std::sqrt(nearest.numbers[order - 1]) + 2 * (piece.length + piece.spread)) * (1 + roundings);
    const double limit = furthest * furthest * (1 + roundings);
    for (std::size_t i = 0; i < found.count; ++i) {
        if (squares[i] > limit) continue;
        for (std::size_t k = 0; k < order; ++k)
            if (nearest.indices[k] == i) lines.nearest[k] = lines.count;
        lines.always += i < found.always;
        lines.line[lines.count++] = euclideanLine(piece, found.x[i], found.y[i], found.z[i], offset);
    }
}

void generalLines(const Piece& piece, const CrackleCandidates& found, const CrackleSettings& settings,
                  Lines& lines) {
    LeastThree nearest;
    for (std::size_t i = 0; i < found.count; ++i) {
        lines.line[i] = generalLine(piece, found.x[i], found.y[i], found.z[i], settings);
        if (i < found.always) nearest.add(lines.line[i].center, i);
    }
    lines.count = found.count;
    lines.always = found.always;
    lines.nearest = nearest.indices;
}

/// The distance of an order, less `slope` s, as bounds: those of that order of all bounds. Every candidate
/// counts for the lower one, those that are always looked at for the upper one.
DistanceLine ordered(const Lines& lines, std::size_t order) {
    const double slope = lines.line[lines.nearest[order]].slope;
    LeastThree lows, highs;
    for (std::size_t i = 0; i < lines.count; ++i) {
        const DistanceLine& line = lines.line[i];
        const double turn = std::abs(line.slope - slope);
        lows.add(line.center + line.low - turn, i);
        if (i < lines.always) highs.add(line.center + line.high + turn, i);
    }
    return {0, slope, lows.numbers[order], highs.numbers[order]};
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
    const Piece piece = pieceOf(operands);
    const int order = orderOf(settings);
    if (!hasCrackleMetric(settings)) return unknownForm;
    const CrackleCandidates* found = crackleCandidates({piece.center, piece.reach}, settings.metric, order);
    if (!found) return anywhere;
    Lines lines;
    if (settings.metric == 2)
        euclideanLines(piece, *found, settings.offset, static_cast<std::size_t>(order), lines);
    else
        generalLines(piece, *found, settings, lines);
    AffineForm sum{0, 0, 0};
    double low = 0, high = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double form = settings.form[k];
        if (form == 0) continue;
        const DistanceLine line = ordered(lines, k);
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

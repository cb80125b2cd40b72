// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_crackle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/algebra/euclidean_crackle.h"
#include "core/function/scalar_operations.h"
#include "core/numeric/crackle.h"
#include "core/numeric/crackle_candidates.h"
#include "core/numeric/interval.h"
#include "core/numeric/noise.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr AffineForm unknownForm{0, 0, infinite}, anywhere{0.5, 0, 0.5};
constexpr double roundings = crackleRoundings;
/// The same after powers.
constexpr double powerRoundings = 1e-12;

/// A piece of a ray: center + slope s for s from -1 to 1, each coordinate give or take its error.
struct LinePiece {
    std::array<double, 3> center, slope, error;
    double reach = 0;  ///< no coordinate is further from the center
};

/// A distance along a piece: slope s + [low, high].
struct DistanceLine {
    double slope, low, high;
};

/// The distances along a piece to the points that crackle looks at.
struct DistanceLines {
    std::size_t count = 0;
    /// There is no upper bound, infinity, for a point that not all of the piece look at.
    std::array<DistanceLine, CrackleCandidates::most> lines;
    std::array<std::size_t, 3> nearest{};  ///< points that are the nearest in the middle, up to the order
};

AffineForm between(double low, double high) {
    const double center = low + (high - low) / 2;
    return {center, 0, (high - low) / 2 + roundings * std::max(std::abs(low), std::abs(high))};
}

LinePiece pieceOf(std::span<const AffineForm> operands) {
    LinePiece piece;
    for (std::size_t k = 0; k < 3; ++k) {
        const AffineForm& p = operands[k];
        piece.center[k] = p.a;
        piece.slope[k] = p.b;
        piece.error[k] = p.e;
        piece.reach = std::max(piece.reach, (std::abs(p.b) + p.e) * (1 + roundings));
    }
    return piece;
}

/// A distance in another metric: of three coordinates, and the offset as a fourth one.
class GeneralDistance {
  public:
    explicit GeneralDistance(const CrackleSettings& settings)
        : metric_(settings.metric), offset_(settings.offset) {}

    double of(const std::array<double, 3>& way) const {
        const double distance = length(way);
        return offset_ == 0 ? distance : crackleNorm(distance, offset_, 0, metric_);
    }
    /// Without the offset.
    double length(const std::array<double, 3>& way) const {
        return crackleNorm(std::abs(way[0]), std::abs(way[1]), std::abs(way[2]), metric_);
    }
    /// How it changes along `direction` at `way`, where it is `distance`; where it has an edge, a slope
    /// between those of both sides.
    double slope(const std::array<double, 3>& way, const std::array<double, 3>& direction,
                 double distance) const {
        double sum = 0;
        for (std::size_t k = 0; k < 3 && distance > 0; ++k) {
            if (way[k] == 0) continue;
            const double part = metric_ == 1 ? 1 : std::pow(std::abs(way[k]) / distance, metric_ - 1);
            sum += std::copysign(part, way[k]) * direction[k];
        }
        return sum;
    }
    /// Whether it is a norm, so that it is convex along a line.
    bool isNorm() const { return metric_ >= 1; }

  private:
    double metric_, offset_;
};

/// In metrics below 1 a distance is between those of the nearest and the furthest coordinates.
DistanceLine boxedLine(const LinePiece& piece, const std::array<double, 3>& middle,
                       const GeneralDistance& distance) {
    std::array<double, 3> least, furthest;
    for (std::size_t k = 0; k < 3; ++k) {
        const double apart = std::abs(middle[k]);
        const double reach = std::abs(piece.slope[k]) + piece.error[k] + roundings;
        least[k] = std::max(0.0, apart - reach);
        furthest[k] = apart + reach;
    }
    const double low = distance.of(least), high = distance.of(furthest);
    const double rounding = powerRoundings * high + roundings;
    return {0, low - rounding, high + rounding};
}

/// In the others it lies between its chord and its tangents at both ends and in the middle; off the line it
/// changes by no more than the way there is long.
DistanceLine convexLine(const LinePiece& piece, const std::array<double, 3>& middle,
                        const GeneralDistance& distance) {
    const auto at = [&](double s) {
        std::array<double, 3> way;
        for (std::size_t k = 0; k < 3; ++k) way[k] = middle[k] + s * piece.slope[k];
        return way;
    };
    const std::array<double, 3> first = at(-1), last = at(1);
    const double begin = distance.of(first), center = distance.of(middle), end = distance.of(last);
    const double slope = (end - begin) / 2, chord = begin + (end - begin) / 2;
    // The tangents at the ends, in relation to the chord, meet at or below the least value.
    const double down = std::min(0.0, distance.slope(first, piece.slope, begin) - slope);
    const double up = std::max(0.0, distance.slope(last, piece.slope, end) - slope);
    const double ends = up > down ? chord + 2 * up * down / (up - down) : chord;
    const double flat = center - std::abs(distance.slope(middle, piece.slope, center) - slope);
    const double rounding = distance.length(piece.error) + powerRoundings * std::max(begin, end) + roundings;
    return {slope, std::max(ends, flat) - rounding, chord + rounding};
}

void writeGeneralLines(const LinePiece& piece, const CrackleCandidates& found,
                       const CrackleSettings& settings, std::size_t order, DistanceLines& lines) {
    const GeneralDistance distance(settings);
    std::array<std::pair<double, std::size_t>, CrackleCandidates::most> centers;
    lines.count = found.count;
    for (std::size_t i = 0; i < found.count; ++i) {
        const std::array<double, 3> middle{piece.center[0] - found.x[i], piece.center[1] - found.y[i],
                                           piece.center[2] - found.z[i]};
        DistanceLine& line = lines.lines[i];
        line = distance.isNorm() ? convexLine(piece, middle, distance) : boxedLine(piece, middle, distance);
        centers[i] = {(line.low + line.high) / 2, i};
        if (i >= found.always) line.high = infinite;
    }
    std::partial_sort(centers.begin(), centers.begin() + static_cast<std::ptrdiff_t>(order),
                      centers.begin() + static_cast<std::ptrdiff_t>(found.always));
    for (std::size_t k = 0; k < order; ++k) lines.nearest[k] = centers[k].second;
}

/// The distance of an order (0: the least), along the slope of the one that is in the middle: those of that
/// order of all bounds.
DistanceLine orderedDistance(const DistanceLines& lines, std::size_t order) {
    const double slope = lines.lines[lines.nearest[order]].slope;
    std::array<double, CrackleCandidates::most> lows, highs;
    for (std::size_t i = 0; i < lines.count; ++i) {
        const DistanceLine& line = lines.lines[i];
        const double turn = std::abs(line.slope - slope);
        lows[i] = line.low - turn;
        highs[i] = line.high + turn;
    }
    const auto least = [&](std::array<double, CrackleCandidates::most>& bounds) {
        const auto nth = bounds.begin() + static_cast<std::ptrdiff_t>(order);
        std::nth_element(bounds.begin(), nth, bounds.begin() + static_cast<std::ptrdiff_t>(lines.count));
        return *nth;
    };
    return {slope, least(lows), least(highs)};
}

/// From the least to the greatest of some numbers.
class Extent {
  public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    /// Exact where all are the same.
    AffineForm form() const { return low_ == high_ ? AffineForm{low_, 0, 0} : between(low_, high_); }

  private:
    double low_ = infinite, high_ = -infinite;
};

/// Of `cells`: between the values of the cells that the piece may meet, as long as they are few.
AffineForm cellsForm(std::span<const AffineForm> operands) {
    constexpr double most = 64;
    std::array<double, 3> first, last;
    double count = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const AffineForm& p = operands[k];
        const double reach = std::abs(p.b) + p.e;
        // What a form without a reach says is exact.
        const double rounding = reach == 0 ? 0 : roundings * (std::abs(p.a) + reach);
        first[k] = std::floor(p.a - reach - rounding);
        last[k] = std::floor(p.a + reach + rounding);
        count *= last[k] - first[k] + 1;
    }
    if (!(count <= most)) return anywhere;
    Extent extent;
    for (double i = first[0]; i <= last[0]; ++i)
        for (double j = first[1]; j <= last[1]; ++j)
            for (double k = first[2]; k <= last[2]; ++k) extent.add(cellValue(i, j, k));
    return extent.form();
}

/// Of what is looked up: beside its chord where it is straight enough, else between its bounds.
AffineForm tableForm(std::span<const AffineForm> operands, const PointTable& table) {
    std::array<Interval, 3> box;
    std::array<double, 3> slope, errors, first, last;
    bool isPlace = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const AffineForm& p = operands[k];
        const double reach = std::abs(p.b) + p.e;
        const double rounding = reach == 0 ? 0 : roundings * (std::abs(p.a) + reach);
        isPlace = isPlace && std::abs(p.a) + reach < lastCrackleCell;
        box[k] = {p.a - reach - rounding, p.a + reach + rounding, false};
        slope[k] = p.b;
        errors[k] = p.e + rounding;
        first[k] = p.a - p.b;
        last[k] = p.a + p.b;
    }
    const Interval range = table.range(box);
    if (range.isPoint()) return {range.low, 0, 0};
    const AffineForm flat = between(range.low, range.high);
    if (!isPlace) return flat;
    const auto [bend, spread] = table.straightness(box, slope, errors);
    if (!(bend + spread < flat.e / 2)) return flat;
    const double begin = table.value(first), end = table.value(last);
    const double rounding = roundings * std::max(std::abs(begin), std::abs(end));
    return {begin + (end - begin) / 2, (end - begin) / 2, bend + spread + rounding};
}

/// Of `solid`: between the values of the cell points that can be the nearest.
AffineForm solidForm(const CrackleCandidates& found, const DistanceLines& lines, int noiseGenerator) {
    const auto isNearerThan = [&](std::size_t i, std::size_t j) {
        const DistanceLine &nearer = lines.lines[i], &further = lines.lines[j];
        return further.low - nearer.high > std::abs(further.slope - nearer.slope);
    };
    Extent extent;
    for (std::size_t j = 0; j < lines.count; ++j) {
        bool counts = true;
        for (std::size_t i = 0; i < lines.count && counts; ++i) counts = !isNearerThan(i, j);
        if (counts) extent.add(noise(noiseGenerator, found.x[j], found.y[j], found.z[j]));
    }
    return extent.form();
}

bool hasCrackleMetric(const CrackleSettings& settings) {
    // A power of an offset below 0 has no value.
    return settings.metric >= 1 / greatestCrackleMetric && settings.metric <= greatestCrackleMetric &&
           (settings.metric == 2 || settings.offset >= 0);
}

/// min(1, max(0, p)) of a form of which something is known.
AffineForm clipped(AffineForm p) {
    const double reach = std::abs(p.b) + p.e, low = p.a - reach, high = p.a + reach;
    if (!(low < 0 || high > 1) || !std::isfinite(p.e)) return p;
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

/// Whether distances are the Euclidean ones, and nothing is put in their place.
bool isEuclidean(const CrackleSettings& settings) {
    return !settings.table && !settings.cells && settings.metric == 2;
}

/// Of a single piece, as the first lane of a vector.
AffineForm euclideanForm(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    constexpr std::size_t vector = 8;
    struct Columns {
        std::array<double, vector> a{}, b{}, e{};
    };
    std::array<Columns, 3> columns;
    for (std::size_t k = 0; k < 3; ++k) {
        columns[k].a[0] = operands[k].a;
        columns[k].b[0] = operands[k].b;
        columns[k].e[0] = operands[k].e;
    }
    const auto place = [&](std::size_t k) {
        return FormColumn{columns[k].a.data(), columns[k].b.data(), columns[k].e.data()};
    };
    Columns result;
    writeEuclideanCrackle({place(0), place(1), place(2)}, settings, 1,
                          {result.a.data(), result.b.data(), result.e.data()});
    return clipped({result.a[0], result.b[0], result.e[0]});
}

/// Of what is not Euclidean.
AffineForm otherForm(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    if (settings.table) return tableForm(operands, *settings.table);
    for (const AffineForm& p : operands)
        if (!(std::abs(p.a) + std::abs(p.b) + p.e < lastCrackleCell)) return unknownForm;
    if (settings.cells) return cellsForm(operands);
    const LinePiece piece = pieceOf(operands);
    const int order = orderOfCrackle(settings);
    if (!hasCrackleMetric(settings)) return unknownForm;
    const CrackleCube cube{piece.center, std::max(piece.reach, thriftyCrackleReach)};
    const CrackleCandidates* found = crackleCandidates(cube, settings.metric, order);
    if (!found) return anywhere;
    DistanceLines lines;
    writeGeneralLines(piece, *found, settings, static_cast<std::size_t>(order), lines);
    if (settings.solid) return solidForm(*found, lines, settings.noiseGenerator);
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

}  // namespace

bool hasCrackleBounds(const CrackleSettings& settings) {
    return settings.table ? settings.table->hasRanges() : settings.cells || hasCrackleMetric(settings);
}

AffineForm affineCrackle(std::span<const AffineForm> operands, const CrackleSettings& settings) {
    if (isEuclidean(settings)) return euclideanForm(operands, settings);
    return otherForm(operands, settings);
}

void writeAffineCrackle(const std::array<FormColumn, 3>& place, const CrackleSettings& settings,
                        std::size_t lanes, const std::array<double*, 3>& result) {
    const auto write = [&](std::size_t i, const AffineForm& form) {
        result[0][i] = form.a;
        result[1][i] = form.b;
        result[2][i] = form.e;
    };
    if (isEuclidean(settings)) {
        writeEuclideanCrackle(place, settings, lanes, result);
        for (std::size_t i = 0; i < lanes; ++i) write(i, clipped({result[0][i], result[1][i], result[2][i]}));
        return;
    }
    for (std::size_t i = 0; i < lanes; ++i) {
        std::array<AffineForm, 3> forms;
        for (std::size_t k = 0; k < 3; ++k) forms[k] = {place[k].a[i], place[k].b[i], place[k].e[i]};
        write(i, otherForm(forms, settings));
    }
}

}  // namespace isoscope

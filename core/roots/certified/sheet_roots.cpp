// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/sheet_roots.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/sheet_roots.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/roots/certified/newton_polish.h"

#ifndef ISOSCOPE_ROOTS_BUNDLE_ROOTS_ONCE
#define ISOSCOPE_ROOTS_BUNDLE_ROOTS_ONCE
namespace isoscope {

/// What the last steps have to go by.
struct SettleRules {
    const RootSettings& settings;
    double sufficient;
    double* starts;  ///< of CertainStarts
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, batchLanes>;
using Vector = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
using Group = SheetRoots::Group;

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(Doubles(), from); }
HWY_INLINE void save(Vector value, double* to) { hn::StoreU(value, Doubles(), to); }

/// What is not a number becomes the beginning.
HWY_INLINE Vector within(const MonotoneStretch& stretch, Vector t) {
    const Vector low = constant(stretch.low);
    return hn::Min(hn::IfThenElse(hn::Gt(t, low), t, low), constant(stretch.high));
}

/// Puts line `i` and those behind it at `t`, as rows `row` and behind.
HWY_INLINE void placeAt(Vector t, const LineColumns& lines, std::size_t i, const Group& group,
                        std::size_t row) {
    save(t, group[SheetRoots::t] + row);
    for (std::size_t c = 0; c < 3; ++c)
        save(hn::Add(load(lines.origin[c] + i), hn::Mul(t, load(lines.direction[c] + i))),
             group[SheetRoots::x + c] + row);
}

/// Puts the lines of a stretch where they meet its plane.
HWY_INLINE void placeOnPlane(const LineColumns& lines, const MonotoneStretch& stretch, const Group& group,
                             std::size_t row) {
    for (std::size_t k = 0; k < stretch.count; k += hn::Lanes(Doubles())) {
        const std::size_t i = stretch.first + k;
        Vector slope = hn::Zero(Doubles()), ahead = constant(stretch.offset);
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector gradient = constant(stretch.gradient[static_cast<int>(c)]);
            slope = hn::MulAdd(gradient, load(lines.direction[c] + i), slope);
            ahead = hn::NegMulAdd(gradient, load(lines.origin[c] + i), ahead);
        }
        const Vector low = constant(stretch.low);
        const Mask usual =
            hn::And(hn::FirstN(Doubles(), stretch.count - k),
                    hn::And(hn::Le(load(lines.near + i), low), hn::Gt(load(lines.far + i), low)));
        save(hn::IfThenElseZero(usual, constant(1)), group[SheetRoots::open] + row + k);
        placeAt(within(stretch, hn::Div(ahead, slope)), lines, i, group, row + k);
        // The slope there, as far as it changes like that of the middle line.
        slope = hn::Sub(slope, constant(stretch.slopeChangeOffset));
        for (std::size_t c = 0; c < 3; ++c)
            slope = hn::MulAdd(constant(stretch.slopeChange[static_cast<int>(c)]),
                               load(group[SheetRoots::x + c] + row + k), slope);
        save(slope, group[SheetRoots::slope] + row + k);
    }
}

/// One step of Newton's with the slope that is expected there, and with what that changes on the way. Returns
/// how many lines may well be farther from the root afterwards than a last step goes: that they are off by a
/// fourth of what the change of the slope makes is about what is seen.
HWY_INLINE std::size_t stepOnPlane(const LineColumns& lines, const MonotoneStretch& stretch,
                                   const double* values, double threshold, const Group& group,
                                   std::size_t row) {
    const Vector turn = constant(0.5 * glm::dot(stretch.slopeChange, stretch.direction));
    const Vector longest = constant(4 * (NewtonPolish::lastStep * stretch.tolerance));
    std::size_t left = 0;
    for (std::size_t k = 0; k < stretch.count; k += hn::Lanes(Doubles())) {
        double* const slopes = group[SheetRoots::slope] + row + k;
        const Vector value = hn::Sub(load(values + k), constant(threshold));
        const Vector perSlope = hn::Div(constant(1), load(slopes));
        const Vector way = hn::Mul(value, perSlope);
        const Vector change = hn::Mul(way, hn::Mul(turn, perSlope));
        const Vector step = hn::MulAdd(way, change, way);
        save(hn::NegMulAdd(hn::Add(turn, turn), step, load(slopes)), slopes);
        placeAt(within(stretch, hn::Sub(load(group[SheetRoots::t] + row + k), step)), lines,
                stretch.first + k, group, row + k);
        const Mask far = hn::Gt(hn::Abs(hn::Mul(way, change)), longest);
        left += hn::CountTrue(
            Doubles(), hn::And(far, hn::Gt(load(group[SheetRoots::open] + row + k), hn::Zero(Doubles()))));
    }
    return left;
}

/// The lanes of `mask` to `line` and those behind.
HWY_INLINE void putRoots(Mask mask, std::size_t line, Vector t, const Vector (&normal)[3], Vector length,
                         FirstRoots& roots) {
    const auto put = [&](std::size_t column, Vector value) HWY_ATTR {
        hn::BlendedStore(value, mask, Doubles(), roots.crossings[column] + line);
    };
    put(FirstRoots::t, t);
    const Vector perLength = hn::Div(constant(1), length);
    for (std::size_t c = 0; c < 3; ++c) put(FirstRoots::normalX + c, hn::Mul(normal[c], perLength));
}

/// One step of Newton's with the slope at hand. What settles goes to `roots`; returns how many lines do not.
HWY_INLINE std::size_t stepExactly(const LineColumns& lines, const MonotoneStretch& stretch,
                                   const GradientLanes& gradients, const SettleRules& rules,
                                   const Group& group, std::size_t row, FirstRoots& roots) {
    const Vector threshold = constant(rules.settings.threshold);
    const Vector polarity = constant(rules.settings.positivePolarity ? -1 : 1);
    const Vector longest = constant(NewtonPolish::lastStep * stretch.tolerance);
    const Vector largest = constant(0.5 * stretch.least * stretch.tolerance - stretch.rounding);
    std::size_t left = 0;
    for (std::size_t k = 0; k < stretch.count; k += hn::Lanes(Doubles())) {
        const std::size_t i = stretch.first + k;
        double* const open = group[SheetRoots::open] + row + k;
        const Mask asked = hn::Gt(load(open), hn::Zero(Doubles()));
        const Vector value = hn::Sub(load(gradients.value + row + k), threshold);
        Vector normal[3], slope = hn::Zero(Doubles()), square = slope;
        for (std::size_t c = 0; c < 3; ++c) {
            normal[c] = load(gradients.gradient[c] + row + k);
            slope = hn::MulAdd(normal[c], load(lines.direction[c] + i), slope);
            square = hn::MulAdd(normal[c], normal[c], square);
            normal[c] = hn::Mul(normal[c], polarity);
        }
        const Vector way = hn::Div(value, slope);
        const Vector next = hn::Sub(load(group[SheetRoots::t] + row + k), way);
        const Mask usual = hn::And(hn::Gt(square, constant(1e-200)), hn::Lt(square, constant(1e200)));
        const Mask inside =
            hn::And(hn::And(hn::Ge(next, constant(stretch.low)), hn::Le(next, constant(stretch.high))),
                    hn::And(hn::Le(next, load(lines.far + i)), hn::Ge(next, constant(rules.sufficient))));
        const Mask near = hn::And(hn::Le(hn::Abs(value), largest), hn::Le(hn::Abs(way), longest));
        const Mask settled = hn::And(hn::And(asked, usual), hn::And(inside, near));
        hn::BlendedStore(constant(FirstRoots::none), settled, Doubles(), rules.starts + i);
        putRoots(settled, i, next, normal, hn::Sqrt(square), roots);
        const Mask rest = hn::AndNot(settled, asked);
        if (hn::AllTrue(Doubles(), hn::Not(rest))) {
            save(hn::Zero(Doubles()), open);
            continue;
        }
        save(hn::IfThenElseZero(rest, constant(1)), open);
        left += hn::CountTrue(Doubles(), rest);
        placeAt(within(stretch, next), lines, i, group, row + k);
    }
    return left;
}

void placeAll(const LineColumns& lines, std::span<const MonotoneStretch> stretches, const Group& group) {
    for (std::size_t row = 0; const MonotoneStretch& stretch : stretches) {
        placeOnPlane(lines, stretch, group, row);
        row += stretch.room();
    }
}

/// As stepOnPlane().
std::size_t stepAllOnPlanes(const LineColumns& lines, std::span<const MonotoneStretch> stretches,
                            const double* values, double threshold, const Group& group) {
    std::size_t left = 0;
    for (std::size_t row = 0; const MonotoneStretch& stretch : stretches) {
        left += stepOnPlane(lines, stretch, values + row, threshold, group, row);
        row += stretch.room();
    }
    return left;
}

/// Returns how many lines do not settle.
std::size_t stepAllExactly(const LineColumns& lines, std::span<const MonotoneStretch> stretches,
                           const GradientLanes& gradients, const SettleRules& rules, const Group& group,
                           FirstRoots& roots) {
    std::size_t left = 0;
    for (std::size_t row = 0; const MonotoneStretch& stretch : stretches) {
        left += stepExactly(lines, stretch, gradients, rules, group, row, roots);
        row += stretch.room();
    }
    return left;
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(placeAll);
HWY_EXPORT(stepAllOnPlanes);
HWY_EXPORT(stepAllExactly);

namespace {

/// Pieces of these many widths of the bundle are tried: flat and slanting surfaces.
constexpr double widths[] = {2.5, 8};
constexpr int middleSteps = 2, planeSteps = 2, exactSteps = 3;
constexpr double unit = std::numeric_limits<double>::epsilon();

/// So many bundles show whether their enclosures are close enough for this function, here: one in so many
/// has to have a stretch.
constexpr std::size_t trials = 16, fewest = 6;

/// Slabs of more lines are divided, and have a plane for each part: half as far from its middle, the surface
/// is at a fourth of the distance from the plane, and most lines need but one exact step.
constexpr std::size_t partLines = 16;

/// For fewer of a group a further step on the planes does not pay: they take one more exact step.
constexpr std::size_t fewLines = 4;

}  // namespace

void MonotoneStretch::aimAtMiddle(const LineColumns& lines) {
    origin = direction = glm::dvec3(0);
    // Of squares drawn in quarters, the first and the last line lie opposite each other.
    for (const std::size_t line : {first, first + count - 1})
        for (int c = 0; c < 3; ++c) {
            origin[c] += 0.5 * lines.origin[static_cast<std::size_t>(c)][line];
            direction[c] += 0.5 * lines.direction[static_cast<std::size_t>(c)][line];
        }
}

SheetRoots::SheetRoots(const std::shared_ptr<const PreparedFunction>& function, PointEvaluator& points,
                       GradientEvaluator& gradients, const RootSettings& settings)
    : points_(points), gradients_(gradients), settings_(settings) {
    if (SlopeEvaluator::covers(points.tape())) slopes_.emplace(function);
    columns_.reserve(batchLanes);
    for (std::size_t c = 0; c < columnCount; ++c) group_[c] = columns_[c];
    const std::array<double*, 3> lanes = gradients.pointLanes();
    for (std::size_t c = 0; c < lanes.size(); ++c)
        if (lanes[c] != nullptr) group_[x + c] = lanes[c];
}

bool SheetRoots::run(const LineColumns& lines, std::span<const MarchedBundle> bundles, double sufficient,
                     CertainStarts& starts, FirstRoots& roots) {
    stretches_.clear();
    if (!slopes_ || !pays()) return false;
    constexpr std::size_t atOnce = batchLanes / lengths;
    for (std::size_t first = 0; first < bundles.size(); first += atOnce)
        findSlabs(bundles.subspan(first, std::min(atOnce, bundles.size() - first)));
    tried_ += bundles.size();
    enclosed_ += stretches_.size();
    const auto atOnceOf = [&](std::size_t first) {
        return std::span(stretches_).subspan(first, std::min(batchLanes, stretches_.size() - first));
    };
    for (std::size_t first = 0; first < stretches_.size(); first += batchLanes) touch(atOnceOf(first));
    if (divide(lines))
        for (std::size_t first = 0; first < stretches_.size(); first += batchLanes)
            touchParts(atOnceOf(first));
    for (std::size_t first = 0, end = 0; first < stretches_.size(); first = end) {
        std::size_t rows = 0;
        for (; end < stretches_.size() && rows + stretches_[end].room() <= batchLanes; ++end)
            rows += stretches_[end].room();
        settle(lines, std::span(stretches_).subspan(first, end - first), sufficient, starts, roots);
    }
    return !stretches_.empty();
}

bool SheetRoots::pays() const { return tried_ < trials || fewest * enclosed_ > tried_; }

void SheetRoots::findSlabs(std::span<const MarchedBundle> bundles) {
    for (std::size_t k = 0; k < bundles.size(); ++k)
        for (std::size_t i = 0; i < lengths; ++i) {
            const MarchedBundle& marched = bundles[k];
            const std::size_t lane = k * lengths + i;
            marched.bundle.place(lane, pieces_, spread_);
            pieces_.start[lane] = marched.start.start;
            pieces_.length[lane] = std::min(
                widths[i] * std::max(marched.bundle.width, (marched.bundle.far - marched.bundle.near) / 64),
                marched.bundle.far - marched.start.start);
        }
    const SlopeLanes found = slopes_->evaluate(pieces_, spread_, bundles.size() * lengths);
    for (std::size_t k = 0; k < bundles.size(); ++k)
        for (std::size_t i = 0; i < lengths; ++i) {
            const std::size_t before = stretches_.size();
            tryPiece(bundles[k], k * lengths + i, found);
            if (stretches_.size() > before) break;
        }
}

/// Adds a stretch if the function is certain to fall along the piece, to below 0.
void SheetRoots::tryPiece(const MarchedBundle& bundle, std::size_t lane, const SlopeLanes& found) {
    const double polarity = settings_.positivePolarity ? -1 : 1;
    const double a = (found.value.center[lane] - settings_.threshold) * polarity;
    const double b = found.value.slope[lane] * polarity;
    const double error = found.value.error[lane] + 2 * unit * std::abs(found.value.center[lane]);
    if (!(std::abs(error) < std::numeric_limits<double>::infinity())) return;
    if (!(a + b + error < -4 * unit * (std::abs(a) + std::abs(b)))) return;
    MonotoneStretch stretch{bundle.first, bundle.count, pieces_.start[lane],
                            pieces_.start[lane] + pieces_.length[lane]};
    stretch.least = -(found.slope[lane] * polarity + found.spread[lane]) * (1 - 4 * unit);
    stretch.rounding = found.rounding[lane] + 4 * unit * std::abs(settings_.threshold);
    stretch.tolerance =
        settings_.accuracy / glm::length(glm::abs(bundle.bundle.direction) + bundle.bundle.directionSpread);
    if (!(stretch.low < stretch.high && stretch.least > 0 &&
          stretch.rounding < 0.25 * stretch.least * stretch.tolerance))
        return;
    stretch.origin = bundle.bundle.origin;
    stretch.direction = bundle.bundle.direction;
    stretches_.push_back(stretch);
}

/// Finds the planes that touch the surface on the middle lines of the bundles.
void SheetRoots::touch(std::span<MonotoneStretch> stretches) {
    for (std::size_t k = 0; k < stretches.size(); ++k)
        group_[t][k] = 0.5 * (stretches[k].low + stretches[k].high);
    std::array<double, batchLanes> before{};
    for (int step = 0; step < middleSteps; ++step) {
        for (std::size_t k = 0; k < stretches.size(); ++k)
            for (int c = 0; c < 3; ++c)
                group_[x + static_cast<std::size_t>(c)][k] =
                    stretches[k].origin[c] + group_[t][k] * stretches[k].direction[c];
        const GradientLanes found =
            gradients_.evaluateLanes({group_[x], group_[y], group_[z]}, stretches.size());
        for (std::size_t k = 0; k < stretches.size(); ++k) {
            MonotoneStretch& stretch = stretches[k];
            const glm::dvec3 gradient(found.gradient[0][k], found.gradient[1][k], found.gradient[2][k]);
            if (step > 0) stretch.slopeChange = (gradient - stretch.gradient) / (group_[t][k] - before[k]);
            stretch.gradient = gradient;
            before[k] = group_[t][k];
            const double next = group_[t][k] - (found.value[k] - settings_.threshold) /
                                                   glm::dot(stretch.gradient, stretch.direction);
            group_[t][k] = next >= stretch.low ? std::min(next, stretch.high) : stretch.low;
        }
    }
    for (std::size_t k = 0; k < stretches.size(); ++k) {
        MonotoneStretch& stretch = stretches[k];
        const glm::dvec3 point = stretch.origin + group_[t][k] * stretch.direction;
        stretch.offset = glm::dot(stretch.gradient, point);
        // Nothing is known of it where the first step is none.
        if (!std::isfinite(glm::dot(stretch.slopeChange, stretch.slopeChange)))
            stretch.slopeChange = glm::dvec3(0);
        stretch.slopeChangeOffset = glm::dot(stretch.slopeChange, point);
    }
}

/// The stretches become parts of up to partLines lines. False where they are no larger anyway.
bool SheetRoots::divide(const LineColumns& lines) {
    if (std::none_of(stretches_.begin(), stretches_.end(),
                     [](const MonotoneStretch& stretch) { return stretch.count > partLines; }))
        return false;
    parts_.clear();
    parts_.reserve(batchLanes);
    for (const MonotoneStretch& stretch : stretches_)
        for (std::size_t first = 0; first < stretch.count; first += partLines) {
            MonotoneStretch& part = parts_.emplace_back(stretch);
            if (stretch.count <= partLines) continue;
            part.first += first;
            part.count = std::min(partLines, stretch.count - first);
            part.aimAtMiddle(lines);
        }
    stretches_.swap(parts_);
    return true;
}

/// Moves the planes of parts, which are those of whole stretches so far, to where their middle lines meet
/// these.
void SheetRoots::touchParts(std::span<MonotoneStretch> parts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const MonotoneStretch& part = parts[k];
        const double ahead = part.offset - glm::dot(part.gradient, part.origin);
        const double place = ahead / glm::dot(part.gradient, part.direction);
        const glm::dvec3 point =
            part.origin + (place >= part.low ? std::min(place, part.high) : part.low) * part.direction;
        for (int c = 0; c < 3; ++c) group_[x + static_cast<std::size_t>(c)][k] = point[c];
    }
    const GradientLanes found = gradients_.evaluateLanes({group_[x], group_[y], group_[z]}, parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
        MonotoneStretch& part = parts[k];
        part.gradient = {found.gradient[0][k], found.gradient[1][k], found.gradient[2][k]};
        const glm::dvec3 point(group_[x][k], group_[y][k], group_[z][k]);
        part.offset = glm::dot(part.gradient, point) - (found.value[k] - settings_.threshold);
        part.slopeChangeOffset = glm::dot(part.slopeChange, point);
    }
}

/// The lines of stretches that have room in a group.
void SheetRoots::settle(const LineColumns& lines, std::span<const MonotoneStretch> stretches,
                        double sufficient, CertainStarts& starts, FirstRoots& roots) {
    std::size_t rows = 0;
    for (const MonotoneStretch& stretch : stretches) rows += stretch.room();
    HWY_DYNAMIC_DISPATCH(placeAll)(lines, stretches, group_);
    const std::array<const double*, 3> point{group_[x], group_[y], group_[z]};
    std::size_t left = rows;
    for (int step = 0; step < planeSteps && left >= fewLines; ++step) {
        points_.evaluate(point, rows, std::span(values_).first(rows));
        left = HWY_DYNAMIC_DISPATCH(stepAllOnPlanes)(lines, stretches, values_.data(), settings_.threshold,
                                                     group_);
    }
    const SettleRules rules{settings_, sufficient, starts.start()};
    left = rows;
    for (int step = 0; step < exactSteps && left > 0; ++step) {
        const GradientLanes gradients = gradients_.evaluateLanes(point, rows);
        left = HWY_DYNAMIC_DISPATCH(stepAllExactly)(lines, stretches, gradients, rules, group_, roots);
    }
}

}  // namespace isoscope
#endif

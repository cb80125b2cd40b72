// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/bundle_roots.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/bundle_roots.cpp"
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
using Group = BundleRoots::Group;

HWY_INLINE Vector constant(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(Doubles(), from); }
HWY_INLINE void save(Vector value, double* to) { hn::StoreU(value, Doubles(), to); }

/// What is not a number becomes the beginning.
HWY_INLINE Vector within(const RootSlab& slab, Vector t) {
    const Vector low = constant(slab.low);
    return hn::Min(hn::IfThenElse(hn::Gt(t, low), t, low), constant(slab.high));
}

/// Puts line `i` and those behind it at `t`, as rows `row` and behind.
HWY_INLINE void placeAt(Vector t, const LineColumns& lines, std::size_t i, const Group& group,
                        std::size_t row) {
    save(t, group[BundleRoots::t] + row);
    for (std::size_t c = 0; c < 3; ++c)
        save(hn::Add(load(lines.origin[c] + i), hn::Mul(t, load(lines.direction[c] + i))),
             group[BundleRoots::x + c] + row);
}

/// Puts the lines of a slab where they meet its plane.
HWY_INLINE void placeOnPlane(const LineColumns& lines, const RootSlab& slab, const Group& group,
                             std::size_t row) {
    for (std::size_t k = 0; k < slab.count; k += hn::Lanes(Doubles())) {
        const std::size_t i = slab.first + k;
        Vector slope = hn::Zero(Doubles()), ahead = constant(slab.offset);
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector gradient = constant(slab.gradient[static_cast<int>(c)]);
            slope = hn::MulAdd(gradient, load(lines.direction[c] + i), slope);
            ahead = hn::NegMulAdd(gradient, load(lines.origin[c] + i), ahead);
        }
        const Vector low = constant(slab.low);
        const Mask usual =
            hn::And(hn::FirstN(Doubles(), slab.count - k),
                    hn::And(hn::Le(load(lines.near + i), low), hn::Gt(load(lines.far + i), low)));
        save(hn::IfThenElseZero(usual, constant(1)), group[BundleRoots::open] + row + k);
        placeAt(within(slab, hn::Div(ahead, slope)), lines, i, group, row + k);
        // The slope there, as far as it changes like that of the middle line.
        slope = hn::Sub(slope, constant(slab.bendOffset));
        for (std::size_t c = 0; c < 3; ++c)
            slope = hn::MulAdd(constant(slab.bend[static_cast<int>(c)]),
                               load(group[BundleRoots::x + c] + row + k), slope);
        save(slope, group[BundleRoots::slope] + row + k);
    }
}

/// One step of Newton's with the slope that is expected there, and with what that changes on the way. Returns
/// how many lines may well be farther from the root afterwards than a last step goes: that they are off by a
/// fourth of what the change of the slope makes is about what is seen.
HWY_INLINE std::size_t stepOnPlane(const LineColumns& lines, const RootSlab& slab, const double* values,
                                   double threshold, const Group& group, std::size_t row) {
    const Vector turn = constant(0.5 * glm::dot(slab.bend, slab.direction));
    const Vector longest = constant(4 * (NewtonPolish::lastStep * slab.tolerance));
    std::size_t left = 0;
    for (std::size_t k = 0; k < slab.count; k += hn::Lanes(Doubles())) {
        double* const slopes = group[BundleRoots::slope] + row + k;
        const Vector value = hn::Sub(load(values + k), constant(threshold));
        const Vector perSlope = hn::Div(constant(1), load(slopes));
        const Vector way = hn::Mul(value, perSlope);
        const Vector change = hn::Mul(way, hn::Mul(turn, perSlope));
        const Vector step = hn::MulAdd(way, change, way);
        save(hn::NegMulAdd(hn::Add(turn, turn), step, load(slopes)), slopes);
        placeAt(within(slab, hn::Sub(load(group[BundleRoots::t] + row + k), step)), lines, slab.first + k,
                group, row + k);
        const Mask far = hn::Gt(hn::Abs(hn::Mul(way, change)), longest);
        left += hn::CountTrue(
            Doubles(), hn::And(far, hn::Gt(load(group[BundleRoots::open] + row + k), hn::Zero(Doubles()))));
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
HWY_INLINE std::size_t stepExactly(const LineColumns& lines, const RootSlab& slab,
                                   const GradientLanes& gradients, const SettleRules& rules,
                                   const Group& group, std::size_t row, FirstRoots& roots) {
    const Vector threshold = constant(rules.settings.threshold);
    const Vector polarity = constant(rules.settings.positivePolarity ? -1 : 1);
    const Vector longest = constant(NewtonPolish::lastStep * slab.tolerance);
    const Vector largest = constant(0.5 * slab.least * slab.tolerance - slab.noise);
    std::size_t left = 0;
    for (std::size_t k = 0; k < slab.count; k += hn::Lanes(Doubles())) {
        const std::size_t i = slab.first + k;
        double* const open = group[BundleRoots::open] + row + k;
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
        const Vector next = hn::Sub(load(group[BundleRoots::t] + row + k), way);
        const Mask usual = hn::And(hn::Gt(square, constant(1e-200)), hn::Lt(square, constant(1e200)));
        const Mask inside =
            hn::And(hn::And(hn::Ge(next, constant(slab.low)), hn::Le(next, constant(slab.high))),
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
        placeAt(within(slab, next), lines, i, group, row + k);
    }
    return left;
}

void placeAll(const LineColumns& lines, std::span<const RootSlab> slabs, const Group& group) {
    for (std::size_t row = 0; const RootSlab& slab : slabs) {
        placeOnPlane(lines, slab, group, row);
        row += slab.room();
    }
}

/// As stepOnPlane().
std::size_t stepAllOnPlanes(const LineColumns& lines, std::span<const RootSlab> slabs, const double* values,
                            double threshold, const Group& group) {
    std::size_t left = 0;
    for (std::size_t row = 0; const RootSlab& slab : slabs) {
        left += stepOnPlane(lines, slab, values + row, threshold, group, row);
        row += slab.room();
    }
    return left;
}

/// Returns how many lines do not settle.
std::size_t stepAllExactly(const LineColumns& lines, std::span<const RootSlab> slabs,
                           const GradientLanes& gradients, const SettleRules& rules, const Group& group,
                           FirstRoots& roots) {
    std::size_t left = 0;
    for (std::size_t row = 0; const RootSlab& slab : slabs) {
        left += stepExactly(lines, slab, gradients, rules, group, row, roots);
        row += slab.room();
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
/// has to have a slab.
constexpr std::size_t trials = 16, fewest = 6;

/// Slabs of more lines are divided, and have a plane for each part: half as far from its middle, the surface
/// is at a fourth of the distance from the plane, and most lines need but one exact step.
constexpr std::size_t partLines = 16;

/// For fewer of a group a further step on the planes does not pay: they take one more exact step.
constexpr std::size_t fewLines = 4;

}  // namespace

void RootSlab::aimAtMiddle(const LineColumns& lines) {
    origin = direction = glm::dvec3(0);
    // Of squares drawn in quarters, the first and the last line lie opposite each other.
    for (const std::size_t line : {first, first + count - 1})
        for (int c = 0; c < 3; ++c) {
            origin[c] += 0.5 * lines.origin[static_cast<std::size_t>(c)][line];
            direction[c] += 0.5 * lines.direction[static_cast<std::size_t>(c)][line];
        }
}

BundleRoots::BundleRoots(const std::shared_ptr<const Tape>& tape, std::span<const double> parameters,
                         BatchEvaluator& points, GradientEvaluator& gradients, const RootSettings& settings)
    : points_(points), gradients_(gradients), settings_(settings) {
    if (SlopeEvaluator::covers(*tape)) slopes_.emplace(tape, parameters);
    columns_.reserve(batchLanes);
    for (std::size_t c = 0; c < columnCount; ++c) group_[c] = columns_[c];
    const std::array<double*, 3> lanes = gradients.pointLanes();
    for (std::size_t c = 0; c < lanes.size(); ++c)
        if (lanes[c] != nullptr) group_[x + c] = lanes[c];
}

bool BundleRoots::run(const LineColumns& lines, std::span<const MarchedBundle> bundles, double sufficient,
                      CertainStarts& starts, FirstRoots& roots) {
    slabs_.clear();
    if (!slopes_ || !pays()) return false;
    constexpr std::size_t atOnce = batchLanes / lengths;
    for (std::size_t first = 0; first < bundles.size(); first += atOnce)
        findSlabs(bundles.subspan(first, std::min(atOnce, bundles.size() - first)));
    tried_ += bundles.size();
    enclosed_ += slabs_.size();
    const auto atOnceOf = [&](std::size_t first) {
        return std::span(slabs_).subspan(first, std::min(batchLanes, slabs_.size() - first));
    };
    for (std::size_t first = 0; first < slabs_.size(); first += batchLanes) touch(atOnceOf(first));
    if (divide(lines))
        for (std::size_t first = 0; first < slabs_.size(); first += batchLanes) touchParts(atOnceOf(first));
    for (std::size_t first = 0, end = 0; first < slabs_.size(); first = end) {
        std::size_t rows = 0;
        for (; end < slabs_.size() && rows + slabs_[end].room() <= batchLanes; ++end)
            rows += slabs_[end].room();
        settle(lines, std::span(slabs_).subspan(first, end - first), sufficient, starts, roots);
    }
    return !slabs_.empty();
}

bool BundleRoots::pays() const { return tried_ < trials || fewest * enclosed_ > tried_; }

void BundleRoots::findSlabs(std::span<const MarchedBundle> bundles) {
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
            const std::size_t before = slabs_.size();
            tryPiece(bundles[k], k * lengths + i, found);
            if (slabs_.size() > before) break;
        }
}

/// Adds a slab if the function is certain to fall along the piece, to below 0.
void BundleRoots::tryPiece(const MarchedBundle& bundle, std::size_t lane, const SlopeLanes& found) {
    const double polarity = settings_.positivePolarity ? -1 : 1;
    const double a = (found.value.center[lane] - settings_.threshold) * polarity;
    const double b = found.value.slope[lane] * polarity;
    const double error = found.value.error[lane] + 2 * unit * std::abs(found.value.center[lane]);
    if (!(std::abs(error) < std::numeric_limits<double>::infinity())) return;
    if (!(a + b + error < -4 * unit * (std::abs(a) + std::abs(b)))) return;
    RootSlab slab{bundle.first, bundle.count, pieces_.start[lane],
                  pieces_.start[lane] + pieces_.length[lane]};
    slab.least = -(found.slope[lane] * polarity + found.spread[lane]) * (1 - 4 * unit);
    slab.noise = found.noise[lane] + 4 * unit * std::abs(settings_.threshold);
    slab.tolerance =
        settings_.accuracy / glm::length(glm::abs(bundle.bundle.direction) + bundle.bundle.directionSpread);
    if (!(slab.low < slab.high && slab.least > 0 && slab.noise < 0.25 * slab.least * slab.tolerance)) return;
    slab.origin = bundle.bundle.origin;
    slab.direction = bundle.bundle.direction;
    slabs_.push_back(slab);
}

/// Finds the planes that touch the surface on the middle lines of the bundles.
void BundleRoots::touch(std::span<RootSlab> slabs) {
    for (std::size_t k = 0; k < slabs.size(); ++k) group_[t][k] = 0.5 * (slabs[k].low + slabs[k].high);
    std::array<double, batchLanes> before{};
    for (int step = 0; step < middleSteps; ++step) {
        for (std::size_t k = 0; k < slabs.size(); ++k)
            for (int c = 0; c < 3; ++c)
                group_[x + static_cast<std::size_t>(c)][k] =
                    slabs[k].origin[c] + group_[t][k] * slabs[k].direction[c];
        const GradientLanes found = gradients_.evaluateLanes({group_[x], group_[y], group_[z]}, slabs.size());
        for (std::size_t k = 0; k < slabs.size(); ++k) {
            RootSlab& slab = slabs[k];
            const glm::dvec3 gradient(found.gradient[0][k], found.gradient[1][k], found.gradient[2][k]);
            if (step > 0) slab.bend = (gradient - slab.gradient) / (group_[t][k] - before[k]);
            slab.gradient = gradient;
            before[k] = group_[t][k];
            const double next = group_[t][k] - (found.value[k] - settings_.threshold) /
                                                   glm::dot(slab.gradient, slab.direction);
            group_[t][k] = next >= slab.low ? std::min(next, slab.high) : slab.low;
        }
    }
    for (std::size_t k = 0; k < slabs.size(); ++k) {
        RootSlab& slab = slabs[k];
        const glm::dvec3 point = slab.origin + group_[t][k] * slab.direction;
        slab.offset = glm::dot(slab.gradient, point);
        // Nothing is known of it where the first step is none.
        if (!std::isfinite(glm::dot(slab.bend, slab.bend))) slab.bend = glm::dvec3(0);
        slab.bendOffset = glm::dot(slab.bend, point);
    }
}

/// The slabs become parts of up to partLines lines. False where they are no larger anyway.
bool BundleRoots::divide(const LineColumns& lines) {
    if (std::none_of(slabs_.begin(), slabs_.end(),
                     [](const RootSlab& slab) { return slab.count > partLines; }))
        return false;
    parts_.clear();
    parts_.reserve(batchLanes);
    for (const RootSlab& slab : slabs_)
        for (std::size_t first = 0; first < slab.count; first += partLines) {
            RootSlab& part = parts_.emplace_back(slab);
            if (slab.count <= partLines) continue;
            part.first += first;
            part.count = std::min(partLines, slab.count - first);
            part.aimAtMiddle(lines);
        }
    slabs_.swap(parts_);
    return true;
}

/// Moves the planes of parts, which are those of whole slabs so far, to where their middle lines meet these.
void BundleRoots::touchParts(std::span<RootSlab> parts) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const RootSlab& part = parts[k];
        const double ahead = part.offset - glm::dot(part.gradient, part.origin);
        const double place = ahead / glm::dot(part.gradient, part.direction);
        const glm::dvec3 point =
            part.origin + (place >= part.low ? std::min(place, part.high) : part.low) * part.direction;
        for (int c = 0; c < 3; ++c) group_[x + static_cast<std::size_t>(c)][k] = point[c];
    }
    const GradientLanes found = gradients_.evaluateLanes({group_[x], group_[y], group_[z]}, parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
        RootSlab& part = parts[k];
        part.gradient = {found.gradient[0][k], found.gradient[1][k], found.gradient[2][k]};
        const glm::dvec3 point(group_[x][k], group_[y][k], group_[z][k]);
        part.offset = glm::dot(part.gradient, point) - (found.value[k] - settings_.threshold);
        part.bendOffset = glm::dot(part.bend, point);
    }
}

/// The lines of slabs that have room in a group.
void BundleRoots::settle(const LineColumns& lines, std::span<const RootSlab> slabs, double sufficient,
                         CertainStarts& starts, FirstRoots& roots) {
    std::size_t rows = 0;
    for (const RootSlab& slab : slabs) rows += slab.room();
    HWY_DYNAMIC_DISPATCH(placeAll)(lines, slabs, group_);
    const std::array<const double*, 3> point{group_[x], group_[y], group_[z]};
    std::size_t left = rows;
    for (int step = 0; step < planeSteps && left >= fewLines; ++step) {
        points_.evaluate(point, rows, std::span(values_).first(rows));
        left =
            HWY_DYNAMIC_DISPATCH(stepAllOnPlanes)(lines, slabs, values_.data(), settings_.threshold, group_);
    }
    const SettleRules rules{settings_, sufficient, starts.start()};
    left = rows;
    for (int step = 0; step < exactSteps && left > 0; ++step) {
        const GradientLanes gradients = gradients_.evaluateLanes(point, rows);
        left = HWY_DYNAMIC_DISPATCH(stepAllExactly)(lines, slabs, gradients, rules, group_, roots);
    }
}

}  // namespace isoscope
#endif

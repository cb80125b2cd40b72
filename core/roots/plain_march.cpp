// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/plain_march.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/plain_march.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "core/evaluate/compress-inl.h"
#include "core/roots/march_step-inl.h"

#ifndef ISOSCOPE_ROOTS_PLAIN_MARCH_ONCE
#define ISOSCOPE_ROOTS_PLAIN_MARCH_ONCE
namespace isoscope {

/// What the kernels need to know of an isosurface.
struct PlainMarchRules {
    SignRule sign;
    double accuracy;
    bool open;
    double sufficient;
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Vector = hn::Vec<MarchTag>;
using Mask = hn::Mask<MarchTag>;
using March = PlainMarch;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit = std::numeric_limits<double>::epsilon();

HWY_INLINE Vector constant(double value) { return hn::Set(MarchTag(), value); }
HWY_INLINE Vector load(const double* from) { return hn::LoadU(MarchTag(), from); }
HWY_INLINE void save(Vector value, double* to) { hn::StoreU(value, MarchTag(), to); }
HWY_INLINE Mask finite(Vector a) { return hn::Lt(hn::Abs(a), constant(infinity)); }
HWY_INLINE Mask firstLanes(std::size_t count) { return hn::FirstN(MarchTag(), count); }
/// The lanes of `mask` go to `to` and behind; what follows there is overwritten.
HWY_INLINE void append(Vector value, Mask mask, double* to) { appendLanes(MarchTag(), value, mask, to); }

/// A vector of lanes that have ended, one by one.
struct EndedLanes {
    HWY_ALIGN double event[batchLanes], line[batchLanes], start[batchLanes], sign[batchLanes],
        length[batchLanes], newSign[batchLanes];

    void push(Mask where, std::vector<March::Ending>& endings) {
        hn::StoreU(hn::IfThenElseZero(where, constant(1)), MarchTag(), flags_);
        for (std::size_t k = 0; k < hn::Lanes(MarchTag()); ++k)
            if (flags_[k] != 0)
                endings.push_back({static_cast<MarchEvent>(static_cast<std::int32_t>(event[k])),
                                   static_cast<std::size_t>(line[k]),
                                   {start[k], sign[k], length[k]},
                                   newSign[k]});
    }

  private:
    HWY_ALIGN double flags_[batchLanes];
};

/// Lines that meet a wall before anything else, or do not go on beyond what is certain.
void pushCertain(Mask walls, Mask exits, Vector number, Vector near, std::vector<March::Ending>& endings) {
    EndedLanes lanes;
    save(hn::IfThenElse(walls, constant(static_cast<double>(MarchEvent::newSign)),
                        constant(static_cast<double>(MarchEvent::reachedEnd))),
         lanes.event);
    save(number, lanes.line);
    save(near, lanes.start);
    save(hn::IfThenElse(walls, hn::Zero(MarchTag()), constant(-1)), lanes.sign);
    save(constant(1), lanes.length);
    save(constant(-1), lanes.newSign);
    lanes.push(hn::Or(walls, exits), endings);
}

/// CertifiedSearch::begin and goTo for all lines. Returns how many have something to search.
std::size_t admitAll(const LineColumns& lines, const CertainStarts& starts, const PlainMarchRules& rules,
                     March::Columns& columns, std::vector<March::Ending>& endings) {
    const Vector zero = hn::Zero(MarchTag()), one = constant(1);
    std::size_t kept = 0, searched = 0;
    for (std::size_t i = 0; i < lines.count; i += hn::Lanes(MarchTag())) {
        const Vector near = load(lines.near + i), far = load(lines.far + i);
        Vector squaredSpeed = zero, coordinates = zero;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector direction = load(lines.direction[c] + i);
            squaredSpeed = hn::MulAdd(direction, direction, squaredSpeed);
            coordinates =
                hn::Max(coordinates, hn::MulAdd(far, hn::Abs(direction), hn::Abs(load(lines.origin[c] + i))));
        }
        const Mask moving = hn::And(hn::Gt(squaredSpeed, zero), finite(squaredSpeed));
        const Mask valid =
            hn::And(firstLanes(lines.count - i), hn::And(hn::And(hn::Lt(near, far), finite(far)), moving));
        if (hn::AllFalse(MarchTag(), valid)) continue;
        const Vector perLength = hn::Div(one, hn::Sqrt(squaredSpeed));
        const Vector accuracy = hn::Mul(constant(rules.accuracy), perLength);
        const Vector grain = hn::Max(hn::Mul(constant(32 * unit), far),
                                     hn::Mul(hn::Mul(constant(4 * unit), coordinates), perLength));
        const Vector resolution = hn::Max(hn::Mul(constant(0.01), accuracy), grain);

        const Vector begun = load(starts.start() + i), knownSign = load(starts.sign() + i);
        const Mask known = hn::And(hn::Ne(knownSign, zero), hn::Ge(begun, near));
        const Vector sign = hn::IfThenElseZero(known, knownSign);
        const Vector start = hn::IfThenElse(known, begun, near);
        const Mask inside = hn::Lt(sign, zero);
        const Mask entering = rules.open ? hn::Lt(one, zero) : hn::Gt(near, zero);
        const Mask walls = hn::And(valid, hn::And(inside, entering));
        const Mask through = hn::AndNot(walls, hn::And(valid, hn::And(known, hn::Ge(start, far))));
        const Vector number = hn::Iota(MarchTag(), static_cast<double>(i));
        const Mask exits = hn::And(through, inside);
        searched += hn::CountTrue(MarchTag(), valid);
        if (!hn::AllFalse(MarchTag(), hn::Or(walls, exits))) pushCertain(walls, exits, number, near, endings);
        const Mask keep = hn::AndNot(hn::Or(walls, through), valid);
        if (hn::AllFalse(MarchTag(), keep)) continue;

        // A single line can take longer steps than the bundle that came so far.
        const Vector wish = hn::IfThenElse(known, hn::Mul(constant(1.25), load(starts.length() + i)),
                                           hn::Mul(constant(0.5), hn::Sub(far, near)));
        const auto put = [&](March::Column column, Vector value)
                             HWY_ATTR { append(value, keep, columns[column] + kept); };
        put(March::line, number);
        put(March::start, start);
        put(March::length, hn::Min(hn::Max(wish, resolution), hn::Sub(far, start)));
        put(March::far, far);
        put(March::sign, sign);
        put(March::watched,
            hn::IfThenElse(entering, constant(MarchLanes::insideSign), constant(MarchLanes::noSign)));
        put(March::resolution, resolution);
        put(March::tolerance, hn::Max(accuracy, resolution));
        for (std::size_t c = 0; c < 3; ++c) {
            append(load(lines.origin[c] + i), keep, columns[March::originX + c] + kept);
            append(load(lines.direction[c] + i), keep, columns[March::directionX + c] + kept);
        }
        kept += hn::CountTrue(MarchTag(), keep);
    }
    columns.setSize(kept);
    return searched;
}

HWY_INLINE void appendCrossings(const MarchStep<true>& step, Mask where, const March::Columns& columns,
                                std::size_t i, March::Crossings& crossings) {
    const std::size_t size = crossings.size();
    const auto put = [&](March::Crossing column, Vector value)
                         HWY_ATTR { append(value, where, crossings[column] + size); };
    put(March::foundLine, load(columns[March::line] + i));
    put(March::low, step.low);
    put(March::high, step.high);
    put(March::steepness, hn::Div(hn::Mul(hn::Add(step.slope, step.slope), step.sign), step.h));
    put(March::bend, hn::Div(step.error, hn::Abs(step.slope)));
    put(March::foundTolerance, step.tolerance);
    for (std::size_t c = 0; c < 6; ++c)
        append(load(columns[March::originX + c] + i), where, crossings[March::foundOriginX + c] + size);
    crossings.setSize(size + hn::CountTrue(MarchTag(), where));
}

/// Deals with the lanes that have just ended.
void takeEnded(const MarchStep<true>& step, Mask ended, const PlainMarchRules& rules, std::size_t i,
               March::Columns& columns, March::Crossings& crossings, std::vector<March::Ending>& endings) {
    const Vector middle = hn::Mul(constant(0.5), hn::Add(step.low, step.high));
    const Mask crosses = hn::Eq(step.events, constant(static_cast<double>(MarchEvent::crossing)));
    const Mask counts = hn::And(ended, hn::And(crosses, hn::Ge(middle, constant(rules.sufficient))));
    if (!hn::AllFalse(MarchTag(), counts)) appendCrossings(step, counts, columns, i, crossings);
    // Outside to the end: nothing is to be told.
    const Mask misses = hn::And(hn::Eq(step.events, constant(static_cast<double>(MarchEvent::reachedEnd))),
                                hn::Gt(step.sign, hn::Zero(MarchTag())));
    const Mask rest = hn::AndNot(hn::Or(counts, misses), ended);
    if (!hn::AllFalse(MarchTag(), rest)) {
        EndedLanes lanes;
        save(step.events, lanes.event);
        save(load(columns[March::line] + i), lanes.line);
        save(step.t, lanes.start);
        save(step.sign, lanes.sign);
        save(step.h, lanes.length);
        save(step.newSign, lanes.newSign);
        lanes.push(rest, endings);
    }
    double* const numbers = columns[March::line] + i;
    save(hn::IfThenElse(ended, constant(-1), load(numbers)), numbers);
}

/// One step of the lines [first, first + count), given the enclosures of the function on their pieces.
/// Returns how many have ended.
std::size_t stepAll(const AffineLanes& forms, const PlainMarchRules& rules, std::size_t first,
                    std::size_t count, March::Columns& columns, March::Crossings& crossings,
                    std::vector<March::Ending>& endings) {
    const Vector threshold = constant(rules.sign.threshold);
    const Vector polarity = constant(rules.sign.positivePolarity ? -1 : 1);
    std::size_t endedCount = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const std::size_t i = first + k;
        const auto column = [&](March::Column c) HWY_ATTR { return load(columns[c] + i); };
        const Mask alive = hn::And(firstLanes(count - k), hn::Ge(column(March::line), hn::Zero(MarchTag())));
        MarchStep<true> step;
        step.live = alive;
        step.t = column(March::start), step.h = column(March::length), step.far = column(March::far);
        step.sign = column(March::sign), step.watched = column(March::watched);
        step.resolution = column(March::resolution), step.tolerance = column(March::tolerance);
        const Vector a = load(forms.center + k), b = load(forms.slope + k);
        step.take(hn::Mul(hn::Sub(a, threshold), polarity), hn::Mul(b, polarity),
                  thresholdError(a, load(forms.error + k)));
        step.raiseEnd();
        const Mask ended = hn::AndNot(step.live, alive);
        if (!hn::AllFalse(MarchTag(), ended)) {
            takeEnded(step, ended, rules, i, columns, crossings, endings);
            endedCount += hn::CountTrue(MarchTag(), ended);
        }
        save(step.t, columns[March::start] + i);
        save(step.nextLength(), columns[March::length] + i);
        save(step.sign, columns[March::sign] + i);
    }
    return endedCount;
}

/// Closes the ranks of the lines that go on.
void compactAll(March::Columns& columns) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < columns.size(); i += hn::Lanes(MarchTag())) {
        const Mask alive = hn::And(firstLanes(columns.size() - i),
                                   hn::Ge(load(columns[March::line] + i), hn::Zero(MarchTag())));
        // Never ahead of what is still to be read.
        for (std::size_t c = 0; c < March::columnCount; ++c)
            append(load(columns[c] + i), alive, columns[c] + kept);
        kept += hn::CountTrue(MarchTag(), alive);
    }
    columns.setSize(kept);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(admitAll);
HWY_EXPORT(stepAll);
HWY_EXPORT(compactAll);

namespace {

/// Lines that need more steps are no plain ones.
constexpr int stepLimit = 64;

}  // namespace

PlainMarch::Results& PlainMarch::run(const LineColumns& lines, const CertainStarts& starts, double sufficient,
                                     const std::stop_token& stop) {
    results_.crossings.clear();
    results_.entryWalls.clear();
    results_.exitWalls.clear();
    results_.rest.clear();
    sufficient_ = sufficient;
    begin(lines, starts);
    std::size_t ended = 0;
    for (int pass = 0; pass < stepLimit && columns_.size() > 0 && !stop.stop_requested(); ++pass) {
        for (std::size_t first = 0; first < columns_.size(); first += batchLanes) ended += step(first);
        // Those that have ended are no great burden while they are few.
        if (8 * ended < columns_.size()) continue;
        HWY_DYNAMIC_DISPATCH(compactAll)(columns_);
        ended = 0;
    }
    for (std::size_t i = 0; i < columns_.size(); ++i)
        if (columns_[line][i] >= 0)
            results_.rest.push_back({static_cast<std::size_t>(columns_[line][i]),
                                     {columns_[start][i], columns_[sign][i], columns_[length][i]}});
    return results_;
}

void PlainMarch::begin(const LineColumns& lines, const CertainStarts& starts) {
    columns_.reserve(lines.count);
    results_.crossings.reserve(lines.count);
    endings_.clear();
    const PlainMarchRules rules{{}, settings_.accuracy, settings_.open, 0};
    searched_ = HWY_DYNAMIC_DISPATCH(admitAll)(lines, starts, rules, columns_, endings_);
    for (const Ending& ending : endings_) settle(ending);
}

std::size_t PlainMarch::step(std::size_t first) {
    const std::size_t count = std::min(batchLanes, columns_.size() - first);
    const auto at = [&](std::size_t column) -> const double* { return columns_[column] + first; };
    const PieceColumns pieces{{at(originX), at(originY), at(originZ)},
                              {at(directionX), at(directionY), at(directionZ)},
                              at(start),
                              at(length)};
    const PlainMarchRules rules{
        {settings_.threshold, settings_.positivePolarity}, settings_.accuracy, settings_.open, sufficient_};
    endings_.clear();
    const std::size_t ended = HWY_DYNAMIC_DISPATCH(stepAll)(forms_.evaluate(pieces, count), rules, first,
                                                            count, columns_, results_.crossings, endings_);
    for (const Ending& ending : endings_) settle(ending);
    return ended;
}

void PlainMarch::settle(const Ending& ending) {
    // Where no sign is known yet, the line is still where it begins.
    const bool begins = ending.start.sign == 0;
    if (ending.event == MarchEvent::newSign && begins && ending.start.start >= sufficient_)
        results_.entryWalls.push_back(ending.line);
    else if (ending.event != MarchEvent::reachedEnd)
        results_.rest.push_back({ending.line, ending.start});
    else if (!settings_.open)
        results_.exitWalls.push_back(ending.line);
}

}  // namespace isoscope
#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_kernel.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/roots/certified/march_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/evaluate/algebra/compress-inl.h"
#include "core/roots/certified/march_rows.h"
#include "core/roots/certified/side_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

HWY_INLINE Mask finite(Vector a) { return hn::Lt(hn::Abs(a), constant(infinity)); }
HWY_INLINE Mask firstLanes(std::size_t count) { return hn::FirstN(MarchTag(), count); }
/// The lanes of `mask` go to `to` and behind; what follows there is overwritten.
HWY_INLINE void append(Vector value, Mask mask, double* to) { appendLanes(MarchTag(), value, mask, to); }

/// The lanes of `where` are left to others.
void pushRest(Mask where, Vector lines, Vector start, Vector sign, Vector length,
              std::vector<March::Line>& rest) {
    HWY_ALIGN double columns[4][batchLanes];
    append(lines, where, columns[0]);
    append(start, where, columns[1]);
    append(sign, where, columns[2]);
    append(length, where, columns[3]);
    for (std::size_t k = 0; k < hn::CountTrue(MarchTag(), where); ++k)
        rest.push_back(
            {static_cast<std::size_t>(columns[0][k]), {columns[1][k], columns[2][k], columns[3][k]}});
}

/// The numbers in the lanes of `mask`.
HWY_INLINE void pushNumbers(Vector numbers, Mask mask, std::vector<std::size_t>& to) {
    HWY_ALIGN double lanes[batchLanes];
    append(numbers, mask, lanes);
    const std::size_t count = hn::CountTrue(MarchTag(), mask);
    for (std::size_t k = 0; k < count; ++k) to.push_back(static_cast<std::size_t>(lanes[k]));
}

/// Lines that meet a wall at `near`, before anything else.
void pushWalls(Mask walls, Vector numbers, Vector near, const PlainMarchRules& rules,
               March::Results& results) {
    const Mask counts = hn::And(walls, hn::Ge(near, constant(rules.sufficient)));
    pushNumbers(numbers, counts, results.entryWalls);
    const Mask others = hn::AndNot(counts, walls);
    if (hn::AllFalse(MarchTag(), others)) return;
    pushRest(others, numbers, near, hn::Zero(MarchTag()), constant(1), results.rest);
}

/// No line: any piece will do.
HWY_INLINE void putNothing(March::Columns& group, std::size_t k) {
    save(constant(-1), group[March::line] + k);
    save(hn::Zero(MarchTag()), group[March::start] + k);
    save(hn::Zero(MarchTag()), group[March::length] + k);
}

/// GeneralSearch::begin and goTo for the lines [first, first + count), which become the rows of `group`.
/// Returns how many have something to search.
std::size_t admitGroup(const LineColumns& lines, const CertainStarts& starts, const PlainMarchRules& rules,
                       std::size_t first, std::size_t count, March::Columns& group, March::Results& results,
                       std::size_t& searched) {
    const Vector zero = hn::Zero(MarchTag()), one = constant(1);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const std::size_t i = first + k;
        const auto put = [&](March::Column column, Vector value) HWY_ATTR { save(value, group[column] + k); };
        const Vector near = load(lines.near + i), far = load(lines.far + i);
        const Vector begun = load(starts.start() + i), knownSign = load(starts.sign() + i);
        const Mask asked = hn::And(firstLanes(count - k), hn::And(hn::Lt(near, far), finite(far)));
        // Nothing to be found on the whole vector: most of a picture is of this kind.
        const Mask outside =
            hn::And(hn::Gt(knownSign, zero), hn::And(hn::Ge(begun, far), hn::Ge(begun, near)));
        if (hn::AllFalse(MarchTag(), hn::AndNot(outside, asked))) {
            searched += hn::CountTrue(MarchTag(), asked);
            putNothing(group, k);
            continue;
        }
        Vector squaredSpeed = zero, coordinates = zero;
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector direction = load(lines.direction[c] + i);
            squaredSpeed = hn::MulAdd(direction, direction, squaredSpeed);
            coordinates =
                hn::Max(coordinates, hn::MulAdd(far, hn::Abs(direction), hn::Abs(load(lines.origin[c] + i))));
        }
        const Mask moving = hn::And(hn::Gt(squaredSpeed, zero), finite(squaredSpeed));
        const Mask valid = hn::And(asked, moving);
        if (hn::AllFalse(MarchTag(), valid)) {
            putNothing(group, k);
            continue;
        }
        const Vector perLength = hn::Div(one, hn::Sqrt(squaredSpeed));
        const Vector accuracy = hn::Mul(constant(rules.accuracy), perLength);
        const Vector grain = hn::Max(hn::Mul(constant(32 * unit), far),
                                     hn::Mul(hn::Mul(constant(4 * unit), coordinates), perLength));
        const Vector resolution = hn::Max(hn::Mul(constant(0.01), accuracy), grain);

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
        if (!hn::AllFalse(MarchTag(), walls)) pushWalls(walls, number, near, rules, results);
        if (!hn::AllFalse(MarchTag(), exits)) pushNumbers(number, exits, results.insideEnds);
        const Mask keep = hn::AndNot(hn::Or(walls, through), valid);

        // A single line can take longer steps than the bundle that came so far.
        const Vector wish = hn::IfThenElse(known, hn::Mul(constant(1.25), load(starts.length() + i)),
                                           hn::Mul(constant(0.5), hn::Sub(far, near)));
        put(March::line, hn::IfThenElse(keep, number, constant(-1)));
        put(March::start, hn::IfThenElseZero(keep, start));
        put(March::length, hn::IfThenElseZero(keep, hn::Min(hn::Max(wish, resolution), hn::Sub(far, start))));
        put(March::far, far);
        put(March::sign, sign);
        put(March::watched,
            hn::IfThenElse(entering, constant(MarchLanes::insideSign), constant(MarchLanes::noSign)));
        put(March::resolution, resolution);
        put(March::tolerance, hn::Max(accuracy, resolution));
        // The value at the wall itself is known; what is right behind it counts.
        const Mask atWall = hn::AndNot(known, entering);
        put(March::hop, hn::IfThenElseZero(atWall, finestPlace(resolution)));
        put(March::behind, zero);
        put(March::toldJump, constant(SideLanes::noJump));
        put(March::toldSide, zero);
        kept += hn::CountTrue(MarchTag(), keep);
    }
    return kept;
}

HWY_INLINE void appendCrossings(const MarchStep<true>& step, Mask where, const MarchRows& rows, std::size_t k,
                                March::Crossings& crossings) {
    const std::size_t size = crossings.size();
    const auto put = [&](March::Crossing column, Vector value)
                         HWY_ATTR { append(value, where, crossings[column] + size); };
    put(March::foundLine, load(rows.state[March::line] + k));
    put(March::low, step.low);
    put(March::high, step.high);
    put(March::steepness, hn::Div(hn::Mul(hn::Add(step.slope, step.slope), step.sign), step.h));
    put(March::curvatureRatio, hn::Div(step.error, hn::Abs(step.slope)));
    put(March::foundTolerance, step.tolerance);
    for (std::size_t c = 0; c < 6; ++c)
        append(load(rows.ray[c] + k), where, crossings[March::foundOriginX + c] + size);
    crossings.setSize(size + hn::CountTrue(MarchTag(), where));
}

HWY_INLINE void appendBrackets(const MarchStep<true>& step, Mask where, const MarchRows& rows, std::size_t k,
                               March::Columns& brackets) {
    const std::size_t size = brackets.size();
    const auto put = [&](March::Column column, Vector value)
                         HWY_ATTR { append(value, where, brackets[column] + size); };
    put(March::line, load(rows.state[March::line] + k));
    put(March::start, step.low);
    put(March::length, hn::Sub(step.high, step.low));
    put(March::far, step.far);
    put(March::sign, step.sign);
    put(March::watched, step.watched);
    put(March::resolution, step.resolution);
    put(March::tolerance, step.tolerance);
    put(March::hop, hn::Zero(MarchTag()));
    put(March::behind, hn::Zero(MarchTag()));
    put(March::toldJump, constant(SideLanes::noJump));
    put(March::toldSide, hn::Zero(MarchTag()));
    for (std::size_t c = 0; c < rows.ray.size(); ++c)
        append(load(rows.ray[c] + k), where, brackets[March::originX + c] + size);
    brackets.setSize(size + hn::CountTrue(MarchTag(), where));
}

/// Deals with the lanes that have just ended.
void takeEnded(const MarchStep<true>& step, Mask ended, const PlainMarchRules& rules, const MarchRows& rows,
               std::size_t k, March::Results& results) {
    const Vector zero = hn::Zero(MarchTag());
    const auto was = [&](MarchEvent event)
                         HWY_ATTR { return hn::Eq(step.events, constant(static_cast<double>(event))); };
    double* const numbers = rows.state[March::line] + k;
    const Vector lines = load(numbers);
    // Where the root is in its interval the polish will tell: the whole of it has to count.
    const Mask counts =
        hn::And(ended, hn::And(was(MarchEvent::crossing), hn::Ge(step.low, constant(rules.sufficient))));
    if (!hn::AllFalse(MarchTag(), counts)) appendCrossings(step, counts, rows, k, results.crossings);
    const Mask brackets = hn::And(ended, was(MarchEvent::bracket));
    if (!hn::AllFalse(MarchTag(), brackets)) appendBrackets(step, brackets, rows, k, results.brackets);
    save(hn::IfThenElse(ended, constant(-1), lines), numbers);
    Mask rest = hn::AndNot(hn::Or(counts, brackets), ended);
    if (hn::AllFalse(MarchTag(), rest)) return;
    // Outside to the end: nothing is to be told.
    const Mask through = hn::And(rest, was(MarchEvent::reachedEnd));
    const Mask exits = hn::AndNot(hn::Gt(step.sign, zero), through);
    if (!hn::AllFalse(MarchTag(), exits)) pushNumbers(lines, exits, results.insideEnds);
    // Where no sign is known yet, the line is still where it begins.
    const Mask begins = hn::And(hn::Eq(step.sign, zero), hn::Ge(step.t, constant(rules.sufficient)));
    const Mask walls = hn::And(rest, hn::And(was(MarchEvent::newSign), begins));
    if (!hn::AllFalse(MarchTag(), walls)) pushNumbers(lines, walls, results.entryWalls);
    rest = hn::AndNot(hn::Or(through, walls), rest);
    if (hn::AllFalse(MarchTag(), rest)) return;
    pushRest(rest, lines, step.t, step.sign, step.h, results.rest);
}

/// One step of the first `count` lines, given the enclosures of the function on their pieces. Returns how
/// many have ended.
std::size_t stepAll(const AffineLanes& forms, const PlainMarchRules& rules, const MarchRows& rows,
                    std::size_t count, March::Results& results) {
    const Vector threshold = constant(rules.sign.threshold);
    const Vector polarity = constant(rules.sign.positivePolarity ? -1 : 1);
    std::size_t endedCount = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const Mask alive =
            hn::And(firstLanes(count - k), hn::Ge(load(rows.state[March::line] + k), hn::Zero(MarchTag())));
        if (hn::AllFalse(MarchTag(), alive)) continue;
        MarchStep<true> step = loadStep(rows, k, alive, rules);
        const Vector a = load(forms.center + k), b = load(forms.slope + k);
        step.take(hn::Mul(hn::Sub(a, threshold), polarity), hn::Mul(b, polarity),
                  thresholdError(a, load(forms.error + k)));
        step.raiseEnd();
        const Mask ended = hn::AndNot(step.live, alive);
        if (!hn::AllFalse(MarchTag(), ended)) {
            takeEnded(step, ended, rules, rows, k, results);
            endedCount += hn::CountTrue(MarchTag(), ended);
            if (hn::AllFalse(MarchTag(), step.live)) continue;
        }
        saveStep(step, rows, k);
    }
    return endedCount;
}

/// The rows of the lanes of `where` go on elsewhere.
HWY_INLINE void appendRows(Mask where, const MarchRows& rows, std::size_t k, March::Columns& columns) {
    const std::size_t size = columns.size();
    for (std::size_t c = 0; c < rows.state.size(); ++c)
        append(load(rows.state[c] + k), where, columns[c] + size);
    for (std::size_t c = 0; c < rows.ray.size(); ++c)
        append(load(rows.ray[c] + k), where, columns[March::originX + c] + size);
    columns.setSize(size + hn::CountTrue(MarchTag(), where));
}

/// As stepAll(), of a function that jumps: lines that are undecided on the whole piece go to `bySides`, and
/// are to be looked at side by side. Returns how many lines are gone, those among them.
std::size_t stepWholeAll(const AffineLanes& forms, const PlainMarchRules& rules, const MarchRows& rows,
                         std::size_t count, March::Results& results, March::Columns& bySides) {
    const Vector zero = hn::Zero(MarchTag());
    const Vector threshold = constant(rules.sign.threshold);
    const Vector polarity = constant(rules.sign.positivePolarity ? -1 : 1);
    std::size_t goneCount = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        double* const numbers = rows.state[March::line] + k;
        const Mask alive = hn::And(firstLanes(count - k), hn::Ge(load(numbers), zero));
        if (hn::AllFalse(MarchTag(), alive)) continue;
        MarchStep<true> step = loadStep(rows, k, alive, rules);
        const Vector begun = step.t, piece = step.h;
        const Vector a = load(forms.center + k), b = load(forms.slope + k);
        step.take(hn::Mul(hn::Sub(a, threshold), polarity), hn::Mul(b, polarity),
                  thresholdError(a, load(forms.error + k)));
        // What a good part of the piece is free by itself is no matter of sides.
        const Mask passed = hn::Ge(step.t, hn::Min(hn::MulAdd(piece, constant(0.25), begun), step.far));
        const Mask stuck = hn::Eq(step.events, constant(static_cast<double>(MarchEvent::unresolved)));
        const Mask undecided = hn::And(alive, hn::Or(stuck, hn::AndNot(passed, step.live)));
        if (!hn::AllFalse(MarchTag(), undecided)) {
            appendRows(undecided, rows, k, bySides);
            save(hn::IfThenElse(undecided, constant(-1), load(numbers)), numbers);
            goneCount += hn::CountTrue(MarchTag(), undecided);
            step.live = hn::AndNot(undecided, step.live);
        }
        step.raiseEnd();
        const Mask ended = hn::AndNot(hn::Or(step.live, undecided), alive);
        if (!hn::AllFalse(MarchTag(), ended)) {
            takeEnded(step, ended, rules, rows, k, results);
            goneCount += hn::CountTrue(MarchTag(), ended);
        }
        if (hn::AllFalse(MarchTag(), step.live)) continue;
        saveStep(step, rows, k);
        save(zero, rows.state[March::hop] + k);
        save(constant(SideLanes::noJump), rows.state[March::toldJump] + k);
    }
    return goneCount;
}

/// The sign has changed by the side of a jump, between t and t + hop; where none was known, in the wall.
void pushJumps(const MarchStep<true>& step, Mask where, Vector hop, const MarchRows& rows, std::size_t k,
               March::Results& results) {
    HWY_ALIGN double columns[3][batchLanes];
    append(load(rows.state[March::line] + k), where, columns[0]);
    const Mask atWall = hn::Eq(step.sign, hn::Zero(MarchTag()));
    append(hn::IfThenElse(atWall, step.t, hn::Add(step.t, hop)), where, columns[1]);
    append(step.sign, where, columns[2]);
    for (std::size_t i = 0; i < hn::CountTrue(MarchTag(), where); ++i) {
        const RootKind kind = columns[2][i] == 0 ? RootKind::crossing : RootKind::jump;
        results.jumps.push_back({static_cast<std::size_t>(columns[0][i]), {columns[1][i], kind}});
    }
    save(hn::IfThenElse(where, constant(-1), load(rows.state[March::line] + k)), rows.state[March::line] + k);
}

/// Where the sides of jumps are read on each piece, and what cannot be told apart there.
void placeReadings(const MarchRows& rows, std::size_t count, SideLanes& sides) {
    const Vector two = constant(2);
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const Vector perHalf = hn::Div(two, load(rows.state[March::length] + k));
        const Vector grain = hn::Mul(load(rows.state[March::far] + k), constant(32 * unit));
        const Vector jump = load(rows.state[March::toldJump] + k);
        save(jump, &sides.toldJump[k]);
        save(load(rows.state[March::toldSide] + k), &sides.toldSide[k]);
        const Mask reads = hn::Lt(jump, hn::Zero(MarchTag()));
        const Vector hop = hn::IfThenElseZero(reads, hn::Mul(load(rows.state[March::hop] + k), perHalf));
        save(hn::Sub(hop, constant(1)), &sides.readAt[k]);
        save(hn::Mul(grain, perHalf), &sides.grain[k]);
    }
}

/// As stepAll(), of a function that jumps. The value at the wall of lines that enter their container is
/// known, and not inside. Lines that go on behind a jump go to `whole`, if there is one.
std::size_t stepSidesAll(const AffineLanes& forms, const SideLanes& sides, const PlainMarchRules& rules,
                         const MarchRows& rows, std::size_t count, March::Results& results,
                         March::Columns* whole) {
    const Vector zero = hn::Zero(MarchTag());
    const Vector threshold = constant(rules.sign.threshold);
    const Vector polarity = constant(rules.sign.positivePolarity ? -1 : 1);
    std::size_t endedCount = 0;
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const Mask alive = hn::And(firstLanes(count - k), hn::Ge(load(rows.state[March::line] + k), zero));
        if (hn::AllFalse(MarchTag(), alive)) continue;
        SideStep side(loadStep(rows, k, alive, rules), rows, k);
        MarchStep<true>& step = side.step;
        const Vector a = load(forms.center + k), b = load(forms.slope + k);
        const Vector above = hn::Sub(a, threshold), error = thresholdError(a, load(forms.error + k));
        const Mask crowded = hn::Ne(load(&sides.crowded[k]), zero);
        // A side that the sign does not depend on need not be read.
        const Mask certain = hn::Gt(hn::Mul(hn::Abs(hn::Sub(above, b)), constant(1 - 4 * unit)), error);
        const Mask open = hn::Or(hn::Ne(load(&sides.blind[k]), zero),
                                 hn::AndNot(certain, hn::Ne(load(&sides.open[k]), zero)));
        side.take(hn::Mul(above, polarity), hn::Mul(b, polarity), error, load(&sides.low[k]),
                  load(&sides.high[k]), open);
        side.holds = hn::AndNot(crowded, side.holds);
        const Vector hopped = side.hop;
        side.pass(open, load(&sides.nextJump[k]), load(&sides.nextSide[k]));
        step.raiseEnd();
        const Mask ended = hn::AndNot(step.live, alive);
        if (!hn::AllFalse(MarchTag(), ended)) {
            const Mask news =
                hn::And(ended, hn::Eq(step.events, constant(static_cast<double>(MarchEvent::newSign))));
            const Mask jumps =
                hn::And(hn::And(news, hn::Gt(hopped, zero)), hn::Ge(step.t, constant(rules.sufficient)));
            if (!hn::AllFalse(MarchTag(), jumps)) pushJumps(step, jumps, hopped, rows, k, results);
            takeEnded(step, hn::AndNot(jumps, ended), rules, rows, k, results);
            endedCount += hn::CountTrue(MarchTag(), ended);
            if (hn::AllFalse(MarchTag(), step.live)) continue;
        }
        saveStep(step, rows, k);
        save(side.hop, rows.state[March::hop] + k);
        save(side.behind, rows.state[March::behind] + k);
        save(side.toldJump, rows.state[March::toldJump] + k);
        save(side.toldSide, rows.state[March::toldSide] + k);
        if (whole == nullptr) continue;
        const Mask further = hn::And(step.live, side.here);
        if (hn::AllFalse(MarchTag(), further)) continue;
        appendRows(further, rows, k, *whole);
        double* const numbers = rows.state[March::line] + k;
        save(hn::IfThenElse(further, constant(-1), load(numbers)), numbers);
        endedCount += hn::CountTrue(MarchTag(), further);
    }
    return endedCount;
}

/// Adds those of the first `count` lines that go on to `columns`.
void gatherLive(const MarchRows& rows, std::size_t count, March::Columns& columns) {
    for (std::size_t k = 0; k < count; k += hn::Lanes(MarchTag())) {
        const Mask alive =
            hn::And(firstLanes(count - k), hn::Ge(load(rows.state[March::line] + k), hn::Zero(MarchTag())));
        if (hn::AllFalse(MarchTag(), alive)) continue;
        appendRows(alive, rows, k, columns);
    }
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

HWY_EXPORT(admitGroup);
HWY_EXPORT(stepAll);
HWY_EXPORT(stepWholeAll);
HWY_EXPORT(placeReadings);
HWY_EXPORT(stepSidesAll);
HWY_EXPORT(gatherLive);
HWY_EXPORT(compactAll);

namespace {

/// Lines that need more steps are no plain ones; along functions that jump, each jump takes one.
constexpr int stepLimit = 64, sideStepLimit = 24;
/// As long as there are so many of batchLanes, lines are searched where they lie: to move them costs about as
/// much as a step of a cheap function.
constexpr std::size_t dense = 56;

/// Tables grow by some hundred rows at a time: to move them takes longer than to add a few rows.
std::size_t roomier(std::size_t rows) { return (rows + 255) / 256 * 256; }

MarchRows rowsOf(MarchKernel::Columns& columns, std::size_t first) {
    MarchRows rows;
    for (std::size_t c = 0; c < rows.state.size(); ++c) rows.state[c] = columns[c] + first;
    for (std::size_t c = 0; c < rows.ray.size(); ++c) rows.ray[c] = columns[MarchKernel::originX + c] + first;
    return rows;
}

/// `group` are the lines from `first` on.
MarchRows rowsOf(MarchKernel::Columns& group, const LineColumns& lines, std::size_t first) {
    MarchRows rows = rowsOf(group, 0);
    for (std::size_t c = 0; c < 3; ++c) {
        rows.ray[c] = lines.origin[c] + first;
        rows.ray[3 + c] = lines.direction[c] + first;
    }
    return rows;
}

}  // namespace

MarchKernel::MarchKernel(AffineEvaluator& forms, const RootSettings& settings)
    : forms_(forms), settings_(settings) {}

MarchKernel::Results& MarchKernel::run(const LineColumns& lines, const CertainStarts& starts,
                                       double sufficient, const std::stop_token& stop, bool brackets) {
    begin(sufficient, nullptr);
    brackets_ = brackets;
    if (forms_.canJump()) pace_ = wholePays() ? Pace::untilUndecided : Pace::bySides;
    otherColumns_.clear();
    for (std::size_t first = 0; first < lines.count && !stop.stop_requested(); first += batchLanes)
        runGroup(lines, starts, first, std::min(batchLanes, lines.count - first));
    if (pace_ == Pace::plain)
        runGathered(stop);
    else
        runJumping(stop);
    return results_;
}

void MarchKernel::resume(const std::stop_token& stop) {
    brackets_ = false;
    std::swap(columns_, results_.brackets);
    results_.brackets.clear();
    pace_ = Pace::plain;
    runGathered(stop);
}

MarchKernel::Results& MarchKernel::run(const LineColumns& lines, std::size_t first, std::size_t count,
                                       const CertainStarts& starts, double sufficient,
                                       const SimplifiedTape& simplifiedTape) {
    begin(sufficient, &simplifiedTape);
    runGroup(lines, starts, first, count);
    runGathered({});
    return results_;
}

void MarchKernel::begin(double sufficient, const SimplifiedTape* simplifiedTape) {
    results_.crossings.clear();
    results_.brackets.clear();
    results_.entryWalls.clear();
    results_.insideEnds.clear();
    results_.jumps.clear();
    results_.rest.clear();
    searched_ = 0;
    sufficient_ = sufficient;
    brackets_ = false;
    simplifiedTape_ = simplifiedTape;
    pace_ = Pace::plain;
    columns_.clear();
    group_.reserve(batchLanes);
}

PlainMarchRules MarchKernel::rules() const {
    return {{settings_.threshold, settings_.positivePolarity},
            settings_.accuracy,
            settings_.open,
            sufficient_,
            brackets_};
}

/// Lines that follow each other mostly end together.
void MarchKernel::runGroup(const LineColumns& lines, const CertainStarts& starts, std::size_t first,
                           std::size_t count) {
    std::size_t live =
        HWY_DYNAMIC_DISPATCH(admitGroup)(lines, starts, rules(), first, count, group_, results_, searched_);
    const MarchRows rows = rowsOf(group_, lines, first);
    for (int pass = 0; pass < stepLimit && live >= dense; ++pass) live -= step(rows, count);
    if (live == 0) return;
    columns_.reserve(roomier(columns_.size() + live));
    HWY_DYNAMIC_DISPATCH(gatherLive)(rows, count, columns_);
}

void MarchKernel::runGathered(const std::stop_token& stop) {
    std::size_t ended = 0;
    for (int pass = 0; pass < stepLimit && columns_.size() > 0 && !stop.stop_requested(); ++pass) {
        for (std::size_t first = 0; first < columns_.size(); first += batchLanes)
            ended += step(rowsOf(columns_, first), std::min(batchLanes, columns_.size() - first));
        // Those that have ended are no great burden while they are few.
        if (8 * ended < columns_.size()) continue;
        HWY_DYNAMIC_DISPATCH(compactAll)(columns_);
        ended = 0;
    }
    leaveRest(columns_);
}

void MarchKernel::leaveRest(const Columns& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[line][i] >= 0)
            results_.rest.push_back({static_cast<std::size_t>(columns[line][i]),
                                     {columns[start][i], columns[sign][i], columns[length][i]}});
}

/// Lines go to and fro between the pieces that are looked at as a whole and those that are by sides.
void MarchKernel::runJumping(const std::stop_token& stop) {
    if (pace_ == Pace::bySides) std::swap(columns_, otherColumns_);
    const auto runAll = [&](Pace pace) {
        pace_ = pace;
        for (std::size_t first = 0; first < columns_.size(); first += batchLanes)
            step(rowsOf(columns_, first), std::min(batchLanes, columns_.size() - first));
        HWY_DYNAMIC_DISPATCH(compactAll)(columns_);
        std::swap(columns_, otherColumns_);
    };
    for (int pass = 0; pass < sideStepLimit && !stop.stop_requested(); ++pass) {
        if (columns_.empty() && otherColumns_.empty()) return;
        runAll(Pace::untilUndecided);
        runAll(Pace::bySides);
    }
    leaveRest(columns_);
    leaveRest(otherColumns_);
}

std::size_t MarchKernel::step(const MarchRows& rows, std::size_t count) {
    // Not for all lines at once: few of them come as far as this, and memory that is touched has its price.
    results_.crossings.reserve(roomier(results_.crossings.size() + count));
    if (brackets_) results_.brackets.reserve(roomier(results_.brackets.size() + count));
    const PieceColumns pieces{{rows.ray[0], rows.ray[1], rows.ray[2]},
                              {rows.ray[3], rows.ray[4], rows.ray[5]},
                              rows.state[start],
                              rows.state[length]};
    if (pace_ == Pace::bySides) return stepSides(rows, pieces, count);
    const AffineLanes forms = simplifiedTape_ != nullptr ? forms_.evaluate(pieces, count, *simplifiedTape_)
                                                         : forms_.evaluate(pieces, count, 0);
    if (pace_ == Pace::untilUndecided) {
        const std::size_t before = otherColumns_.size();
        otherColumns_.reserve(roomier(before + count));
        const std::size_t gone =
            HWY_DYNAMIC_DISPATCH(stepWholeAll)(forms, rules(), rows, count, results_, otherColumns_);
        wholePieces_ += count;
        undecidedPieces_ += otherColumns_.size() - before;
        return gone;
    }
    return HWY_DYNAMIC_DISPATCH(stepAll)(forms, rules(), rows, count, results_);
}

std::size_t MarchKernel::stepSides(const MarchRows& rows, const PieceColumns& pieces, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(placeReadings)(rows, count, sides_);
    const AffineLanes forms = forms_.evaluateSides(pieces, count, sides_);
    Columns* const whole = wholePays() ? &otherColumns_ : nullptr;
    if (whole != nullptr) whole->reserve(roomier(whole->size() + count));
    return HWY_DYNAMIC_DISPATCH(stepSidesAll)(forms, sides_, rules(), rows, count, results_, whole);
}

}  // namespace isoscope
#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/union_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numeric>
#include <optional>

#include "core/evaluate/prepared_function.h"
#include "core/roots/cells/backward_bounds.h"
#include "core/roots/cells/box_pieces.h"
#include "core/roots/cells/short_tapes.h"

namespace isoscope {

namespace {

using Value = SimplifiedTape::Value;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// To make the tapes of parts takes time that grows somewhat faster than their number.
constexpr std::size_t mostParts = 1 << 15;

/// The parts of a union one after the other, by walking through its choices: from the result down along what
/// keeps the order of values, or turns it round.
class UnionWalk {
  public:
    UnionWalk(const PreparedFunction& function, bool positivePolarity)
        : tape_(*function.tape()), links_(function.links()), uniforms_(function.uniforms()) {
        decided.reset(links_);
        descend({links_.whole().resultValue, positivePolarity}, 0);
    }

    bool atEnd() const { return atEnd_; }
    /// To the next part; `kept` of those before count for the forks.
    void advance(std::size_t kept) {
        const auto part = static_cast<std::uint32_t>(kept);
        while (!path_.empty() && path_.back().bySecond) {
            forks[path_.back().fork].end = part;
            decided.second[path_.back().place / wordBits] &= ~bitOf(path_.back().place);
            path_.pop_back();
        }
        atEnd_ = path_.empty();
        if (atEnd_) return;
        Turn& turn = path_.back();
        turn.bySecond = true;
        forks[turn.fork].middle = part;
        decided.first[turn.place / wordBits] &= ~bitOf(turn.place);
        decided.second[turn.place / wordBits] |= bitOf(turn.place);
        descend(turn.other, part);
    }

    /// The choices that lead to the part at hand.
    DecidedChoices decided;
    /// Final at the end.
    std::vector<UnionParts::Fork> forks;

  private:
    static constexpr std::size_t wordBits = 64;

    struct Operand {
        Value value = SimplifiedTape::fixed;
        bool turned = false;  ///< inside is where it is above
    };
    /// A choice on the way down.
    struct Turn {
        std::uint32_t place = 0;
        Operand other;         ///< its second operand
        std::size_t fork = 0;  ///< its number
        bool bySecond = false;
    };

    static std::uint64_t bitOf(std::uint32_t place) { return std::uint64_t(1) << place % wordBits; }

    void descend(Operand at, std::uint32_t part) {
        for (;;) {
            if (SimplifiedTape::isFixed(at.value)) return;
            const SimplifiedTape& whole = links_.whole();
            const Operation operation = whole.instructions[at.value].operation;
            const SimplifiedTape::Link& link = whole.links[at.value];
            const Operation unites = at.turned ? Operation::maximum : Operation::minimum;
            // What the sign does not depend on alone is used elsewhere, too.
            if (operation == unites && whole.levelNumbers[link.choice] != 0) {
                const std::uint32_t place = links_.chains().places[link.choice];
                decided.first[place / wordBits] |= bitOf(place);
                path_.push_back({place, {link.operands[1], at.turned}, forks.size()});
                forks.push_back({place, part, part, part});
                at.value = link.operands[0];
            } else if (const std::optional<Operand> behind = behindMonotone(at)) {
                at = *behind;
            } else {
                return;
            }
        }
    }

    /// What a value comes from by an operation with a uniform one, which keeps or turns the order.
    std::optional<Operand> behindMonotone(const Operand& at) const {
        const Instruction& instruction = links_.whole().instructions[at.value];
        const auto& operands = links_.whole().links[at.value].operands;
        const auto isUniform = [&](std::size_t k) {
            return SimplifiedTape::isFixed(operands[k]) &&
                   (operands[k] & ~SimplifiedTape::fixed) >= tape_.firstUniform();
        };
        switch (instruction.operation) {
            case Operation::negate: return Operand{operands[0], !at.turned};
            case Operation::add:
                if (isUniform(1)) return Operand{operands[0], at.turned};
                if (isUniform(0)) return Operand{operands[1], at.turned};
                return {};
            case Operation::subtract:
                if (isUniform(1)) return Operand{operands[0], at.turned};
                if (isUniform(0)) return Operand{operands[1], !at.turned};
                return {};
            case Operation::multiply: {
                if (!isUniform(0) && !isUniform(1)) return {};
                const std::size_t number = isUniform(0) ? 0 : 1;
                const double factor = uniforms_.of(tape_, operands[number] & ~SimplifiedTape::fixed);
                if (!(std::abs(factor) > 0)) return {};
                return Operand{operands[1 - number], at.turned != (factor < 0)};
            }
            default: return {};
        }
    }

    const Tape& tape_;
    const TapeLinks& links_;
    const UniformValues& uniforms_;
    std::vector<Turn> path_;
    bool atEnd_ = false;
};

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

double areaOf(const LineRegion& box) {
    const glm::dvec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

LineRegion unite(const LineRegion& a, const LineRegion& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

/// The part of `box` that holds all that is inside, or undefined, by the base of `boxes`: slices at the ends
/// of each axis are taken off as long as that leaves little. Nothing where all is outside.
std::optional<LineRegion> shrink(LineRegion box, BoxPieces& boxes) {
    constexpr std::size_t slices = 8;
    constexpr int rounds = 8;
    // What fills so many is about as wide as they are.
    constexpr std::size_t most = 5;
    for (int round = 0; round < rounds; ++round) {
        const glm::dvec3 center = 0.5 * (box.low + box.high), halfWidth = 0.5 * (box.high - box.low);
        const glm::dvec3 step = halfWidth / static_cast<double>(slices);
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < slices; ++k) {
                glm::dvec3 place = center, reach = halfWidth;
                place[axis] = box.low[axis] + static_cast<double>(2 * k + 1) * step[axis];
                reach[axis] = step[axis];
                boxes.place(place, reach, static_cast<std::size_t>(axis) * slices + k);
            }
        boxes.enclose(3 * slices);
        LineRegion left = box;
        bool fills = true;
        for (int axis = 0; axis < 3; ++axis) {
            const auto isFree = [&](std::size_t k) {
                return boxes.sign(static_cast<std::size_t>(axis) * slices + k) > 0;
            };
            std::size_t first = 0, end = slices;
            while (first < slices && isFree(first)) ++first;
            if (first == slices) return {};
            while (isFree(end - 1)) --end;
            if (first > 0) left.low[axis] = box.low[axis] + static_cast<double>(2 * first) * step[axis];
            if (end < slices) left.high[axis] = box.low[axis] + static_cast<double>(2 * end) * step[axis];
            fills &= end - first >= most;
        }
        box = left;
        if (fills) break;
    }
    return box;
}

/// Whether a box, smaller than a region, certainly holds all of it that is inside, or undefined, by the base
/// of `boxes`.
bool holdsAllOf(LineRegion region, const LineRegion& box, BoxPieces& boxes) {
    if (!glm::all(glm::lessThan(box.low, box.high))) return false;
    std::size_t lanes = 0;
    const auto place = [&](const glm::dvec3& low, const glm::dvec3& high) {
        boxes.place(0.5 * (low + high), 0.5 * (high - low), lanes++);
    };
    // What is beside the box along x, what is left of it along y, and so on.
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 below = region.high, above = region.low;
        below[axis] = box.low[axis];
        above[axis] = box.high[axis];
        if (box.low[axis] > region.low[axis]) place(region.low, below);
        if (box.high[axis] < region.high[axis]) place(above, region.high);
        region.low[axis] = box.low[axis];
        region.high[axis] = box.high[axis];
    }
    if (lanes == 0) return false;
    boxes.enclose(lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (!(boxes.sign(lane) > 0)) return false;
    return true;
}

/// No line of the bundle is in the box before this t; infinite where none ever is, from t = 0 on.
double enter(const LineBundle& bundle, const LineRegion& box) {
    double near = 0, far = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double slowest = bundle.direction[axis] - bundle.directionSpread[axis],
                     fastest = bundle.direction[axis] + bundle.directionSpread[axis];
        // How far the walls are ahead, along the axis, of the line that is ahead of all, and of the last.
        const double toLow = box.low[axis] - (bundle.origin[axis] + bundle.originSpread[axis]),
                     toHigh = box.high[axis] - (bundle.origin[axis] - bundle.originSpread[axis]);
        if (toLow > 0) {
            if (!(fastest > 0)) return infinity;
            near = std::max(near, toLow / fastest);
        } else if (slowest < 0) {
            // Some lines may leave through the lower wall; all have left it at the latest then.
            if (fastest < 0) far = std::min(far, toLow / fastest);
        }
        if (toHigh < 0) {
            if (!(slowest < 0)) return infinity;
            near = std::max(near, toHigh / slowest);
        } else if (slowest > 0) {
            far = std::min(far, toHigh / slowest);
        }
    }
    return near <= far ? near : infinity;
}

}  // namespace

UnionParts::UnionParts(const PreparedFunction& function, const RootSettings& settings) {
    if (!settings.region || function.links().chains().places.empty()) return;
    const LineRegion& region = *settings.region;
    const glm::dvec3 center = 0.5 * (region.low + region.high);
    const double size = largest(region.high - region.low);
    if (!(size > 0) || !std::isfinite(size)) return;
    // Bundles reach further than their lines.
    region_ = {center - size, center + size};
    margin_ = 1e-9 * size;
    BoxPieces boxes(function, settings);
    BackwardBounds backward(*function.tape(), function.uniforms());
    const Interval inside = settings.positivePolarity ? Interval{settings.threshold, infinity}
                                                      : Interval{-infinity, settings.threshold};
    SimplifiedTape made;
    UnionWalk walk(function, settings.positivePolarity);
    for (; !walk.atEnd(); walk.advance(parts_.size())) {
        boxes.simplify(walk.decided, made);
        boxes.setBase(made);
        BackwardBounds::Box guess = backward.where(made, inside, region_);
        // Boxes that are enclosed are wider than they are said to be.
        guess.region.low = glm::max(guess.region.low - 1e-5 * size, region_.low);
        guess.region.high = glm::min(guess.region.high + 1e-5 * size, region_.high);
        const bool isProven = holdsAllOf(region_, guess.region, boxes);
        std::optional<LineRegion> box = isProven ? guess.region : region_;
        if (!isProven || !guess.isTight) box = shrink(*box, boxes);
        if (!box) continue;
        if (parts_.size() == mostParts) {
            parts_.clear();
            return;
        }
        // They are not shortened any more: memory that is touched has its price.
        Part& part = parts_.emplace_back();
        part.tape.instructions = made.instructions;
        part.tape.result = made.result;
        part.box = {box->low - margin_, box->high + margin_};
    }
    const bool areMany = parts_.size() >= ShortTapes::fewestChoices;
    if (!areMany || !areSmall(region, function.links().whole().instructions.size())) {
        parts_.clear();
        return;
    }
    forks_ = std::move(walk.forks);
    decisionWords_ = walk.decided.first.size();
    nodes_.resize(2 * std::bit_ceil(parts_.size()));
    order_.resize(parts_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, 0, parts_.size());
}

/// Whether what a line has to do with is little of the function, going by the chance that it meets a box.
bool UnionParts::areSmall(const LineRegion& region, std::size_t wholeLength) const {
    constexpr double worthwhileShare = 0.25;
    double met = 0;
    for (const Part& part : parts_) {
        const LineRegion seen{glm::max(part.box.low, region.low), glm::min(part.box.high, region.high)};
        if (glm::any(glm::greaterThan(seen.low, seen.high))) continue;
        met += areaOf(seen) / areaOf(region) * static_cast<double>(part.tape.instructions.size());
    }
    return met < worthwhileShare * static_cast<double>(wholeLength);
}

/// Halves the parts across the axis along which they are spread most, again and again.
void UnionParts::build(std::size_t node, std::size_t first, std::size_t count) {
    const auto order = std::span(order_).subspan(first, count);
    LineRegion& box = nodes_[node];
    box = parts_[order[0]].box;
    for (const std::uint32_t part : order) box = unite(box, parts_[part].box);
    if (count == 1) return;
    const glm::dvec3 size = box.high - box.low;
    const int axis = size.x >= largest(size) ? 0 : size.y >= largest(size) ? 1 : 2;
    const auto place = [&](std::uint32_t part) {
        return parts_[part].box.low[axis] + parts_[part].box.high[axis];
    };
    std::ranges::nth_element(order, order.begin() + static_cast<std::ptrdiff_t>(count / 2), {}, place);
    build(2 * node + 1, first, count / 2);
    build(2 * node + 2, first + count / 2, count - count / 2);
}

bool UnionParts::cover(const LineBundle& bundle) const {
    if (!(bundle.near >= 0)) return false;
    const glm::dvec3 span = glm::abs(bundle.direction) + bundle.directionSpread;
    // Places on lines are off by their roundings.
    constexpr double roundings = 1e-14;
    if (!(roundings * largest(glm::abs(bundle.origin) + bundle.far * span) < margin_)) return false;
    for (const double t : {bundle.near, bundle.far}) {
        const glm::dvec3 place = bundle.origin + t * bundle.direction,
                         reach = bundle.originSpread + t * bundle.directionSpread;
        if (!glm::all(glm::lessThanEqual(region_.low, place - reach)) ||
            !glm::all(glm::lessThanEqual(place + reach, region_.high)))
            return false;
    }
    return true;
}

/// take(part, what meets(box) has told) for each part whose box, and those around it, are met.
template <class Meets, class Take>
void UnionParts::descend(std::size_t node, std::size_t first, std::size_t count, Meets meets,
                         Take take) const {
    const auto meeting = meets(nodes_[node]);
    if (!meeting) return;
    if (count == 1) return take(order_[first], *meeting);
    descend(2 * node + 1, first, count / 2, meets, take);
    descend(2 * node + 2, first + count / 2, count - count / 2, meets, take);
}

void UnionParts::meet(const LineBundle& bundle, std::vector<Meeting>& meetings) const {
    meetings.clear();
    const auto near = [&](const LineRegion& box) -> std::optional<double> {
        const double t = enter(bundle, box);
        return t <= bundle.far ? std::optional(t) : std::nullopt;
    };
    descend(0, 0, parts_.size(), near, [&](std::uint32_t part, double t) { meetings.push_back({t, part}); });
    std::ranges::sort(meetings, [](const Meeting& a, const Meeting& b) {
        return a.near < b.near || (a.near == b.near && a.part < b.part);
    });
}

void UnionParts::meet(const glm::dvec3& point, std::vector<std::uint32_t>& met) const {
    const auto holds = [&](const LineRegion& box) -> std::optional<bool> {
        const bool inside =
            glm::all(glm::lessThanEqual(box.low, point)) && glm::all(glm::lessThanEqual(point, box.high));
        return inside ? std::optional(true) : std::nullopt;
    };
    descend(0, 0, parts_.size(), holds, [&](std::uint32_t part, bool) { met.push_back(part); });
}

void UnionParts::decide(std::span<const std::uint32_t> met, DecidedChoices& decided) const {
    // How many are met of the parts before each.
    std::vector<std::uint32_t> before(parts_.size() + 1);
    for (const std::uint32_t part : met) before[part + 1] = 1;
    std::partial_sum(before.begin(), before.end(), before.begin());
    decided.first.assign(decisionWords_, 0);
    decided.second.assign(decisionWords_, 0);
    constexpr std::uint32_t wordBits = 64;
    for (const Fork& fork : forks_) {
        const bool byFirst = before[fork.first] < before[fork.middle],
                   bySecond = before[fork.middle] < before[fork.end];
        if (byFirst == bySecond) continue;
        std::vector<std::uint64_t>& side = byFirst ? decided.first : decided.second;
        side[fork.place / wordBits] |= std::uint64_t(1) << fork.place % wordBits;
    }
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/bvh.h"

#include <cmath>
#include <glm/common.hpp>

#include "core/evaluate/tape/loop_stop.h"

namespace isoscope {

namespace {

constexpr int binCount = 16;
constexpr std::uint32_t leafSize = 4;
/// Deeper branches become leaves; the stack of visit() holds one entry a level and one more.
constexpr int depthLimit = 100;

double area(const Bounds& box) {
    const glm::dvec3 size = glm::max(box.high - box.low, glm::dvec3(0));
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

double center(const Bounds& box, int axis) { return box.low[axis] / 2 + box.high[axis] / 2; }

/// Where to cut a list of boxes along one axis.
struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    double place = 0;
};

Cut bestCut(std::span<const Bounds> boxes, std::span<const std::uint32_t> order, int axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t i : order) {
        low = std::min(low, center(boxes[i], axis));
        high = std::max(high, center(boxes[i], axis));
    }
    Cut best;
    if (!(low < high)) return best;
    struct Bin {
        Bounds box;
        std::size_t count = 0;
    };
    std::array<Bin, binCount> bins;
    for (const std::uint32_t i : order) {
        const double share = (center(boxes[i], axis) - low) / (high - low);
        Bin& bin = bins[static_cast<std::size_t>(std::min(share * binCount, binCount - 1.0))];
        bin.box = bin.count == 0 ? boxes[i] : unite(bin.box, boxes[i]);
        ++bin.count;
    }
    std::array<double, binCount> behind{};
    Bin right;
    for (std::size_t k = binCount - 1; k > 0; --k) {
        if (bins[k].count > 0) right.box = right.count == 0 ? bins[k].box : unite(right.box, bins[k].box);
        right.count += bins[k].count;
        behind[k - 1] = right.count == 0 ? 0 : area(right.box) * static_cast<double>(right.count);
    }
    Bin left;
    for (std::size_t k = 0; k + 1 < binCount; ++k) {
        if (bins[k].count > 0) left.box = left.count == 0 ? bins[k].box : unite(left.box, bins[k].box);
        left.count += bins[k].count;
        if (left.count == 0 || left.count == order.size()) continue;
        const double cost = area(left.box) * static_cast<double>(left.count) + behind[k];
        if (cost < best.cost) best = {cost, axis, low + (high - low) * static_cast<double>(k + 1) / binCount};
    }
    return best;
}

}  // namespace

Bvh::Bvh(std::span<const Bounds> boxes) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) (boxes[i].finite() ? order_ : unbounded_).push_back(i);
    if (order_.empty()) return;
    nodes_.reserve(2 * order_.size());
    nodes_.emplace_back();
    build(0, boxes, 0, static_cast<std::uint32_t>(order_.size()), 0);
}

Bounds Bvh::around(std::span<const Bounds> boxes, std::span<const std::uint32_t> order) {
    Bounds result = boxes[order.front()];
    for (const std::uint32_t i : order) result = unite(result, boxes[i]);
    return result;
}

void Bvh::build(std::uint32_t node, std::span<const Bounds> boxes, std::uint32_t begin, std::uint32_t end,
                int depth) {
    const std::span<std::uint32_t> own = std::span(order_).subspan(begin, end - begin);
    const Bounds box = around(boxes, own);
    nodes_[node].walls = {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
    Cut cut;
    // After a stop a leaf of many boxes is as right, and at once.
    if (own.size() > 1 && depth < depthLimit && !LoopStop::requested())
        for (int axis = 0; axis < 3; ++axis) {
            const Cut candidate = bestCut(boxes, own, axis);
            if (candidate.cost < cut.cost) cut = candidate;
        }
    const bool worthIt =
        std::isfinite(cut.cost) &&
        (own.size() > leafSize || cut.cost < area(box) * static_cast<double>(own.size() - 1));
    const auto middle = !worthIt ? own.begin() : std::partition(own.begin(), own.end(), [&](std::uint32_t i) {
        return center(boxes[i], cut.axis) < cut.place;
    });
    if (middle == own.begin() || middle == own.end()) {
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    const auto split = begin + static_cast<std::uint32_t>(middle - own.begin());
    nodes_[node].first = children;
    nodes_.emplace_back();
    nodes_.emplace_back();
    build(children, boxes, begin, split, depth + 1);
    build(children + 1, boxes, split, end, depth + 1);
}

}  // namespace isoscope

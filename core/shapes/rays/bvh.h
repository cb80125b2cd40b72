// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/shapes/bounds.h"
#include "core/shapes/rays/slab_batch.h"
#include "core/shapes/rays/slab_ray.h"

namespace isoscope {

struct BoxTreeWalk;

/// A bounding volume hierarchy over boxes: finds those that a ray may meet, near ones first. Built once by
/// the surface area heuristic over binned centers.
class Bvh {
  public:
    Bvh() = default;
    /// Infinite boxes are allowed; each of them is visited by every ray.
    explicit Bvh(std::span<const Bounds> boxes);

    /// Whether it was built of no boxes at all, infinite ones included.
    bool empty() const { return order_.empty() && unbounded_.empty(); }

    /// Calls `far = visit(index, far)` for boxes that the ray may meet within the interval; a smaller `far`
    /// leaves out what lies behind.
    template <class Visit>
    void visit(const Ray& ray, RayInterval interval, Visit visit) const;

    /// Calls `visit(index, numbers)` once for each box that some of the rays, which `slabs` holds, may meet
    /// at t >= 0, in no particular order; `numbers` are those of the rays, ascending. No ray is left out that
    /// Bounds::clip would let through. Infinite boxes get all rays. `mayMeet(box)` is false only where none
    /// of the rays meets the box: whole branches are passed by at its price.
    template <class MayMeet, class Visit>
    void visitMany(std::size_t rays, const SlabBatch& slabs, BoxTreeWalk& walk, MayMeet mayMeet,
                   Visit visit) const;

    /// Whether `accept(index)` holds for any box out of those in branches that `mayMeet(branch box)` lets
    /// through.
    template <class MayMeet, class Accept>
    bool any(MayMeet mayMeet, Accept accept) const;

  private:
    /// Two children behind one another, or a run of `count` boxes from order_[first] on.
    struct Node {
        std::array<double, 6> walls{};  ///< low x, y, z, high x, y, z
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< 0: the children are nodes `first` and `first + 1`
    };
    static Bounds boxOf(const Node& node) {
        const auto& w = node.walls;
        return {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
    }
    static double enter(const SlabRay& ray, const Node& node, RayInterval interval) {
        return ray.enter(node.walls.data(), node.walls.data() + 3, interval);
    }

    void build(std::uint32_t node, std::span<const Bounds> boxes, std::uint32_t begin, std::uint32_t end,
               int depth);
    static Bounds around(std::span<const Bounds> boxes, std::span<const std::uint32_t> order);

    template <class MayMeet, class Visit>
    void descend(std::uint32_t node, std::size_t first, const SlabBatch& slabs, BoxTreeWalk& walk,
                 const MayMeet& mayMeet, const Visit& visit) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> unbounded_;
};

/// The memory of Bvh::visitMany, kept from call to call.
struct BoxTreeWalk {
    std::vector<std::uint32_t> numbers;  ///< of the rays that go on, branch after branch
    std::uint64_t tests = 0;             ///< slab tests so far
};

/// The nearer child first; farther ones wait on a stack with the t at which the ray enters them.
template <class Visit>
void Bvh::visit(const Ray& ray, RayInterval interval, Visit visit) const {
    for (const std::uint32_t index : unbounded_) interval.far = visit(std::size_t{index}, interval.far);
    if (nodes_.empty()) return;
    const SlabRay slabs(ray);
    struct Entry {
        std::uint32_t node;
        double enter;
    };
    std::array<Entry, 128> stack;
    std::size_t depth = 0;
    constexpr double miss = std::numeric_limits<double>::infinity();
    Entry at{0, enter(slabs, nodes_[0], interval)};
    if (at.enter == miss) return;
    for (;;) {
        const Node& node = nodes_[at.node];
        if (node.count == 0) {
            Entry one{node.first, enter(slabs, nodes_[node.first], interval)};
            Entry other{node.first + 1, enter(slabs, nodes_[node.first + 1], interval)};
            if (other.enter < one.enter) std::swap(one, other);
            if (other.enter < miss) stack[depth++] = other;
            if (one.enter < miss) {
                at = one;
                continue;
            }
        } else {
            for (std::uint32_t k = 0; k < node.count; ++k)
                interval.far = visit(std::size_t{order_[node.first + k]}, interval.far);
        }
        do {
            if (depth == 0) return;
            at = stack[--depth];
        } while (at.enter > interval.far);
    }
}

/// Infinite boxes first, then from the root down, with the rays that are left at each node.
template <class MayMeet, class Visit>
void Bvh::visitMany(std::size_t rays, const SlabBatch& slabs, BoxTreeWalk& walk, MayMeet mayMeet,
                    Visit visit) const {
    walk.numbers.resize(rays);
    std::iota(walk.numbers.begin(), walk.numbers.end(), 0U);
    for (const std::uint32_t index : unbounded_)
        visit(std::size_t{index}, std::span(std::as_const(walk.numbers)));
    if (nodes_.empty()) return;
    descend(0, 0, slabs, walk, mayMeet, visit);
}

/// The rays that come to the node are walk.numbers from `first` on.
template <class MayMeet, class Visit>
void Bvh::descend(std::uint32_t at, std::size_t first, const SlabBatch& slabs, BoxTreeWalk& walk,
                  const MayMeet& mayMeet, const Visit& visit) const {
    constexpr std::size_t few = 16;  // whose own tests cost no more than that of all
    const Node& node = nodes_[at];
    const std::size_t end = walk.numbers.size();
    if (end - first >= few && !mayMeet(boxOf(node))) return;
    walk.tests += end - first;
    walk.numbers.resize(end + (end - first));
    std::uint32_t* const numbers = walk.numbers.data();
    walk.numbers.resize(end +
                        slabs.keepMeeting(boxOf(node), nullptr, numbers + first, end - first, numbers + end));
    if (walk.numbers.size() > end) {
        if (node.count == 0) {
            descend(node.first, end, slabs, walk, mayMeet, visit);
            descend(node.first + 1, end, slabs, walk, mayMeet, visit);
        } else {
            const std::span<const std::uint32_t> meeting =
                std::span(std::as_const(walk.numbers)).subspan(end);
            for (std::uint32_t k = 0; k < node.count; ++k)
                visit(std::size_t{order_[node.first + k]}, meeting);
        }
    }
    walk.numbers.resize(end);
}

/// Infinite boxes first, of which mayMeet() is not asked; then the tree until something is accepted.
template <class MayMeet, class Accept>
bool Bvh::any(MayMeet mayMeet, Accept accept) const {
    for (const std::uint32_t index : unbounded_)
        if (accept(std::size_t{index})) return true;
    if (nodes_.empty()) return false;
    std::array<std::uint32_t, 128> stack{};
    std::size_t depth = 1;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!mayMeet(boxOf(node))) continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = node.first + 1;
        }
        for (std::uint32_t k = 0; k < node.count; ++k)
            if (accept(std::size_t{order_[node.first + k]})) return true;
    }
    return false;
}

}  // namespace isoscope

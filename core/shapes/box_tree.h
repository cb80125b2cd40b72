// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shapes/bounds.h"

namespace isoscope {

/// A bounding volume hierarchy over boxes: finds those that a ray may meet, near ones first. Built once by
/// the surface area heuristic over binned centers.
class BoxTree {
  public:
    BoxTree() = default;
    /// Infinite boxes are allowed; each of them is visited by every ray.
    explicit BoxTree(std::span<const Bounds> boxes);

    bool empty() const { return order_.empty() && unbounded_.empty(); }

    /// Calls `far = visit(index, far)` for boxes that the ray may meet within the interval; a smaller `far`
    /// leaves out what lies behind.
    template <class Visit>
    void visit(const Ray& ray, RayInterval interval, Visit visit) const;

  private:
    /// Two children behind one another, or a run of `count` boxes from order_[first] on.
    struct Node {
        Bounds box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< 0: the children are nodes `first` and `first + 1`
    };
    /// A ray ready for many slab tests.
    struct Slabs {
        glm::dvec3 origin, inverse;

        explicit Slabs(const Ray& ray) : origin(ray.origin), inverse(1.0 / ray.direction) {}
        /// Where the ray enters the box, grown by what rounding may hide; more than `far` when it misses.
        double enter(const Bounds& box, RayInterval interval) const;
    };

    void build(std::uint32_t node, std::span<const Bounds> boxes, std::uint32_t begin, std::uint32_t end,
               int depth);
    static Bounds around(std::span<const Bounds> boxes, std::span<const std::uint32_t> order);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> unbounded_;
};

inline double BoxTree::Slabs::enter(const Bounds& box, RayInterval interval) const {
    constexpr double room = 1 + 1e-12;
    double near = interval.near, far = interval.far;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.low[axis] - origin[axis]) * inverse[axis];
        const double b = (box.high[axis] - origin[axis]) * inverse[axis];
        // 0 times infinity, on the very wall of a flat slab, is no reason to miss the box.
        if (a != a || b != b) continue;
        near = std::max(near, std::min(a, b) * (std::min(a, b) > 0 ? 2 - room : room));
        far = std::min(far, std::max(a, b) * (std::max(a, b) > 0 ? room : 2 - room));
    }
    return near <= far ? near : std::numeric_limits<double>::infinity();
}

template <class Visit>
void BoxTree::visit(const Ray& ray, RayInterval interval, Visit visit) const {
    for (const std::uint32_t index : unbounded_) interval.far = visit(std::size_t{index}, interval.far);
    if (nodes_.empty()) return;
    const Slabs slabs(ray);
    struct Entry {
        std::uint32_t node;
        double enter;
    };
    std::array<Entry, 128> stack;
    std::size_t depth = 0;
    constexpr double miss = std::numeric_limits<double>::infinity();
    const double root = slabs.enter(nodes_[0].box, interval);
    if (root < miss) stack[depth++] = {0, root};
    while (depth > 0) {
        const Entry entry = stack[--depth];
        if (entry.enter > interval.far) continue;
        const Node& node = nodes_[entry.node];
        if (node.count > 0) {
            for (std::uint32_t k = 0; k < node.count; ++k)
                interval.far = visit(std::size_t{order_[node.first + k]}, interval.far);
            continue;
        }
        Entry one{node.first, slabs.enter(nodes_[node.first].box, interval)};
        Entry other{node.first + 1, slabs.enter(nodes_[node.first + 1].box, interval)};
        if (one.enter < other.enter) std::swap(one, other);
        if (one.enter < miss) stack[depth++] = one;
        if (other.enter < miss) stack[depth++] = other;
    }
}

}  // namespace isoscope

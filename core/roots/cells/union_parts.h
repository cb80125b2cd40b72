// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/roots/certified/line_bundle.h"
#include "core/roots/root_settings.h"

namespace isoscope {

class PreparedFunction;

/// What a function is the union of: many parts, each with a tape of its own and a box around all that is
/// inside it. A line need not know the parts whose boxes it does not meet. The boxes are found once, by
/// enclosures, and kept in a tree that halves them: Kay and Kajiya, "Ray tracing complex scenes" (1986).
/// Immutable.
class UnionParts {
  public:
    /// One of the functions that the union is the least of (or the greatest, with positive polarity).
    struct Part {
        SimplifiedTape tape;  ///< of the function where this part alone decides; instructions and result
        LineRegion box;       ///< outside of which the part is certainly defined and outside
    };
    /// A part whose box some line of a bundle may meet, none before `near`.
    struct Meeting {
        double near = 0;
        std::uint32_t part = 0;
    };

    /// Empty where that is no use: the function is no union, settings.region is not told, or boxes are so
    /// large that lines meet most of them. The function must outlive the parts.
    UnionParts(const PreparedFunction& function, const RootSettings& settings);

    /// Those that are anywhere in the region; none where that is no use.
    bool empty() const { return parts_.empty(); }
    std::size_t size() const { return parts_.size(); }
    const Part& operator[](std::size_t k) const { return parts_[k]; }

    /// Whether the boxes hold for these lines: they begin at t >= 0 and lie in what was looked at.
    bool cover(const LineBundle& bundle) const;
    /// The parts that a covered bundle may meet, near ones first.
    void meet(const LineBundle& bundle, std::vector<Meeting>& meetings) const;

  private:
    bool areSmall(const LineRegion& region, std::size_t wholeLength) const;
    void build(std::size_t node, std::size_t first, std::size_t count);
    void descend(std::size_t node, std::size_t first, std::size_t count, const LineBundle& bundle,
                 std::vector<Meeting>& meetings) const;

    LineRegion region_;  ///< that was looked at
    double margin_ = 0;  ///< by which boxes are wider than what is in them
    std::vector<Part> parts_;
    // The tree: of `count` parts from order_[first] on, node k has the box nodes_[k], and its halves are the
    // nodes 2 k + 1 and 2 k + 2.
    std::vector<std::uint32_t> order_;
    std::vector<LineRegion> nodes_;
};

}  // namespace isoscope

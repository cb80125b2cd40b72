// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/tape/simplified_tape.h"
#include "core/evaluate/tape/tape_simplifier.h"
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

    /// Appends the parts in whose boxes a point is.
    void meet(const glm::dvec3& point, std::vector<std::uint32_t>& met) const;

    /// decided = the choices that leave the union of these parts, at least one: what the sign of the function
    /// depends on where no other part is met.
    void decide(std::span<const std::uint32_t> met, DecidedChoices& decided) const;

    /// A choice between the parts [first, middle) and [middle, end).
    struct Fork {
        std::uint32_t place = 0;  ///< of TapeLinks::Chains
        std::uint32_t first = 0, middle = 0, end = 0;
    };

  private:
    bool areSmall(const LineRegion& region, std::size_t wholeLength) const;
    void build(std::size_t node, std::size_t first, std::size_t count);
    template <class Meets, class Take>
    void descend(std::size_t node, std::size_t first, std::size_t count, Meets meets, Take take) const;

    LineRegion region_;  ///< that was looked at
    double margin_ = 0;  ///< by which boxes are wider than what is in them
    std::vector<Part> parts_;
    std::vector<Fork> forks_;
    std::size_t decisionWords_ = 0;  ///< of DecidedChoices
    // The tree: of `count` parts from order_[first] on, node k has the box nodes_[k], and its halves are the
    // nodes 2 k + 1 and 2 k + 2.
    std::vector<std::uint32_t> order_;
    std::vector<LineRegion> nodes_;
};

/// The parts of a function, found when they are first asked for.
class LazyUnionParts {
  public:
    /// Both must outlive it.
    LazyUnionParts(const PreparedFunction& function, const RootSettings& settings)
        : function_(function), settings_(settings) {}

    /// The parts, which stay as they are.
    const UnionParts& get() {
        if (!parts_) parts_.emplace(function_, settings_);
        return *parts_;
    }

  private:
    const PreparedFunction& function_;
    const RootSettings& settings_;
    std::optional<UnionParts> parts_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/arguments/root_bound.h"

#include <bit>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/shared_roots.h"
#include "core/evaluate/tape/tape_axes.h"
#include "core/evaluate/tape/tape_function.h"
#include "core/function/graph_builder.h"
#include "core/study/gradient/margin.h"

namespace isoscope {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// An argument of g: a root, or a coordinate.
struct Argument {
    std::size_t source;  ///< the instruction of the root, or the number of the coordinate
    double steepness;    ///< at least the length of its gradient
    Interval range;
};

/// The steepness and the range of a root in a box; none where they are not known.
std::optional<Argument> argumentOf(const PreparedFunction& function, std::size_t root,
                                   const GradientBox& box) {
    const Function alone = functionOf(
        *function.tape(), function.uniforms().values,
        {[](FunctionGraph& graph, std::size_t axis) { return graph.variable(static_cast<int>(axis)); },
         [](FunctionGraph&, std::size_t) { return noNode; }},
        root);
    if (alone.graph->overflowed()) return {};
    IntervalGradientEvaluator evaluator(*PreparedFunction::of(Tape::compile(alone), {}));
    const IntervalGradient& all = evaluator.evaluate(box.intervals());
    if (!all.bounded() || all.value.empty() || all.value.maybeUndefined || !(all.steepness > 0)) return {};
    return Argument{root, all.steepness, all.value};
}

/// g over its arguments, each divided by its steepness: |grad f| is at most the sum of the magnitudes of the
/// slopes.
class RootFunction {
  public:
    /// None where it has more arguments than three, or one without a bound.
    static std::optional<RootFunction> of(const PreparedFunction& function, const GradientBox& box) {
        constexpr std::size_t mostInstructions = 1000;
        const Tape& tape = *function.tape();
        if (!tape.loops().empty() || tape.instructions().size() > mostInstructions) return {};
        const std::vector<std::size_t> roots = sharedRoots(tape);
        if (roots.empty()) return {};
        const std::uint8_t axes = axesWithout(tape, roots).back();
        if (roots.size() + static_cast<std::size_t>(std::popcount(axes)) > 3) return {};
        RootFunction result;
        for (std::size_t k = 0; k < 3; ++k)
            if ((axes >> k & 1) != 0) result.arguments_.push_back({k, 1, box.intervals()[k]});
        const std::size_t coordinates = result.arguments_.size();
        for (const std::size_t root : roots) {
            const std::optional<Argument> argument = argumentOf(function, root, box);
            if (!argument) return {};
            result.arguments_.push_back(*argument);
        }
        const auto place = [&](std::size_t first, std::size_t last, std::size_t source) {
            for (std::size_t k = first; k < last; ++k)
                if (result.arguments_[k].source == source) return k;
            return result.arguments_.size();
        };
        const auto stretched = [&](FunctionGraph& graph, std::size_t k) {
            if (k == result.arguments_.size()) return noNode;
            const Expression variable(graph, graph.variable(static_cast<int>(k)));
            return (result.arguments_[k].steepness * variable).node();
        };
        const Function g = functionOf(
            tape, function.uniforms().values,
            {[&](FunctionGraph& graph, std::size_t axis) {
                 return stretched(graph, place(0, coordinates, axis));
             },
             [&](FunctionGraph& graph, std::size_t instruction) {
                 return stretched(graph, place(coordinates, result.arguments_.size(), instruction));
             }});
        if (g.graph->overflowed()) return {};
        result.evaluator_.emplace(*PreparedFunction::of(Tape::compile(g), {}));
        return result;
    }

    GradientBox domain() const {
        GradientBox box;
        for (std::size_t k = 0; k < arguments_.size(); ++k) {
            const Interval range = arguments_[k].range / Interval::point(arguments_[k].steepness);
            box.low[static_cast<int>(k)] = range.low;
            box.high[static_cast<int>(k)] = range.high;
        }
        return box;
    }

    std::uint64_t evaluations() const { return evaluator_->evaluations(); }

    /// At least the sum of the magnitudes of the slopes anywhere in the box. Sets the axis along which they
    /// change most.
    double boundOf(const GradientBox& box, double target, int& axis) {
        const auto range = box.intervals();
        const IntervalGradient whole = evaluator_->evaluate(range);
        axis = mostChanging(box, whole);
        if (whole.value.empty()) return 0;
        if (!whole.bounded() || whole.value.maybeUndefined) return infinite;
        const double all = sizeOf(whole.slope);
        const std::size_t choices = evaluator_->openChoices();
        if (all <= target || choices > mostOpenChoices) return all;
        double most = 0;
        for (unsigned sides = 0; sides < (1U << choices); ++sides) {
            most = std::max(most, boundOfPiece(box, sides, target));
            if (most >= all) return all;
        }
        return most;
    }

  private:
    static constexpr std::size_t mostOpenChoices = 4;

    static double sizeOf(const std::array<SlopeRange, 3>& slope) {
        return raised(raised(slope[0].size() + slope[1].size()) + slope[2].size());
    }

    static int mostChanging(const GradientBox& box, const IntervalGradient& whole) {
        const glm::dvec3 extent = box.high - box.low;
        glm::dvec3 change = extent;
        for (int k = 0; whole.smooth && k < 3; ++k) {
            double bend = 0;
            for (int j = 0; j < 3; ++j)
                bend +=
                    whole.bend[bendIndex(static_cast<std::size_t>(k), static_cast<std::size_t>(j))].size();
            change[k] *= bend;
        }
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::pair(change[k], extent[k]) > std::pair(change[axis], extent[axis])) axis = k;
        return axis;
    }

    double boundOfPiece(const GradientBox& box, unsigned sides, double target) {
        const IntervalGradient piece = evaluator_->evaluatePiece(box.intervals(), sides);
        const std::vector<IntervalGradient> margins(evaluator_->margins().begin(),
                                                    evaluator_->margins().end());
        for (const IntervalGradient& margin : margins)
            if (margin.value.high < 0) return 0;
        if (!piece.bounded() || piece.value.empty() || piece.value.maybeUndefined) return infinite;
        const double all = sizeOf(piece.slope);
        if (all <= target || !piece.smooth || piece.pieced) return all;
        const glm::dvec3 p = box.center();
        const std::array<Interval, 3> point{Interval::point(p.x), Interval::point(p.y), Interval::point(p.z)};
        const IntervalGradient at = evaluator_->evaluatePiece(point, sides);
        if (!at.bounded()) return all;
        std::vector<Margin> known;
        for (std::size_t k = 0; k < margins.size(); ++k)
            if (margins[k].bounded() && evaluator_->margins()[k].bounded())
                known.push_back({evaluator_->margins()[k].value.high, margins[k].slope});
        return std::min(all, boundAround(p, at, box, piece, known));
    }

    /// By the slopes at the middle of the box and how they change: the sum of the magnitudes is the largest
    /// slope along one of the diagonals, of which those count whose signs the slopes can have.
    static double boundAround(const glm::dvec3& p, const IntervalGradient& at, const GradientBox& box,
                              const IntervalGradient& piece, std::span<const Margin> margins) {
        const GradientDomain domain(ContainerBox{box.low, box.high});
        double most = 0;
        for (unsigned signs = 0; signs < 8; ++signs) {
            double start = 0;
            std::array<SlopeRange, 3> growth{};
            bool isPossible = true;
            for (std::size_t i = 0; i < 3; ++i) {
                const bool falls = (signs >> i & 1) != 0;
                isPossible = isPossible && (falls ? piece.slope[i].low < 0 : piece.slope[i].high >= 0);
                const double sign = falls ? -1 : 1;
                start = raised(start + (falls ? -at.slope[i].low : at.slope[i].high));
                for (std::size_t j = 0; j < 3; ++j)
                    growth[j] = growth[j] + sign * piece.bend[bendIndex(i, j)];
            }
            if (isPossible)
                most = std::max(most, raised(start + growthWithin(margins, growth, domain, box, p)));
        }
        return most;
    }

    std::vector<Argument> arguments_;
    std::optional<IntervalGradientEvaluator> evaluator_;
};

}  // namespace

RootBound boundByRoots(const PreparedFunction& function, const GradientDomain& domain, double target) {
    constexpr std::uint64_t mostBoxes = 30000;
    std::optional<RootFunction> g = RootFunction::of(function, domain.box());
    if (!g) return {};
    struct Part {
        GradientBox box;
        double bound;
        int axis;  ///< to halve along
        bool operator<(const Part& other) const { return bound < other.bound; }
    };
    std::priority_queue<Part> parts;
    double done = 0;
    const auto look = [&](const GradientBox& box, double known) {
        int axis = 0;
        const double bound = std::min(known, g->boundOf(box, target, axis));
        if (bound <= target)
            done = std::max(done, bound);
        else
            parts.push({box, bound, axis});
    };
    look(g->domain(), infinite);
    while (!parts.empty() && g->evaluations() < mostBoxes && !LoopStop::requested()) {
        const Part part = parts.top();
        const double middle = part.box.center()[part.axis];
        if (!(middle > part.box.low[part.axis] && middle < part.box.high[part.axis])) break;
        parts.pop();
        GradientBox lower = part.box, upper = part.box;
        lower.high[part.axis] = upper.low[part.axis] = middle;
        look(lower, part.bound);
        look(upper, part.bound);
    }
    if (LoopStop::requested()) return {infinite, g->evaluations()};
    return {parts.empty() ? done : std::max(done, parts.top().bound), g->evaluations()};
}

}  // namespace isoscope

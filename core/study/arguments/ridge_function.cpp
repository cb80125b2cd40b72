// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/arguments/ridge_function.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape_axes.h"
#include "core/evaluate/tape/tape_function.h"
#include "core/function/graph_builder.h"

namespace isoscope {

namespace {

using Row = std::array<Interval, 3>;

/// slope . p + offset, in real arithmetic.
struct LinearForm {
    Row slope{};
    Interval offset{};
    std::uint8_t axes = 0;  ///< bit k: depends on coordinate k
};

/// Where a function depends on its coordinates: through instructions that are linear forms, and the
/// coordinates beside.
struct RidgeCut {
    std::vector<std::size_t> instructions;
    std::uint8_t coordinates = 0;

    int arguments() const { return static_cast<int>(instructions.size()) + std::popcount(coordinates); }
};

double middleOf(const Interval& a) { return 0.5 * a.low + 0.5 * a.high; }
double sizeOf(const Interval& a) { return std::max(-a.low, a.high); }

Row scaled(const Row& row, const Interval& factor) {
    return {row[0] * factor, row[1] * factor, row[2] * factor};
}

Row sum(const Row& a, const Row& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Interval dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

LinearForm scaled(const LinearForm& form, const Interval& factor) {
    return {scaled(form.slope, factor), form.offset * factor, form.axes};
}

LinearForm coordinateForm(std::size_t axis) {
    LinearForm form{{}, {}, static_cast<std::uint8_t>(1 << axis)};
    form.slope[axis] = Interval::point(1);
    return form;
}

std::optional<LinearForm> linearResult(Operation operation, const LinearForm& a, const LinearForm& b) {
    const auto axes = static_cast<std::uint8_t>(a.axes | b.axes);
    switch (operation) {
        case Operation::negate: return scaled(a, Interval::point(-1));
        case Operation::add: return LinearForm{sum(a.slope, b.slope), a.offset + b.offset, axes};
        case Operation::subtract: {
            const LinearForm minus = scaled(b, Interval::point(-1));
            return LinearForm{sum(a.slope, minus.slope), a.offset + minus.offset, axes};
        }
        case Operation::multiply:
            if (b.axes == 0) return scaled(a, b.offset);
            if (a.axes == 0) return scaled(b, a.offset);
            return {};
        case Operation::divide:
            if (b.axes == 0) return scaled(a, Interval::point(1) / b.offset);
            return {};
        default: return {};
    }
}

/// What each instruction is, where it is a form.
std::vector<std::optional<LinearForm>> linearForms(const Tape& tape, const UniformValues& uniforms) {
    std::vector<std::optional<LinearForm>> slots(tape.slotCount()), all;
    for (std::size_t k = 0; k < static_cast<std::size_t>(tape.argumentCount()); ++k)
        slots[k] = k < 3 ? coordinateForm(k) : LinearForm{};
    for (std::size_t k = 0; k < uniforms.values.size(); ++k)
        slots[tape.firstUniform() + k] = LinearForm{{}, Interval::point(uniforms.values[k]), 0};
    for (const Instruction& instruction : tape.instructions()) {
        const auto& a = slots[instruction.operands[0]];
        const auto& b = slots[instruction.operands[instruction.operandCount > 1 ? 1 : 0]];
        const bool known = instruction.operandCount <= 2 && a && b;
        all.push_back(known ? linearResult(instruction.operation, *a, *b) : std::nullopt);
        slots[instruction.target] = all.back();
    }
    return all;
}

/// The cut with the fewest arguments, of these the last; none where that are not fewer than coordinates.
std::optional<RidgeCut> cutOf(const Tape& tape, std::span<const std::optional<LinearForm>> forms) {
    constexpr std::size_t mostForms = 24;
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < forms.size(); ++i)
        if (forms[i] && std::popcount(forms[i]->axes) > 1) candidates.push_back(i);
    int fewest = std::popcount(axesWithout(tape).back());
    std::optional<RidgeCut> best;
    const auto consider = [&](std::vector<std::size_t> instructions) {
        const std::uint8_t beside = axesWithout(tape, instructions).back();
        RidgeCut cut{std::move(instructions), beside};
        if (cut.arguments() > fewest - (best ? 0 : 1)) return;
        fewest = cut.arguments();
        best = std::move(cut);
    };
    for (const std::size_t i : candidates) consider({i});
    if (best || candidates.size() > mostForms) return best;
    for (const std::size_t i : candidates)
        for (const std::size_t k : candidates)
            if (k > i) consider({i, k});
    return best;
}

/// Forms as a lower triangular matrix times lengths along orthonormal axes, u = triangle w + offset: the
/// factor of Cholesky of their products, as doubles.
class Triangle {
  public:
    explicit Triangle(std::vector<LinearForm> forms) : forms_(std::move(forms)) {
        for (std::size_t i = 0; i < forms_.size(); ++i) {
            offset_[i] = middleOf(forms_[i].offset);
            for (std::size_t k = 0; k < forms_.size(); ++k)
                products_[i][k] = dot(forms_[i].slope, forms_[k].slope);
        }
        entries_[0][0] = std::sqrt(middleOf(products_[0][0]));
        if (count() == 1) return;
        entries_[1][0] = middleOf(products_[1][0]) / entries_[0][0];
        entries_[1][1] = std::sqrt(middleOf(products_[1][1]) - entries_[1][0] * entries_[1][0]);
    }

    std::size_t count() const { return forms_.size(); }
    double entry(std::size_t row, std::size_t column) const { return entries_[row][column]; }
    double offset(std::size_t row) const { return offset_[row]; }

    /// By how much a gradient may be longer than after the change of coordinates, as a part of it; infinite
    /// for forms that are nearly parallel.
    double slack() const {
        // Of forms as long as 1 the products are at most this much different from those of the triangle,
        // whose least eigenvalue is 1 - |cosine| or so.
        double difference = 0;
        for (std::size_t i = 0; i < count(); ++i)
            for (std::size_t k = 0; k < count(); ++k) {
                const Interval rounded = exact(i, 0) * exact(k, 0) + exact(i, 1) * exact(k, 1);
                difference = raised(difference + sizeOf((products_[i][k] - rounded) / scale(i, k)));
            }
        double cosine = 0;
        if (count() == 2) cosine = sizeOf(exact(1, 0) * exact(0, 0) / scale(0, 1));
        constexpr double leastAngle = 1e-4;
        const double least = lowered(1 - cosine);
        if (!(least > leastAngle) || !std::isfinite(difference))
            return std::numeric_limits<double>::infinity();
        return 2 * difference / least;
    }

    /// The lengths along the axes as functions of the place.
    std::array<LinearForm, 2> axes() const {
        std::array<LinearForm, 2> result{};
        for (std::size_t i = 0; i < count(); ++i) {
            result[i] = forms_[i];
            result[i].offset = result[i].offset - Interval::point(offset_[i]);
            if (i == 1) {
                const LinearForm less = scaled(result[0], -exact(1, 0));
                result[1].slope = sum(result[1].slope, less.slope);
                result[1].offset = result[1].offset + less.offset;
            }
            result[i] = scaled(result[i], Interval::point(1) / exact(i, i));
        }
        return result;
    }

  private:
    Interval exact(std::size_t row, std::size_t column) const {
        return Interval::point(entries_[row][column]);
    }
    Interval scale(std::size_t i, std::size_t k) const {
        return sqrt(products_[i][i]) * sqrt(products_[k][k]);
    }

    std::vector<LinearForm> forms_;
    std::array<std::array<Interval, 2>, 2> products_{};
    std::array<std::array<double, 2>, 2> entries_{};
    std::array<double, 2> offset_{};
};

/// The function with the forms of the cut, which come behind its coordinates in the triangle, for the
/// instructions.
Function ridgeOf(const PreparedFunction& function, const RidgeCut& cut, const Triangle& triangle) {
    const auto form = [&](FunctionGraph& graph, int row) {
        Expression value(graph, graph.constant(triangle.offset(static_cast<std::size_t>(row))));
        for (int k = 0; k <= row; ++k)
            value = value + triangle.entry(static_cast<std::size_t>(row), static_cast<std::size_t>(k)) *
                                Expression(graph, graph.variable(k));
        return value.node();
    };
    TapeStandIns standIns;
    standIns.coordinate = [&](FunctionGraph& graph, std::size_t axis) {
        const unsigned bit = 1U << axis;
        if ((cut.coordinates & bit) == 0) return noNode;
        return form(graph, std::popcount(cut.coordinates & (bit - 1)));
    };
    standIns.instruction = [&](FunctionGraph& graph, std::size_t i) {
        const auto found = std::ranges::find(cut.instructions, i);
        if (found == cut.instructions.end()) return noNode;
        return form(graph,
                    std::popcount(cut.coordinates) + static_cast<int>(found - cut.instructions.begin()));
    };
    return functionOf(*function.tape(), function.uniforms().values, standIns);
}

/// Where the lengths along the axes may be in all of a container.
class Image {
  public:
    Image(const Container& container, std::span<const LinearForm> axes)
        : container_(container), axes_(axes) {}

    /// Of their sum with these factors.
    Interval range(double first, double second) const {
        const Interval factors[2] = {Interval::point(first), Interval::point(second)};
        Row slope = scaled(axes_[0].slope, factors[0]);
        Interval offset = axes_[0].offset * factors[0];
        if (axes_.size() > 1) {
            slope = sum(slope, scaled(axes_[1].slope, factors[1]));
            offset = offset + axes_[1].offset * factors[1];
        }
        const GradientDomain domain(container_);
        if (!domain.isBall()) return dot(slope, domain.box().intervals()) + offset;
        const glm::dvec3 c = domain.ballCenter();
        const Row center{Interval::point(c.x), Interval::point(c.y), Interval::point(c.z)};
        const Interval reach = Interval::point(domain.radius()) * sqrt(dot(slope, slope));
        return dot(slope, center) + offset + hull(reach, -reach);
    }

    GradientDomain domain() const {
        const Interval first = range(1, 0);
        ContainerBox box{{first.low, 0, 0}, {first.high, 0, 0}};
        if (axes_.size() == 1) return GradientDomain(box);
        const Interval second = range(0, 1);
        if (const GradientDomain all(container_); all.isBall()) {
            // The ball itself, as wide as roundings make it.
            double radius = all.radius() * (1 + 1e-9);
            for (const Interval& along : {first, second})
                radius += std::max(0.0, raised(0.5 * along.width()) - all.radius());
            const glm::dvec3 center(middleOf(first), middleOf(second), 0);
            return GradientDomain(ContainerSphere{center, raised(radius)}).flattened(2);
        }
        box.low.y = second.low;
        box.high.y = second.high;
        std::vector<GradientDomain::Strip> strips;
        for (std::size_t k = 0; k < 3; ++k) {
            // Along an edge of the container, seen from the axes.
            const glm::dvec3 edge(middleOf(axes_[0].slope[k]), middleOf(axes_[1].slope[k]), 0);
            constexpr double shortest = 1e-6;
            if (!(glm::length(edge) > shortest)) continue;
            const glm::dvec3 across = glm::dvec3(-edge.y, edge.x, 0) / glm::length(edge);
            const Interval reach = range(across.x, across.y);
            strips.push_back({across, reach.low, reach.high});
        }
        return GradientDomain(box, std::move(strips));
    }

  private:
    const Container& container_;
    std::span<const LinearForm> axes_;
};

}  // namespace

std::optional<RidgeFunction> RidgeFunction::of(const PreparedFunction& function, const Container& container) {
    constexpr std::size_t mostInstructions = 1000;
    constexpr double mostSlack = 1e-10;
    const Tape& tape = *function.tape();
    if (!tape.loops().empty() || tape.instructions().size() > mostInstructions) return {};
    if (GradientDomain(container).empty()) return {};
    const std::vector<std::optional<LinearForm>> forms = linearForms(tape, function.uniforms());
    const std::optional<RidgeCut> cut = cutOf(tape, forms);
    if (!cut || cut->arguments() > 2) return {};
    std::vector<LinearForm> arguments;
    for (std::size_t k = 0; k < 3; ++k)
        if ((cut->coordinates >> k & 1) != 0) arguments.push_back(coordinateForm(k));
    for (const std::size_t i : cut->instructions) arguments.push_back(*forms[i]);
    const std::size_t count = arguments.size();
    const Triangle triangle(std::move(arguments));
    const double slack = triangle.slack();
    if (!(slack <= mostSlack)) return {};

    const std::array<LinearForm, 2> axes = triangle.axes();
    const Function ridge = ridgeOf(function, *cut, triangle);
    const GradientDomain domain = Image(container, std::span(axes).first(count)).domain();
    if (ridge.graph->overflowed() || domain.empty()) return {};
    RidgeFunction result{PreparedFunction::of(Tape::compile(ridge), {}), domain, slack, {}, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const Row& slope = axes[i].slope;
        result.axes[i] = {middleOf(slope[0]), middleOf(slope[1]), middleOf(slope[2])};
        result.origin[static_cast<int>(i)] = middleOf(axes[i].offset);
    }
    return result;
}

namespace {

/// A place of the container at this distance along a unit vector: between the first and the last of all.
glm::dvec3 placeAlong(const glm::dvec3& axis, double distance, const GradientDomain& container) {
    const glm::dvec3 center = container.box().center();
    // From so far off what is nearest is a corner of a box, or where a ball is touched, up to roundings.
    const double away = 1e6 * (container.box().width() + glm::length(center));
    const glm::dvec3 first = container.nearest(center - away * axis),
                     last = container.nearest(center + away * axis);
    const double low = glm::dot(axis, first), high = glm::dot(axis, last);
    const double part = high > low ? std::clamp((distance - low) / (high - low), 0.0, 1.0) : 0.0;
    return container.nearest(glm::mix(first, last, part));
}

}  // namespace

/// Of two arguments, by turns the nearest with these and the nearest in the container.
glm::dvec3 RidgeFunction::placeOf(const glm::dvec3& arguments, const GradientDomain& container) const {
    if (axes[1] == glm::dvec3(0)) return placeAlong(axes[0], arguments.x - origin.x, container);
    constexpr int rounds = 200;
    glm::dvec3 place = container.nearest(container.box().center());
    for (int round = 0; round < rounds; ++round) {
        for (int k = 0; k < 2; ++k) {
            const glm::dvec3& axis = axes[static_cast<std::size_t>(k)];
            place += axis * (arguments[k] - origin[k] - glm::dot(axis, place));
        }
        place = container.nearest(place);
    }
    return place;
}

}  // namespace isoscope

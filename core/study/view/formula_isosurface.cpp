// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/formula_isosurface.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/evaluate/interval_evaluator.h"
#include "core/language/parse.h"
#include "core/study/gradient/gradient_study.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

constexpr double reach = 10;
constexpr int boxLimit = 60'000;
/// What is seen of a surface that goes on for ever.
constexpr double partSize = 2;
/// The whole surface is this much smaller than its container, so that rounding does not cut it.
constexpr double margin = 1.05;

std::string numeral(double value) { return shortestNumber(value); }

std::string vectorText(const glm::dvec3& v) {
    return "<" + numeral(v.x) + ", " + numeral(v.y) + ", " + numeral(v.z) + ">";
}

/// Away from 0 to a multiple of a tenth of its power of ten: 1.02 becomes 1.1, 13.2 becomes 14.
double roundedOut(double value) {
    if (value == 0) return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value)) - 1e-9) - 1);
    const double steps = std::ceil(std::abs(value) / unit - 1e-9);
    const double rounded = std::round(steps * unit * 1e9) / 1e9;
    return std::copysign(rounded, value);
}

/// Whether the function may be 0 in a box, by halving boxes until they are small or many.
class SurfaceBounds {
  public:
    SurfaceBounds(IntervalEvaluator& function, std::stop_token stop) : function_(function), stop_(stop) {}

    /// The part of the box in which the surface certainly lies; empty where there is none.
    std::optional<GradientBox> within(const GradientBox& start) {
        std::deque<GradientBox> boxes{start};
        // Level by level, so that the answer is as good everywhere when the limit is reached.
        int looked = 0;
        while (!boxes.empty() && looked < boxLimit && !stop_.stop_requested()) {
            const GradientBox box = boxes.front();
            boxes.pop_front();
            ++looked;
            if (!mayHold(box)) continue;
            if (box.width() < start.width() / 128) {
                add(box);
                continue;
            }
            halve(box, boxes);
        }
        for (const GradientBox& box : boxes) add(box);
        return hull_;
    }

  private:
    bool mayHold(const GradientBox& box) {
        const std::array<Interval, 3> sides = box.intervals();
        const Interval value = function_.evaluate(sides);
        return value.low <= 0 && value.high >= 0;
    }

    static void halve(const GradientBox& box, std::deque<GradientBox>& boxes) {
        const glm::dvec3 size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        GradientBox lower = box, upper = box;
        lower.high[axis] = upper.low[axis] = 0.5 * (box.low[axis] + box.high[axis]);
        boxes.push_back(lower);
        boxes.push_back(upper);
    }

    void add(const GradientBox& box) {
        if (!hull_) hull_ = box;
        hull_->low = glm::min(hull_->low, box.low);
        hull_->high = glm::max(hull_->high, box.high);
    }

    IntervalEvaluator& function_;
    std::stop_token stop_;
    std::optional<GradientBox> hull_;
};

double largestOf(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// Sets container and `bounded`.
void choose(FormulaIsosurface& surface, IntervalEvaluator& function, const std::stop_token& stop) {
    const auto cube = [](double size) { return GradientBox{glm::dvec3(-size), glm::dvec3(size)}; };
    // The first look tells roughly where it is, the second, in a box about as large as it, exactly.
    std::optional<GradientBox> found = SurfaceBounds(function, stop).within(cube(reach));
    const auto extent = [](const GradientBox& box) {
        return std::max(largestOf(glm::abs(box.low)), largestOf(glm::abs(box.high)));
    };
    surface.bounded = found && extent(*found) < reach;
    if (surface.bounded) {
        found = SurfaceBounds(function, stop).within(*found);
        if (!found) surface.bounded = false;
    }
    if (surface.bounded) {
        const auto out = [](double low, double high, double sign) {
            const double value = 0.5 * (low + high) + sign * 0.5 * (high - low) * margin;
            // Never inwards.
            return value * sign > 0 ? roundedOut(value) : value - std::fmod(value, 0.05);
        };
        ContainerBox box;
        for (int k = 0; k < 3; ++k) {
            box.low[k] = out(found->low[k], found->high[k], -1);
            box.high[k] = out(found->low[k], found->high[k], 1);
            // Nearly the same on both sides is meant to be the same.
            const double both = std::max(-box.low[k], box.high[k]);
            if (box.low[k] < 0 && box.high[k] > 0 && std::min(-box.low[k], box.high[k]) > 0.9 * both)
                box.low[k] = -(box.high[k] = both);
        }
        surface.container = box;
        return;
    }
    // A part: a larger one only where the nearer has nothing of it.
    double size = partSize;
    while (size < reach && !SurfaceBounds(function, stop).within(cube(size))) size *= 2.5;
    surface.container = ContainerBox{glm::dvec3(-size), glm::dvec3(size)};
}

double provenGradient(const std::shared_ptr<const Tape>& tape, std::span<const double> parameters,
                      const Container& container, const std::stop_token& stop) {
    GradientStudySettings settings;
    settings.boxLimit = 50'000;
    GradientStudy study(tape, parameters, container, settings);
    const GradientBracket bracket = study.run(stop);
    if (std::isfinite(bracket.upper) && bracket.upper > 0) return roundValueAbove(bracket.upper);
    // Without a bound, twice of what was met: the panels tell the rest.
    const double met = std::isfinite(study.sampled()) ? study.sampled() : 0;
    return roundValueAbove(std::clamp(2 * met, 1.0, 1000.0));
}

std::string statementText(const BareFormula& formula, const FormulaIsosurface& surface) {
    const auto& box = std::get<ContainerBox>(surface.container);
    return "isosurface {\n  function { " + formula.function + " }\n  contained_by { box { " +
           vectorText(box.low) + ", " + vectorText(box.high) + " } }\n  threshold 0\n  max_gradient " +
           numeral(surface.maxGradient) + "\n" + (surface.bounded ? "" : "  open\n") +
           "  pigment { rgb <0.85, 0.30, 0.25> }\n  finish { ambient 0.1 diffuse 0.8 phong 0.5 }\n}\n";
}

/// A camera that has all of the container in its picture, and lights as far away.
std::string sceneText(const FormulaIsosurface& surface) {
    const auto& box = std::get<ContainerBox>(surface.container);
    const glm::dvec3 center = 0.5 * (box.low + box.high);
    const double radius = 0.5 * glm::length(box.high - box.low);
    // Half of the smaller field of view, of a picture of 4 to 3 that is 40 degrees wide, is 15 degrees.
    const glm::dvec3 direction = glm::normalize(glm::dvec3(2.4, 1.8, -3.2));
    const auto rounded = [](const glm::dvec3& v) { return glm::round(v * 100.0) / 100.0; };
    const double light = std::max(1.0, radius / 1.7);
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n\ncamera {\n  location " +
           vectorText(rounded(center + direction * radius / std::sin(0.27))) +
           "\n  right x*image_width/image_height\n  look_at " + vectorText(rounded(center)) +
           "\n  angle 40\n}\nlight_source { " + vectorText(rounded(center + glm::dvec3(4, 6, -5) * light)) +
           " rgb 0.9 }\nlight_source { " + vectorText(rounded(center + glm::dvec3(-6, 2, -3) * light)) +
           " rgb <0.2, 0.24, 0.32> shadowless }\nbackground { rgb <0.020, 0.022, 0.028> }\n\n" +
           surface.statement;
}

}  // namespace

FormulaIsosurface formulaIsosurface(const BareFormula& formula, const SymbolTable& symbols,
                                    std::stop_token stop) {
    FormulaIsosurface surface;
    std::string prelude;
    for (const std::string& name : formula.names)
        if (const Value* value = symbols.find(name))
            if (const auto* number = std::get_if<NumberValue>(&value->data))
                prelude += "#declare " + name + " = " + exactNumber(number->value) + ";\n";
    const ParsedFunction parsed = parseFunction(formula.function, prelude);
    if (!parsed.ok()) return surface;
    const auto tape = Tape::compile(parsed.value.function);
    IntervalEvaluator function(tape, parsed.parameterTable);
    choose(surface, function, stop);
    surface.maxGradient = provenGradient(tape, parsed.parameterTable, surface.container, stop);
    surface.statement = statementText(formula, surface);
    surface.scene = sceneText(surface);
    return surface;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/formulas/derivative_text.h"

#include <algorithm>
#include <map>
#include <vector>

#include "core/exchange/function_text.h"
#include "core/function/derivative.h"
#include "core/function/graph_builder.h"
#include "core/function/graph_copy.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

/// What is used more than once and longer than this gets a name of its own.
constexpr std::size_t worthAName = 60;
constexpr std::size_t lengthLimit = 1'000'000;
/// Shorter gradients count as this long, so that nothing is divided by 0.
constexpr double leastGradient = 1e-6;
const std::vector<std::string> variables{"x", "y", "z"};

std::string declared(const std::string& name, const std::string& body) {
    return "#declare " + name + " = function(x, y, z) { " + body + " }\n";
}

/// Writes functions of one graph one after the other; what they have in common is written once.
class Writer {
  public:
    Writer(const Function& function, std::span<const double> parameters, std::string name)
        : function_(function), parameters_(parameters), name_(std::move(name)) {}

    /// False when it cannot be written.
    bool write() {
        const FunctionGraph& graph = *function_.graph;
        std::vector<int> uses(graph.size(), 0);
        std::vector<bool> needed(graph.size(), false);
        for (const NodeId result : function_.results) {
            ++uses[result];
            const std::vector<bool> own = neededNodes(graph, result);
            for (NodeId id = 0; id < own.size(); ++id) needed[id] = needed[id] || own[id];
        }
        for (NodeId id = 0; id < graph.size(); ++id)
            if (needed[id])
                for (const NodeId operand : graph.operandsOf(id)) ++uses[operand];
        for (NodeId id = 0; id < graph.size(); ++id) {
            const bool isResult = std::ranges::find(function_.results, id) != function_.results.end();
            if (!needed[id] || uses[id] < 2 || isResult) continue;
            const auto text = textOf(id);
            if (!text) return false;
            if (text->size() > worthAName && !name(id, *text)) return false;
        }
        const char* const endings[] = {"", "_dx", "_dy", "_dz", "_gradient", "_normalised"};
        for (std::size_t k = 0; k < function_.results.size(); ++k) {
            const auto known = named_.find(function_.results[k]);
            const auto text = known != named_.end() ? known->second : textOf(function_.results[k]);
            if (!text) return false;
            text_ += declared(name_ + endings[k], *text);
            // A number or a variable is shorter than its name.
            if (graph.operandsOf(function_.results[k]).size() > 0)
                named_[function_.results[k]] = name_ + endings[k] + "(x, y, z)";
            if (text_.size() > lengthLimit) return false;
        }
        return true;
    }
    const std::string& text() const { return text_; }

  private:
    std::optional<std::string> textOf(NodeId id) const {
        return functionText({function_.graph, {id}, 3}, variables, parameters_, FunctionNotation::povray,
                            named_);
    }
    bool name(NodeId id, const std::string& text) {
        const std::string name = name_ + "_part" + std::to_string(++parts_);
        text_ += declared(name, text);
        named_[id] = name + "(x, y, z)";
        return text_.size() <= lengthLimit;
    }

    const Function& function_;
    std::span<const double> parameters_;
    std::string name_, text_;
    std::map<NodeId, std::string> named_;
    int parts_ = 0;
};

}  // namespace

DerivativeText derivativeText(const Isosurface& surface, std::span<const double> parameters,
                              const std::string& name) {
    DerivativeText answer;
    const GradientFunction gradient = gradientOf(surface.settings().function);
    if (!gradient.function.valid()) {
        answer.problem = gradient.missing ? "There is no formula for the derivative of `" +
                                                std::string(isoscope::name(*gradient.missing)) + "`."
                                          : "The derivative becomes too large.";
        return answer;
    }
    FunctionGraph graph;
    GraphCopy copy;
    copy.variable = [&](std::uint32_t index) { return graph.variable(static_cast<int>(index)); };
    std::vector<NodeId> results;
    for (std::size_t k = 0; k < 4; ++k) results.push_back(copy.into(graph, gradient.function, k));
    const auto at = [&](std::size_t k) { return Expression(graph, results[k]); };
    const Expression length = sqrt(sq(at(1)) + sq(at(2)) + sq(at(3)));
    const double threshold = surface.settings().threshold;
    const Expression height = threshold == 0 ? at(0) : at(0) - threshold;
    const Expression normalised = height / max(length, leastGradient);
    results.push_back(length.node());
    results.push_back(normalised.node());
    if (graph.overflowed()) {
        answer.problem = "The derivative becomes too large.";
        return answer;
    }
    const Function all = finish(std::move(graph), results, 3);
    Writer writer(all, parameters, name);
    if (!writer.write()) {
        answer.problem = "The derivative is too long for a text, or asks for what POV-Ray's language lacks.";
        return answer;
    }
    answer.declarations = writer.text();
    answer.normalised = {all.graph, {results.back()}, 3};
    return answer;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/polynomial_expansion.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/shapes/solids/poly.h"

namespace isoscope::virtualight {

namespace {

/// Coefficients by the powers of x, y and z.
using Powers = std::array<int, 3>;
using Terms = std::map<Powers, double>;

/// Products of two terms that one expansion may ask for.
constexpr std::size_t workLimit = 5'000'000;

class Expander {
  public:
    explicit Expander(const FunctionGraph& graph) : graph_(graph), values_(graph.size()) {}

    std::optional<Terms> expand(NodeId result) {
        std::vector<bool> used(graph_.size(), false);
        used[result] = true;
        for (NodeId id = result + 1; id-- > 0;)
            if (used[id])
                for (const NodeId operand : graph_.operandsOf(id)) used[operand] = true;
        for (NodeId id = 0; id <= result; ++id)
            if (used[id] && !compute(id)) return std::nullopt;
        return values_[result];
    }
    const std::string& problem() const { return problem_; }
    std::size_t work() const { return work_; }

  private:
    bool compute(NodeId id) {
        const Node& node = graph_[id];
        Terms& value = values_[id];
        const auto operand = [&](std::size_t k) -> const Terms& { return values_[node.operands[k]]; };
        switch (node.operation) {
            case Operation::constant: value = constant(node.value); return true;
            case Operation::variable: return variable(node.index, value);
            case Operation::negate: value = scaled(operand(0), -1); return true;
            case Operation::add: value = sum(operand(0), operand(1), 1); return true;
            case Operation::subtract: value = sum(operand(0), operand(1), -1); return true;
            case Operation::square: return multiply(operand(0), operand(0), value);
            case Operation::multiply: return multiply(operand(0), operand(1), value);
            case Operation::divide: return divide(operand(0), operand(1), value);
            case Operation::power: return power(operand(0), operand(1), value);
            default: break;
        }
        problem_ = "`" + std::string(name(node.operation)) + "` makes no polynomial.";
        return false;
    }

    static Terms constant(double value) { return value == 0 ? Terms() : Terms{{Powers{}, value}}; }

    bool variable(std::uint32_t index, Terms& value) {
        if (index > 2) {
            problem_ = "A polynomial surface is one of x, y and z.";
            return false;
        }
        Powers powers{};
        powers[index] = 1;
        value = Terms{{powers, 1.0}};
        return true;
    }

    static Terms scaled(Terms terms, double factor) {
        for (auto& [powers, coefficient] : terms) coefficient *= factor;
        return terms;
    }

    static Terms sum(const Terms& a, const Terms& b, double sign) {
        Terms result = a;
        for (const auto& [powers, coefficient] : b) {
            double& total = result[powers];
            total += sign * coefficient;
            if (total == 0) result.erase(powers);
        }
        return result;
    }

    bool multiply(const Terms& a, const Terms& b, Terms& product) {
        work_ += a.size() * b.size() + 1;
        if (work_ > workLimit) {
            problem_ = "The polynomial takes too much work to multiply out.";
            return false;
        }
        Terms result;
        for (const auto& [p, c] : a)
            for (const auto& [q, d] : b) {
                const Powers powers{p[0] + q[0], p[1] + q[1], p[2] + q[2]};
                if (powers[0] + powers[1] + powers[2] > polynomialOrderLimit) return tooHigh();
                result[powers] += c * d;
            }
        product = std::move(result);
        return true;
    }

    bool tooHigh() {
        problem_ =
            "The order of a polynomial surface is " + std::to_string(polynomialOrderLimit) + " at most.";
        return false;
    }

    static std::optional<double> constantOf(const Terms& terms) {
        if (terms.empty()) return 0.0;
        if (terms.size() == 1 && terms.begin()->first == Powers{}) return terms.begin()->second;
        return std::nullopt;
    }

    bool divide(const Terms& a, const Terms& b, Terms& value) {
        const std::optional<double> divisor = constantOf(b);
        if (!divisor || *divisor == 0) {
            problem_ = "A polynomial can only be divided by a number other than 0.";
            return false;
        }
        value = a;
        for (auto& [powers, coefficient] : value) coefficient /= *divisor;
        return true;
    }

    bool power(const Terms& base, const Terms& exponent, Terms& value) {
        const std::optional<double> wanted = constantOf(exponent);
        if (!wanted || *wanted != std::floor(*wanted) || *wanted < 0) {
            problem_ = "The powers of a polynomial are whole numbers from 0 on.";
            return false;
        }
        if (*wanted > polynomialOrderLimit) return tooHigh();
        Terms result = constant(1);
        for (int k = 0; k < static_cast<int>(*wanted); ++k) {
            Terms next;
            if (!multiply(result, base, next)) return false;
            result = std::move(next);
        }
        value = std::move(result);
        return true;
    }

    const FunctionGraph& graph_;
    std::vector<Terms> values_;
    std::size_t work_ = 0;
    std::string problem_;
};

}  // namespace

PolynomialExpansion expandPolynomial(const Function& function) {
    PolynomialExpansion result;
    Expander expander(*function.graph);
    const std::optional<Terms> terms = expander.expand(function.results[0]);
    result.problem = expander.problem();
    result.work = expander.work();
    if (!terms) return result;
    int order = 0;
    for (const auto& [powers, coefficient] : *terms) {
        if (!std::isfinite(coefficient))
            result.problem = "The polynomial has coefficients that are not finite.";
        if (coefficient != 0) order = std::max(order, powers[0] + powers[1] + powers[2]);
    }
    if (order == 0 && result.problem.empty())
        result.problem = "The polynomial is the same everywhere, so it has no surface.";
    if (!result.problem.empty()) return result;
    // A plane counts as the quadratic that POV-Ray can write.
    result.polynomial.order = std::max(order, 2);
    std::vector<double>& coefficients = result.polynomial.coefficients;
    for (int x = result.polynomial.order; x >= 0; --x)
        for (int y = result.polynomial.order - x; y >= 0; --y)
            for (int z = result.polynomial.order - x - y; z >= 0; --z) {
                const auto found = terms->find(Powers{x, y, z});
                coefficients.push_back(found == terms->end() ? 0 : found->second);
            }
    return result;
}

}  // namespace isoscope::virtualight

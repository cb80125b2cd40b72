// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <span>

#include "core/function/function_graph.h"

namespace isoscope {

/// A node together with its graph, so that formulas can be written as formulas: `sqrt(sq(x) + sq(z)) - p[0]`.
/// All operands of an expression must belong to the same graph.
class Expression {
  public:
    Expression() = default;
    Expression(FunctionGraph& graph, NodeId node) : graph_(&graph), node_(node) {}

    /// Not for a default-made expression, which has none. The graph must outlive the expression.
    FunctionGraph& graph() const { return *graph_; }
    /// The node's number in graph(); noNode for a default-made expression.
    NodeId node() const { return node_; }
    /// A constant of the same graph.
    Expression number(double value) const { return {*graph_, graph_->constant(value)}; }

  private:
    FunctionGraph* graph_ = nullptr;
    NodeId node_ = noNode;
};

Expression operator+(Expression a, Expression b);
Expression operator-(Expression a, Expression b);
Expression operator*(Expression a, Expression b);
Expression operator/(Expression a, Expression b);
Expression operator-(Expression a);
Expression operator+(Expression a, double b);
Expression operator-(Expression a, double b);
Expression operator*(Expression a, double b);
Expression operator/(Expression a, double b);
Expression operator+(double a, Expression b);
Expression operator-(double a, Expression b);
Expression operator*(double a, Expression b);
Expression operator/(double a, Expression b);

/// The operation as a node of the operands' graph, with its semantics (docs/povray/operators.md) and folding.
Expression apply(Operation operation, Expression a);
Expression apply(Operation operation, Expression a, Expression b);

/// One operation each, NaN and arguments out of range as in Operation; angles in radians.
Expression sq(Expression a);
Expression sqrt(Expression a);
Expression exp(Expression a);
Expression sin(Expression a);
Expression cos(Expression a);
Expression abs(Expression a);
Expression floor(Expression a);
Expression atan2(Expression ordinate, Expression abscissa);
Expression pow(Expression base, Expression exponent);
/// base to a whole exponent: 0 to 8 by multiplication in the order of docs/povray/operators.md, others by
/// pow().
Expression powi(Expression base, int exponent);
/// fmod, minimum and maximum, as in Operation; clamp() gives `high` where the bounds are exchanged.
Expression mod(Expression a, Expression b);
Expression min(Expression a, Expression b);
Expression max(Expression a, Expression b);
Expression min(Expression a, double b);
Expression max(Expression a, double b);
Expression clamp(Expression a, Expression low, Expression high);
/// negative where `a` < 0, otherwise.
Expression select(Expression a, Expression negative, Expression otherwise);
Expression select(Expression a, Expression negative, Expression zero, Expression positive);
/// 1 where a < b, else 0.
Expression lessThan(Expression a, Expression b);
/// Noise at (x, y, z) of a generator whose number may be any expression (docs/povray/noise.md, section 6).
Expression noise(Expression generator, Expression x, Expression y, Expression z);

}  // namespace isoscope

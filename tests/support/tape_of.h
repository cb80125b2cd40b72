// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/evaluate/tape/tape.h"
#include "core/function/graph_builder.h"

namespace isoscope::test {

/// The tape of make(x, y, z), which returns an Expression.
template <class Make>
std::shared_ptr<const Tape> tapeOf(Make make) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = Expression(make(x, y, z)).node();
    return Tape::compile(finish(std::move(graph), {root}, 3));
}

}  // namespace isoscope::test

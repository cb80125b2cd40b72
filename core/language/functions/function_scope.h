// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/function/graph_builder.h"
#include "core/function/written_work.h"

namespace isoscope {

/// The names that a function body sees, and the graph that it grows: the parameters, x, y, z and their other
/// spellings u and v, and the variables of the `sum` and `prod` around the place at hand
/// (docs/povray/operators.md, sections 1 and 4). The body of each sum or prod is a graph of its own; what it
/// uses from outside is handed in as a captured value.
class FunctionScope {
  public:
    /// Empty names mean x, y, z.
    explicit FunctionScope(std::vector<std::string> parameterNames);

    /// x, y, z where none were given.
    const std::vector<std::string>& parameterNames() const { return parameterNames_; }

    /// The graph of the innermost sum or prod, else of the function itself.
    FunctionGraph& graph() { return frames_.back()->graph; }
    Expression expression(NodeId node) { return {graph(), node}; }
    Expression constant(double value) { return {graph(), graph().constant(value)}; }

    /// The value of a name in graph(), or nothing when it is neither parameter nor variable. x, y, z, u and v
    /// always have one: 0 where they are no parameters.
    std::optional<NodeId> find(std::string_view name);
    /// Every name that find() knows, for "did you mean".
    std::vector<std::string> names() const;

    /// Begins the body of a `sum` or `prod`: until endLoop(), graph() and find() work inside it.
    void beginLoop(std::string variable);
    /// The body of a loop as a function: argument 0 is the loop's variable, the captured values follow.
    struct LoopBody {
        Function body;
        std::vector<NodeId> captured;  ///< values in the graph around the loop
    };
    /// Ends the innermost loop with `result`, a node of its graph; graph() is the one around it again.
    LoopBody endLoop(NodeId result);

    /// What has been read so far; the body of a loop is counted once.
    WrittenWork& written() { return written_; }
    /// Whether any graph of the function has reached FunctionGraph::nodeLimit.
    bool overflowed() const;
    /// Operations so far, bodies of loops included.
    std::size_t nodeCount() const { return loopNodes_ + frames_.front()->graph.size(); }
    /// The function, with `results` as nodes of its outermost graph; to be called once, outside all loops.
    Function finish(std::vector<NodeId> results);

  private:
    struct Frame {
        FunctionGraph graph;
        std::string variable;
        std::vector<NodeId> captured;
        std::unordered_map<NodeId, NodeId> captureOf;
    };

    /// Carries a value of frame `from` inward to graph().
    NodeId carryInward(std::size_t from, NodeId node);
    std::optional<int> positionOf(std::string_view name) const;

    std::vector<std::string> parameterNames_;
    std::vector<std::unique_ptr<Frame>> frames_;
    WrittenWork written_;
    std::size_t loopNodes_ = 0;
    bool loopOverflowed_ = false;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <span>
#include <string>
#include <vector>

#include "core/function/operation.h"
#include "core/function/point_table.h"

namespace isoscope {

using NodeId = std::uint32_t;
constexpr NodeId noNode = 0xffffffffu;

/// One operation of a function graph. Operands always have smaller numbers than the node itself, so going
/// through the nodes in order visits operands first.
struct Node {
    Operation operation = Operation::constant;
    std::uint32_t index = 0;  ///< variable, parameter slot, crackle settings or loop body
    double value = 0;         ///< of a constant
    std::array<NodeId, 4> operands{noNode, noNode, noNode, noNode};

    friend bool operator==(const Node& a, const Node& b);
};

/// Settings of the `crackle` pattern (docs/povray/patterns.md, section 3), and of what is looked up like it:
/// of the latter no evaluator knows more than values and bounds.
struct CrackleSettings {
    std::array<double, 3> form{-1, 1, 0};
    double metric = 2;
    double offset = 0;
    bool solid = false;
    int noiseGenerator = 2;  ///< used by `solid` only
    bool cells = false;      ///< the pattern `cells` instead: the first random number of the unit cell itself
    /// In place of all the above: what the table says at the point.
    std::shared_ptr<const PointTable> table;

    friend bool operator==(const CrackleSettings&, const CrackleSettings&) = default;
};

struct Function;

/// A hash-consed graph of operations over the arguments of a function and the parameters of a scene: equal
/// nodes exist once. Building folds constants (with POV-Ray's run-time semantics, so that folding never
/// changes a value), turns `a*a` into a square and a division by a power of 2 into a product (by 1: into
/// nothing); it applies no identity that is not exact in IEEE
/// arithmetic.
///
/// A graph holds at most `nodeLimit` nodes. When a build would exceed it, `overflowed()` becomes true and
/// every further node is the constant NaN: a text that nests calls exponentially ends in a diagnostic, not
/// in the machine's memory.
class FunctionGraph {
  public:
    static constexpr std::size_t nodeLimit = 400'000;

    /// Leaves. All NaNs are one constant. `index` is the argument's number (beyond the function's arguments
    /// it reads 0), `slot` the place in the scene's table of parameters; neither may be negative.
    NodeId constant(double value);
    NodeId variable(int index);
    NodeId parameter(int slot);
    /// Operations of one and two operands, folded for constants. The operation must have this arity().
    NodeId unary(Operation operation, NodeId a);
    NodeId binary(Operation operation, NodeId a, NodeId b);
    /// select3, crackle (with settings through crackleNode) and noise gradients.
    NodeId ternary(Operation operation, NodeId a, NodeId b, NodeId c);
    /// select4 and noise.
    NodeId quaternary(Operation operation, NodeId a, NodeId b, NodeId c, NodeId d);
    /// The pattern `crackle`, or what CrackleSettings put in its place, at (x, y, z); equal settings are kept
    /// once.
    NodeId crackle(const CrackleSettings& settings, NodeId x, NodeId y, NodeId z);
    /// sum or product of `body` (one result; variable 0 is the loop variable) for i = first, first + 1, ...
    /// <= last. Constant bounds with at most `unrollLimit` steps are unrolled.
    NodeId loop(Operation operation, NodeId first, NodeId last, const Function& body,
                std::span<const NodeId> captured);
    static constexpr int unrollLimit = 64;

    /// Copies result number `result` of `callee` into this graph with `arguments` for its variables.
    NodeId inlineCall(const Function& callee, std::span<const NodeId> arguments, std::size_t result = 0);

    const Node& operator[](NodeId id) const { return nodes_[id]; }
    /// Nodes so far, those that no result needs included. Every NodeId below it is valid.
    std::size_t size() const { return nodes_.size(); }
    /// Whether value() may be asked: constants only, not nodes that depend on parameters alone.
    bool isConstant(NodeId id) const { return nodes_[id].operation == Operation::constant; }
    /// The value of a constant node.
    double value(NodeId id) const { return nodes_[id].value; }
    /// What Node::index of a crackle or of a loop stands for.
    const CrackleSettings& crackleSettings(std::uint32_t index) const { return crackles_[index]; }
    const Function& loopBody(std::uint32_t index) const { return *loops_[index].body; }
    /// What a loop hands to its body as variables 1, 2, ...; nothing for other nodes of this graph.
    std::span<const NodeId> captured(const Node& node) const {
        const bool isLoop = node.operation == Operation::sum || node.operation == Operation::product;
        return isLoop ? std::span<const NodeId>(loops_[node.index].captured) : std::span<const NodeId>();
    }
    /// Whether nodes were left out for nodeLimit: the graph is of no use then but for a diagnostic.
    bool overflowed() const { return overflowed_; }

    /// The operands of a node, captured values of loops included.
    std::vector<NodeId> operandsOf(NodeId id) const;

  private:
    struct Loop {
        std::shared_ptr<const Function> body;
        std::vector<NodeId> captured;
    };

    NodeId intern(const Node& node);
    std::size_t placeOf(const Node& node) const;
    void makePlaces();

    std::vector<Node> nodes_;
    /// Where each node is found: open addressing, from a node's hash onwards. At most half of the places, a
    /// power of 2, are taken.
    std::vector<NodeId> places_;
    std::vector<CrackleSettings> crackles_;
    std::vector<Loop> loops_;
    bool overflowed_ = false;
};

/// A function of `argumentCount` numbers with one result (a field), three (a vector) or five (a colour).
/// Immutable once built and shared freely between threads.
struct Function {
    std::shared_ptr<const FunctionGraph> graph;
    std::vector<NodeId> results;
    int argumentCount = 3;

    /// Whether there is a function at all: a default one has no graph and must not be evaluated.
    bool valid() const { return graph != nullptr && !results.empty(); }
};

/// A function whose graph may still grow; `finish` freezes it.
Function finish(FunctionGraph&& graph, std::vector<NodeId> results, int argumentCount);

}  // namespace isoscope

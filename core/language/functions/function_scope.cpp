// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/functions/function_scope.h"

#include <algorithm>

namespace isoscope {

namespace {

/// u is another spelling of x, and v of y.
std::string_view canonical(std::string_view name) {
    if (name == "u") return "x";
    if (name == "v") return "y";
    return name;
}

bool isCoordinate(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

}  // namespace

FunctionScope::FunctionScope(std::vector<std::string> parameterNames)
    : parameterNames_(std::move(parameterNames)) {
    if (parameterNames_.empty()) parameterNames_ = {"x", "y", "z"};
    frames_.push_back(std::make_unique<Frame>());
}

std::optional<int> FunctionScope::positionOf(std::string_view name) const {
    // A name listed twice denotes its first position; of x and u, or y and v, the later one wins.
    std::optional<int> position;
    for (std::size_t k = 0; k < parameterNames_.size(); ++k) {
        if (canonical(parameterNames_[k]) != name) continue;
        const bool otherSpelling =
            position && parameterNames_[static_cast<std::size_t>(*position)] != parameterNames_[k];
        if (!position || otherSpelling) position = static_cast<int>(k);
    }
    return position;
}

std::optional<NodeId> FunctionScope::find(std::string_view name) {
    const std::string_view wanted = canonical(name);
    const bool coordinate = isCoordinate(wanted);
    if (!coordinate)
        for (std::size_t k = frames_.size(); k-- > 1;)
            if (frames_[k]->variable == wanted) return carryInward(k, frames_[k]->graph.variable(0));
    if (const std::optional<int> position = positionOf(wanted))
        return carryInward(0, frames_.front()->graph.variable(*position));
    if (coordinate) return graph().constant(0);
    return std::nullopt;
}

std::vector<std::string> FunctionScope::names() const {
    std::vector<std::string> names = parameterNames_;
    for (const auto& frame : frames_)
        if (!frame->variable.empty()) names.push_back(frame->variable);
    return names;
}

NodeId FunctionScope::carryInward(std::size_t from, NodeId node) {
    for (std::size_t k = from + 1; k < frames_.size(); ++k) {
        Frame& frame = *frames_[k];
        const auto [known, isNew] = frame.captureOf.try_emplace(node, noNode);
        if (isNew) {
            frame.captured.push_back(node);
            known->second = frame.graph.variable(static_cast<int>(frame.captured.size()));
        }
        node = known->second;
    }
    return node;
}

void FunctionScope::beginLoop(std::string variable) {
    frames_.push_back(std::make_unique<Frame>());
    frames_.back()->variable = std::move(variable);
}

FunctionScope::LoopBody FunctionScope::endLoop(NodeId result) {
    const std::unique_ptr<Frame> frame = std::move(frames_.back());
    frames_.pop_back();
    loopNodes_ += frame->graph.size();
    loopOverflowed_ |= frame->graph.overflowed();
    const int argumentCount = static_cast<int>(frame->captured.size()) + 1;
    return {isoscope::finish(std::move(frame->graph), {result}, argumentCount), std::move(frame->captured)};
}

bool FunctionScope::overflowed() const {
    return loopOverflowed_ || std::any_of(frames_.begin(), frames_.end(),
                                          [](const auto& frame) { return frame->graph.overflowed(); });
}

Function FunctionScope::finish(std::vector<NodeId> results) {
    return isoscope::finish(std::move(frames_.front()->graph), std::move(results),
                            static_cast<int>(parameterNames_.size()));
}

}  // namespace isoscope

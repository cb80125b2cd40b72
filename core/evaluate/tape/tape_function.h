// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "core/evaluate/tape/tape.h"

namespace isoscope {

/// What stands for parts of a tape in the function that is made of it.
struct TapeStandIns {
    /// For a coordinate; noNode where nothing is asked for that depends on it otherwise than through what is
    /// replaced.
    std::function<NodeId(FunctionGraph& graph, std::size_t axis)> coordinate;
    /// For an instruction; noNode: it stays what it is.
    std::function<NodeId(FunctionGraph& graph, std::size_t instruction)> instruction;
};

/// The value of an instruction, or without one result 0, of a tape without loops, as a function of three
/// arguments. Uniform slots become constants. Arguments behind the third are 0.
Function functionOf(const Tape& tape, std::span<const double> uniforms, const TapeStandIns& standIns,
                    std::optional<std::size_t> instruction = {});

}  // namespace isoscope

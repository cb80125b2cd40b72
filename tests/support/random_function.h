// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <span>
#include <string>
#include <vector>

#include "core/function/function_graph.h"

namespace isoscope::test {

/// Numbers where operations change their behaviour: zeros, ones, limits of 32-bit integers, of whole numbers
/// and of doubles, infinities, NaN, and the borders of the vector functions' fast ranges.
const std::vector<double>& specialNumbers();

/// A number for testing: special, or random with a magnitude between 1e-3 and 1e3, or (rarely) anything
/// finite.
double anyNumber(std::mt19937_64& random);

/// Operations whose result every evaluator must give to the last bit.
std::span<const Operation> exactOperations();

/// Operations that SlopeAlgebra and TaylorAlgebra have rules for, noise aside.
std::vector<Operation> operationsWithSlopes();

/// What randomFunction may use.
struct RandomFunctionSettings {
    int nodes = 20;
    int parameters = 3;
    bool loops = true;
    std::vector<Operation> operations;  ///< empty: exactOperations()
};

/// A function of x, y, z with random operations over variables, parameters and constants.
Function randomFunction(std::mt19937_64& random, const RandomFunctionSettings& settings);

/// Adds one operation with random operands out of `pool` and returns it.
NodeId addOperation(FunctionGraph& graph, Operation operation, std::span<const NodeId> operands,
                    std::mt19937_64& random);

/// The nodes up to the first result, one a line.
std::string describe(const Function& function);

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/evaluate/reference_evaluator.h"
#include "core/roots/field_function.h"

namespace isoscope {

/// A function evaluated point by point with the reference evaluator: slow, for tests and comparisons.
class FunctionField : public FieldFunction {
  public:
    /// `function` must be valid() and have three arguments.
    FunctionField(Function function, std::span<const double> parameters)
        : evaluator_(std::move(function)), parameters_(parameters.begin(), parameters.end()) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = evaluator_.evaluate(std::array{x[i], y[i], z[i]}, parameters_);
    }

  private:
    ReferenceEvaluator evaluator_;
    std::vector<double> parameters_;
};

}  // namespace isoscope

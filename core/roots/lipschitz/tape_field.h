// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/evaluate/point_evaluator.h"
#include "core/roots/lipschitz/field_function.h"

namespace isoscope {

/// A tape evaluated with vector instructions: what pictures are made with. The tape has three arguments.
class TapeField : public FieldFunction {
  public:
    explicit TapeField(std::shared_ptr<const PreparedFunction> function) : evaluator_(std::move(function)) {}
    /// The function is prepared for this field alone.
    TapeField(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
        : evaluator_(std::move(tape), parameters) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        evaluator_.evaluate(x, y, z, out);
    }

  private:
    PointEvaluator evaluator_;
};

}  // namespace isoscope

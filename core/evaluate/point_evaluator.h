// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/evaluate/steps/tape_programs.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

class PreparedFunction;

/// Evaluates a tape for many points at once with the widest vector instructions of the machine. Agrees with
/// ReferenceEvaluator to 1e-12 (relative to max(1, |value|)); elementary operations agree exactly. The
/// answer for a point does not depend on the other points of the batch. Keeps scratch memory: one object per
/// thread.
class PointEvaluator {
  public:
    explicit PointEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// The function is prepared for this evaluator alone.
    PointEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// Result number `result` at (x[i], y[i], z[i]); all spans have the same length.
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  std::span<double> out, std::size_t result = 0);

    /// The same by a shortened tape, where its choices hold.
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  std::span<double> out, const SimplifiedTape& simplifiedTape);

    /// The same for functions of any number of arguments: arguments[k] points to argument k of all `count`
    /// points. Missing arguments count as 0.
    void evaluate(std::span<const double* const> arguments, std::size_t count, std::span<double> out,
                  std::size_t result = 0);

    /// All results at once: out[r][i] is result r at point i.
    void evaluateAll(std::span<const double* const> arguments, std::size_t count,
                     std::span<double* const> out);

    /// One point.
    double evaluate(double x, double y, double z);

    /// Point evaluations so far.
    std::uint64_t evaluations() const { return evaluations_; }

    /// What is evaluated; it lives as long as the evaluator.
    const Tape& tape() const { return *tape_; }

  private:
    void run(std::span<const double* const> arguments, std::size_t first, std::size_t result,
             std::span<double> out);
    void placeArguments(std::span<const double* const> arguments, std::size_t first, std::size_t lanes);
    void writeResult(std::size_t result, std::span<double> out) const;
    void writeSlot(Slot slot, std::span<double> out) const;

    const Tape* tape_;
    TapeWorkspace workspace_;
    TapePrograms programs_;
    std::uint64_t evaluations_ = 0;
};

}  // namespace isoscope

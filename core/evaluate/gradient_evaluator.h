// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/evaluate/steps/tape_programs.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/evaluate/tape/tape_workspace.h"

namespace isoscope {

class PreparedFunction;

/// A value and its partial derivatives in x, y and z.
struct ValueAndGradient {
    double value = 0;
    std::array<double, 3> gradient{};
};

/// Values and derivatives side by side: arrays of batchLanes entries.
struct GradientLanes {
    const double* value;
    std::array<const double*, 3> gradient;
};

/// Evaluates a tape and its derivatives in the first three arguments (forward mode, exact up to rounding), 64
/// points at a time. Values are those of PointEvaluator, bit for bit. Keeps scratch memory: one object per
/// thread.
///
/// The derivatives are never NaN and never infinite. At places without a derivative they are:
/// - abs(a) at 0: that of a; min and max at ties, select: that of the operand whose value is taken;
/// - infinite slopes (sqrt and ln at 0, asin and acos at +-1, acosh at 1, pow at 0, x/0): a slope of
/// `steepest` with
///   the right sign, so that the direction of the gradient is kept;
/// - an operand that does not move contributes 0, even to an infinite slope: sqrt(x*x + y*y) has the gradient
/// 0 at the
///   origin;
/// - jumps (floor, ceil, int, div, comparisons): 0; mod: as between its jumps;
/// - undefined values: 0 where the slope is undefined too;
/// - pow(a, b) with a <= 0 ignores the change of the exponent;
/// - crackle and noise: exact, 0 where they are clipped; what is looked up, cells and solid crackle: a
///   central difference over `crackleStep`.
class GradientEvaluator {
  public:
    static constexpr double steepest = 1e100;
    static constexpr double crackleStep = 1e-5;

    explicit GradientEvaluator(std::shared_ptr<const PreparedFunction> function);
    /// The function is prepared for this evaluator alone.
    GradientEvaluator(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// Value and gradient of result `result` at (x[i], y[i], z[i]); all spans have the same length.
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  std::span<ValueAndGradient> out, std::size_t result = 0);
    /// With a shortened tape, whose choices must be right at the points.
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  std::span<ValueAndGradient> out, const SimplifiedTape& simplifiedTape);

    /// The same for up to batchLanes points, without a copy: valid until the next evaluation. Derivatives
    /// that overflow may be infinite or NaN here.
    GradientLanes evaluateLanes(const std::array<const double*, 3>& point, std::size_t count);

    /// Where evaluateLanes() keeps the coordinates: points that lie there, in batchLanes entries, are not
    /// copied. Null for an argument that the function does not have.
    std::array<double*, 3> pointLanes();
    /// evaluateLanes() with a shortened tape, whose choices must be right at the points.
    GradientLanes evaluateLanes(const std::array<const double*, 3>& point, std::size_t count,
                                const SimplifiedTape& simplifiedTape);

    /// One point.
    ValueAndGradient evaluate(double x, double y, double z);

  private:
    void run(const std::array<const double*, 3>& point, std::size_t lanes,
             const SimplifiedTape* simplifiedTape);
    void evaluate(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  std::span<ValueAndGradient> out, const SimplifiedTape* simplifiedTape, Slot result);
    GradientLanes lanesOf(Slot slot);
    void writeResult(Slot slot, std::span<ValueAndGradient> out) const;

    TapeWorkspace workspace_;
    TapePrograms programs_;
    std::array<std::array<double, batchLanes>, 2> uniform_{};  ///< value and derivative of a constant
};

/// |grad f| of what a GradientEvaluator found: infinite where f is infinitely steep, NaN where it is
/// undefined.
double slopeOf(const ValueAndGradient& at);

}  // namespace isoscope

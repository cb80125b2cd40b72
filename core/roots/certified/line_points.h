// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/evaluate/point_evaluator.h"
#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// The signed function at one place on each of many lines, negative inside.
class LinePoints {
  public:
    /// By `simplifiedTape`, if there is one, which has to hold at the places.
    LinePoints(PointEvaluator& evaluator, const RootSettings& settings,
               const SimplifiedTape* simplifiedTape = nullptr)
        : evaluator_(evaluator), settings_(settings), simplifiedTape_(simplifiedTape) {}

    /// take(k, value) for k from 0 to count - 1, at parameterOf(k) on lineOf(k).
    template <class LineOf, class ParameterOf, class Take>
    void evaluate(std::size_t count, LineOf lineOf, ParameterOf parameterOf, Take take) {
        std::array<double, batchLanes> x, y, z, values;
        for (std::size_t first = 0; first < count; first += batchLanes) {
            const std::size_t lanes = std::min(batchLanes, count - first);
            for (std::size_t i = 0; i < lanes; ++i) {
                const LineQuery& query = lineOf(first + i);
                const glm::dvec3 p = query.origin + parameterOf(first + i) * query.direction;
                x[i] = p.x, y[i] = p.y, z[i] = p.z;
            }
            const auto column = [lanes](std::array<double, batchLanes>& a) {
                return std::span(a).first(lanes);
            };
            if (simplifiedTape_ != nullptr)
                evaluator_.evaluate(column(x), column(y), column(z), column(values), *simplifiedTape_);
            else
                evaluator_.evaluate(column(x), column(y), column(z), column(values));
            for (std::size_t i = 0; i < lanes; ++i) take(first + i, settings_.signedValue(values[i]));
        }
    }

  private:
    PointEvaluator& evaluator_;
    const RootSettings& settings_;
    const SimplifiedTape* simplifiedTape_;
};

}  // namespace isoscope

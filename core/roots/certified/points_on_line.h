// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/point_evaluator.h"
#include "core/roots/certified/general_search.h"
#include "core/roots/root_settings.h"

namespace isoscope {

/// The signed function along one line, one point at a time; NaN where it has no value.
class PointsOnLine : public LineFunction {
  public:
    PointsOnLine(PointEvaluator& evaluator, const RootSettings& settings, const LineQuery& query)
        : evaluator_(evaluator), settings_(settings), query_(query) {}

    double value(double t) override {
        const glm::dvec3 p = query_.origin + t * query_.direction;
        return settings_.signedValue(evaluator_.evaluate(p.x, p.y, p.z));
    }

  private:
    PointEvaluator& evaluator_;
    const RootSettings& settings_;
    const LineQuery& query_;
};

}  // namespace isoscope

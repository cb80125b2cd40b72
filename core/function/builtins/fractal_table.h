// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/patterns/pattern.h"
#include "core/function/point_table.h"

namespace isoscope {

/// A fractal pattern with more iterations than a graph can hold: they are done one by one, as long as the
/// orbit goes on.
class FractalTable : public PointTable {
  public:
    explicit FractalTable(const Pattern& pattern) : pattern_(pattern) {}

    double value(const std::array<double, 3>& point) const override;
    double low() const override;
    double high() const override;

  private:
    double valueOf(double x, double y) const;

    Pattern pattern_;
};

}  // namespace isoscope

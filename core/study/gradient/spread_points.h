// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

/// Points in columns, as evaluators take them.
struct SpreadPoints {
    std::vector<double> x, y, z;

    /// One more.
    void add(const glm::dvec3& p) { x.push_back(p.x), y.push_back(p.y), z.push_back(p.z); }
};

/// `count` points spread evenly over the domain's box, the same each time; of those of a ball only those in
/// it.
SpreadPoints spreadPoints(const GradientDomain& domain, std::size_t count);

}  // namespace isoscope

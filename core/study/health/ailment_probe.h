// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/evaluate/gradient_evaluator.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/health/function_health.h"

namespace isoscope {

/// Looks by evaluations whether a function has an ailment in a box. What it meets is there; what it does not
/// meet may be there all the same. Not for several threads at once.
class AilmentProbe {
  public:
    /// The domain must outlive it: places outside of it do not count.
    AilmentProbe(const std::shared_ptr<const PreparedFunction>& function, const GradientDomain& domain)
        : domain_(domain), gradients_(function) {}

    /// Where it was met.
    struct Met {
        glm::dvec3 place{0};
        double size = 0;  ///< of a jump
    };
    /// The place, if there is one among some dozen points of the box and what lies between them.
    std::optional<Met> look(Ailment ailment, const GradientBox& box);

  private:
    struct Sample {
        glm::dvec3 place{0};
        double value = 0;
        glm::dvec3 slope{0};
    };

    Sample at(const glm::dvec3& place);
    std::optional<Met> step(Ailment ailment, Sample a, Sample b);
    std::optional<Met> climb(Sample best, double width);

    const GradientDomain& domain_;
    GradientEvaluator gradients_;
};

}  // namespace isoscope

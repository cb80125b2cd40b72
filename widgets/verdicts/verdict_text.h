// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/study/gradient/surface_verdict.h"

namespace isoscope {

/// What a verdict is called and what it means, in words: first a sentence for everybody, then one with the
/// terms and numbers.
class VerdictText {
    Q_DECLARE_TR_FUNCTIONS(VerdictText)
  public:
    /// Two or three words: "no holes", "holes", "may have holes", ...
    static QString word(const SurfaceVerdict& verdict);
    static QString plain(const SurfaceVerdict& verdict);
    static QString exact(const SurfaceVerdict& verdict);

    /// A gradient or slope, everywhere with the same digits.
    static QString number(double gradient);
    /// "<0.25, 0, 1>" in the coordinates of the function.
    static QString place(const glm::dvec3& place);
    /// "a pole", "a jump", ...
    static QString hazard(GradientHazard hazard);
};

}  // namespace isoscope

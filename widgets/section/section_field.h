// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <QString>
#include <vector>

#include "core/shapes/isosurface/isosurface.h"
#include "widgets/section/section_plane.h"

namespace isoscope {

/// What the colours of a section mean.
enum class SectionQuantity { value, gradient, distance };

/// f - threshold on a plane, row by row from the bottom left. Samples sit on the edges of the rectangle as
/// well.
struct SectionField {
    SectionPlane plane;
    int columns = 0;
    int rows = 0;
    double left = -1, right = 1, bottom = -1, top = 1;
    std::vector<float> values;     ///< NaN where f is undefined, infinite where f is
    std::vector<float> slopes;     ///< |grad f| at the same places, infinite ones too; empty for the value
    std::vector<float> distances;  ///< surfaceDistance() at the same places; empty unless asked for
    SectionQuantity quantity = SectionQuantity::value;  ///< what is shown as colours
    double maxGradient = 1;                             ///< the setting in force
    double steepest = 0;                                ///< largest finite slope in the container
    std::vector<std::uint8_t> contained;                ///< 1 inside the container
    Container container;
    double extent = 1;  ///< nine tenths of the finite values lie within +-extent; a round number above 0
    double distanceExtent = 1;  ///< the same of the distances
    bool undefined = false;     ///< NaN occurs inside the container
    double milliseconds = 0;

    /// Whether nothing was sampled.
    bool empty() const { return values.empty(); }
    /// Those of the quantity.
    const std::vector<float>& heights() const {
        return quantity == SectionQuantity::value      ? values
               : quantity == SectionQuantity::gradient ? slopes
                                                       : distances;
    }
};

/// x, y, z, f - threshold and, where there are any, slopes and distances of all samples in the container, as
/// comma separated values with a header.
QString sectionTable(const SectionField& field);

/// What to call a plane's own coordinates.
struct SectionAxisNames {
    QString horizontal, vertical;
};
/// Of a plane across an axis, the function's coordinates that it shows; u and v for a free plane.
SectionAxisNames axisNames(const SectionPlane& plane);

/// The smallest of 1, 2, 5 times a power of ten that is not below `value`; 1 for values that are not positive
/// or not finite.
double roundedUp(double value);

}  // namespace isoscope

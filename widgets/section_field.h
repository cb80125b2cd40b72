// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/shapes/isosurface.h"

namespace isoscope {

/// The coordinate drawn to the right and the one drawn upwards for a plane across `axis`.
struct SectionAxes {
    int horizontal;
    int vertical;
};
SectionAxes sectionAxes(int axis);

/// What the colours of a section mean.
enum class SectionQuantity { value, gradient };

/// f - threshold on a plane, row by row from the bottom left. Samples sit on the edges of the rectangle as
/// well.
struct SectionField {
    int axis = 2;
    double position = 0;
    int columns = 0;
    int rows = 0;
    double left = -1, right = 1, bottom = -1, top = 1;
    std::vector<float> values;  ///< NaN where f is undefined, infinite where f is
    std::vector<float> slopes;  ///< |grad f| at the same places, infinite ones too; empty unless asked for
    double maxGradient = 1;     ///< the setting in force
    double steepest = 0;        ///< largest finite slope in the container
    std::vector<std::uint8_t> contained;  ///< 1 inside the container
    Container container;
    double extent = 1;       ///< nine tenths of the finite values lie within +-extent; a round number above 0
    bool undefined = false;  ///< NaN occurs inside the container
    double milliseconds = 0;

    bool empty() const { return values.empty(); }
    SectionQuantity quantity() const {
        return slopes.empty() ? SectionQuantity::value : SectionQuantity::gradient;
    }
};

/// Corners of the container in the coordinates of the function.
Bounds containerBounds(const Container& container);

/// The smallest of 1, 2, 5 times a power of ten that is not below `value`; 1 for values that are not positive
/// or not finite.
double roundedUp(double value);

}  // namespace isoscope

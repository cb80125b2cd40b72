// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope {

/// What the slider of a parameter is called where a text speaks of it, in presets and timelines.
struct SliderName {
    /// Which call or statement of its group, from 0 in the order of the text. Declarations are in one until a
    /// name comes again.
    int call = 0;
    int again = 0;     ///< how many of this name stand before it in that call
    std::string name;  ///< "R", "f_torus Minor Radius", "f_torus (2) Minor Radius"; unique
};

/// The names of all parameters, in their order.
std::vector<SliderName> sliderNames(const std::vector<SceneParameter>& parameters);

/// Whether a preset or a timeline can set the number: the text says it, as a number.
inline bool isNamedNumber(const SceneParameter& parameter) {
    return !parameter.expression && !parameter.implied;
}

}  // namespace isoscope

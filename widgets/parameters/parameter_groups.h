// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope {

/// Where a parameter stands in the panel.
struct ParameterPlace {
    QString group;  ///< "f_torus", "#declare", ...
    /// Which call or statement of that name, from 0 in the order of the text. Declarations are in one until
    /// a name comes again.
    int call = 0;
    QString key;  ///< the same for the same row of the next parse; unique
    /// What presets call the row: "R", "f_torus Minor Radius", "f_torus (2) Minor Radius"; unique.
    QString presetName;
};

/// Sorts parameters to their calls and statements.
std::vector<ParameterPlace> parameterPlaces(const std::vector<SceneParameter>& parameters);

}  // namespace isoscope

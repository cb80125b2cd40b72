// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace isoscope::test {

/// A sphere on a floor, described once for both programs: as a Scene for ours, as text for POV-Ray.
struct LightingCase {
    std::string name;
    Finish finish;
    Color pigment{0.8, 0.5, 0.2};
    std::vector<LightSource> lights;
    double assumedGamma = 1;
    Color ambientLight{1, 1, 1};
    bool box = false;  ///< a box beside the sphere, to throw shadows
    bool boxCasts = true;
};

std::string povrayText(const LightingCase& item);
std::shared_ptr<const Scene> sceneOf(const LightingCase& item);

}  // namespace isoscope::test

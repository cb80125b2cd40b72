// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/scene/color.h"
#include "core/scene/pigment.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// How a surface answers light, with POV-Ray 3.7's defaults. Colours are factors per channel.
struct Finish {
    Color ambient{0.1, 0.1, 0.1};
    Color emission{};
    double diffuse = 0.6;
    double diffuseBack = 0;
    double brilliance = 1;
    double phong = 0;
    double phongSize = 40;
    double specular = 0;
    double roughness = 0.05;
    double metallic = 0;
    double crand = 0;
    Color reflectionMinimum{};
    Color reflectionMaximum{};
    bool conserveEnergy = false;
    /// Keywords of the scene that have no effect here ("irid"), for the list of what was left out.
    std::vector<std::string> notSimulated;
};

/// One texture: what a shape looks like where a ray meets it.
struct Material {
    Pigment pigment = SolidPigment{};
    /// What has moved the pigment since it was written, from its own coordinates to the object's, or to the
    /// world's in Scene::materials.
    Transform pigmentTransform;
    Finish finish;
    std::vector<std::string> notSimulated;  ///< as in Finish: "normal", "texture_map"
};

/// The material of an object that has been moved.
Material moved(Material material, const Transform& transform);

}  // namespace isoscope

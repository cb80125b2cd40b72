// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/reflectance.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "core/render/light/surface_light.h"

namespace isoscope {

namespace {

/// How far a metal's mirror is white, as for its highlights (surface_light.cpp).
double whiteness(double cosine) {
    const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2) - 1.12;
    return std::clamp(0.014567225 / (x * x) - 0.011612903, 0.0, 1.0);
}

}  // namespace

double fresnel(double ratio, double cosine) {
    const double c = std::clamp(cosine, 0.0, 1.0);
    const double square = ratio * ratio - 1 + c * c;
    if (!(square > 0)) return 1;
    const double g = std::sqrt(square);
    const double one = (g - c) / (g + c);
    const double other = (c * (g + c) - 1) / (c * (g - c) + 1);
    return std::clamp(0.5 * one * one * (1 + other * other), 0.0, 1.0);
}

glm::dvec3 reflectance(const Finish& finish, const glm::dvec3& pigment, double cosine, double ratio) {
    const glm::dvec3 low = rgb(finish.reflectionMinimum), high = rgb(finish.reflectionMaximum);
    glm::dvec3 result = high;
    if (low != high) {
        const double slant = std::clamp(1 - cosine, 0.0, 1.0);
        const double amount =
            finish.reflectionFresnel ? fresnel(ratio, cosine) : std::pow(slant, finish.reflectionFalloff);
        result = low + (high - low) * amount;
    }
    if (finish.reflectionMetallic == 0) return result;
    const double tint = finish.reflectionMetallic * (1 - whiteness(cosine));
    return result * (glm::dvec3(1) + (pigment - glm::dvec3(1)) * tint);
}

glm::dvec3 filmShare(const Finish& finish, double thickness, double cosines, const glm::dvec3& wavelengths) {
    return glm::dvec3(1) + finish.irid * glm::cos(2 * std::numbers::pi * thickness * cosines / wavelengths);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/surface_light.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace isoscope {

namespace {

glm::dvec3 pigmentColor(const Pigment& pigment) { return rgb(std::get<SolidPigment>(pigment).color); }

/// The colour of a highlight: the light's own, or tinted by the pigment for metals, less so towards grazing
/// light. Fresnel term of Cook and Torrance's metals in the closed form that POV-Ray's pictures show.
glm::dvec3 highlightTint(double metallic, double cosine, const glm::dvec3& pigment) {
    if (metallic == 0) return glm::dvec3(1);
    const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2);
    const double fresnel = std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
    return glm::dvec3(1) + metallic * (1 - fresnel) * (pigment - glm::dvec3(1));
}

double phong(const Finish& finish, const glm::dvec3& normal, const glm::dvec3& view,
             const glm::dvec3& light) {
    if (finish.phong <= 0) return 0;
    const glm::dvec3 mirrored = view - 2 * glm::dot(view, normal) * normal;
    const double cosine = glm::dot(mirrored, light);
    return cosine > 0 ? finish.phong * std::pow(cosine, finish.phongSize) : 0;
}

double specular(const Finish& finish, const glm::dvec3& normal, const glm::dvec3& view,
                const glm::dvec3& light) {
    if (finish.specular <= 0 || !(finish.roughness > 0)) return 0;
    const glm::dvec3 halfway = light - view;
    const double length = glm::length(halfway);
    if (!(length > 0)) return 0;
    const double cosine = glm::dot(halfway, normal) / length;
    return cosine > 0 ? finish.specular * std::pow(cosine, 1 / finish.roughness) : 0;
}

/// Brilliance 1 is what nearly all finishes have.
double brilliant(double cosine, double brilliance) {
    return brilliance == 1 ? cosine : std::pow(cosine, brilliance);
}

}  // namespace

glm::dvec3 selfLight(const Material& material, const glm::dvec3& ambientLight) {
    const Finish& finish = material.finish;
    return pigmentColor(material.pigment) * (rgb(finish.ambient) * ambientLight + rgb(finish.emission));
}

glm::dvec3 returnedLight(const Material& material, const glm::dvec3& normal, const glm::dvec3& view,
                         const LightArrival& arrival) {
    const Finish& finish = material.finish;
    const glm::dvec3 facing = glm::dot(normal, view) > 0 ? -normal : normal;
    const double cosine = glm::dot(facing, arrival.direction);
    const glm::dvec3 pigment = pigmentColor(material.pigment);
    if (!(cosine > 0)) {
        if (finish.diffuseBack <= 0 || !(cosine < 0)) return glm::dvec3(0);
        return arrival.color * pigment * (finish.diffuseBack * brilliant(-cosine, finish.brilliance));
    }
    glm::dvec3 result = pigment * (finish.diffuse * brilliant(cosine, finish.brilliance));
    if (!arrival.highlights) return arrival.color * result;
    const double highlight =
        phong(finish, facing, view, arrival.direction) + specular(finish, facing, view, arrival.direction);
    if (highlight > 0) result += highlight * highlightTint(finish.metallic, cosine, pigment);
    return arrival.color * result;
}

}  // namespace isoscope

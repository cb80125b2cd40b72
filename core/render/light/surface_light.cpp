// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/surface_light.h"

#include "core/render/light/transmission.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/light/surface_light.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/render/light/lighting.h"
#include "core/render/light/surface_light-inl.h"
#include "core/shapes/patches/vector_triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

template <bool patterned>
void findRange(const Lighting& lighting, const PointRange& range, SurfacePoints& points) {
    const Triple light = constant(lighting.light);
    Triple pigment = constant(lighting.pigment), tint = constant(lighting.tint);
    for (std::size_t k = range.first; k < range.end; k += hn::Lanes(Doubles())) {
        if constexpr (patterned) {
            pigment = load(points.pigment, k);
            if (lighting.finish.metallic != 0) tint = load(points.tint, k);
        }
        const Vector strength = hn::LoadU(Doubles(), &points.strength[k]);
        const Vector film = lighting.unevenFilm ? hn::LoadU(Doubles(), &points.film[k])
                                                : constant(lighting.finish.iridThickness);
        const Triple white = returned(lighting, pigment, tint, load(points.normal, k), load(points.view, k),
                                      load(points.toLight, k), film);
        const Triple arriving = times(light, strength);
        for (std::size_t c = 0; c < 3; ++c)
            hn::StoreU(returnedLight(white[c], arriving[c]), Doubles(), &points.returned[c][k]);
    }
}

void findAll(const Lighting& lighting, const PointRange& range, SurfacePoints& points) {
    if (lighting.patterned)
        findRange<true>(lighting, range, points);
    else
        findRange<false>(lighting, range, points);
}

void fillAll(const glm::dvec3& color, const PointRange& range, SurfacePoints::Vectors& columns) {
    const Triple all = constant(color);
    for (std::size_t k = range.first; k < range.end; k += hn::Lanes(Doubles())) store(all, columns, k);
}

void addAll(SurfacePoints& points) {
    for (std::size_t k = 0; k < points.size(); k += hn::Lanes(Doubles()))
        store(plus(load(points.shine, k), load(points.returned, k)), points.shine, k);
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(findAll);
HWY_EXPORT(fillAll);
HWY_EXPORT(addAll);

namespace {

/// Patterned pigments have none; their colours are found for each point.
glm::dvec3 solidColor(const Material& material, OpacityRule rule) {
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    if (!solid) return glm::dvec3(0);
    return material.transparent ? rgb(solid->color) * opacity(solid->color, rule) : rgb(solid->color);
}

/// The same where nothing comes through.
glm::dvec3 solidTint(const Material& material) {
    const auto* solid = std::get_if<SolidPigment>(&material.pigment);
    return solid ? rgb(solid->color) : glm::dvec3(0);
}

/// Where textures are made of parts the pigments of all points are found one by one.
bool pigmentVaries(const Material& material, const SurfacePoints& points) {
    return material.pigmentTape || points.weighted;
}

/// Of a white pigment.
glm::dvec3 whiteLight(const Finish& finish, const glm::dvec3& ambientLight) {
    return rgb(finish.ambient) * ambientLight + rgb(finish.emission);
}

}  // namespace

Lighting lightingOf(const LightSource& light, const Material& material, OpacityRule rule,
                    const glm::dvec3& wavelengths) {
    return {solidColor(material, rule),
            solidTint(material),
            rgb(light.color),
            material.finish,
            !light.shadowless,
            material.pigmentTape != nullptr,
            material.doubleIlluminate,
            wavelengths,
            material.filmTape != nullptr,
            material.normalTape != nullptr};
}

glm::dvec3 selfLight(const Material& material, OpacityRule rule, const glm::dvec3& ambientLight) {
    return solidColor(material, rule) * whiteLight(material.finish, ambientLight);
}

void findSelfLight(const Material& material, OpacityRule rule, const glm::dvec3& ambientLight,
                   const PointRange& range, SurfacePoints& points) {
    if (!pigmentVaries(material, points)) {
        HWY_DYNAMIC_DISPATCH(fillAll)(selfLight(material, rule, ambientLight), range, points.shine);
        return;
    }
    const glm::dvec3 white = whiteLight(material.finish, ambientLight);
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        double* const column = points.shine[channel].data();
        for (std::size_t k = range.first; k < range.end; ++k)
            column[k] = points.pigment[channel][k] * white[c];
    }
}

void findReturned(const LightSource& light, const Material& material, OpacityRule rule,
                  const glm::dvec3& wavelengths, const PointRange& range, SurfacePoints& points) {
    Lighting lighting = lightingOf(light, material, rule, wavelengths);
    lighting.patterned = pigmentVaries(material, points);
    HWY_DYNAMIC_DISPATCH(findAll)(lighting, range, points);
}

void addReturned(SurfacePoints& points) { HWY_DYNAMIC_DISPATCH(addAll)(points); }

}  // namespace isoscope
#endif

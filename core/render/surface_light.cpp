// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/surface_light.h"

#include "core/render/transmission.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/surface_light.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/shapes/vector_triple-inl.h"

#ifndef ISOSCOPE_RENDER_SURFACE_LIGHT_ONCE
#define ISOSCOPE_RENDER_SURFACE_LIGHT_ONCE
namespace isoscope {

/// A material and a light, in numbers.
struct Lighting {
    glm::dvec3 pigment{0};
    glm::dvec3 light{0};
    Finish finish;
    bool highlights = true;
    bool patterned = false;     ///< the pigment is that of SurfacePoints instead
    bool doubled = false;       ///< light from behind counts as well
    glm::dvec3 wavelengths{0};  ///< of red, green and blue, for thin films
    bool bent = false;          ///< the normals face the viewer, or were bent away on purpose
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Mask = hn::Mask<Doubles>;

HWY_INLINE Mask positive(Vector a) { return hn::Gt(a, hn::Zero(Doubles())); }

/// By squaring, to within exponent * 1e-16 of itself.
HWY_INLINE Vector wholePower(Vector base, unsigned exponent) {
    Vector result = constant(1);
    for (; exponent > 1; exponent /= 2) {
        if (exponent % 2 == 1) result = hn::Mul(result, base);
        base = hn::Mul(base, base);
    }
    return hn::Mul(result, base);
}

/// base ^ exponent where base > 0, else 0. Most exponents are whole numbers, those of brilliance 1.
HWY_INLINE Vector power(Vector base, double exponent) {
    const Mask some = positive(base);
    if (hn::AllFalse(Doubles(), some)) return hn::Zero(Doubles());
    if (exponent == 1) return hn::IfThenElseZero(some, base);
    constexpr double greatest = 1000;
    if (exponent > 0 && exponent <= greatest && exponent == std::floor(exponent))
        return hn::IfThenElseZero(some, wholePower(base, static_cast<unsigned>(exponent)));
    return hn::IfThenElseZero(some, sleefPow(hn::IfThenElse(some, base, constant(1)), constant(exponent)));
}

/// The colour of a highlight: the light's own, or tinted by the pigment for metals, less so towards grazing
/// light. Fresnel term of Cook and Torrance's metals in the closed form that POV-Ray's pictures show.
HWY_INLINE Triple highlightTint(double metallic, Vector cosine, const Triple& pigment) {
    const Triple white = constant(glm::dvec3(1));
    if (metallic == 0) return white;
    const Vector inside = hn::Min(hn::Max(cosine, constant(-1)), constant(1));
    const Vector x = hn::Div(sleefAcos(inside), constant(std::numbers::pi / 2));
    const Vector way = hn::Sub(x, constant(1.12));
    const Vector term = hn::Sub(hn::Div(constant(0.014567225), hn::Mul(way, way)), constant(0.011612903));
    const Vector fresnel = hn::Min(hn::Max(term, hn::Zero(Doubles())), constant(1));
    const Vector amount = hn::Mul(constant(metallic), hn::Sub(constant(1), fresnel));
    return plus(white, times(minus(pigment, white), amount));
}

HWY_INLINE Vector phong(const Finish& finish, const Triple& normal, const Triple& view, const Triple& light) {
    if (finish.phong <= 0) return hn::Zero(Doubles());
    const Vector twice = hn::Mul(constant(2), dot(view, normal));
    const Triple mirrored = minus(view, times(normal, twice));
    return hn::Mul(constant(finish.phong), power(dot(mirrored, light), finish.phongSize));
}

HWY_INLINE Vector specular(const Finish& finish, const Triple& normal, const Triple& view,
                           const Triple& light) {
    if (finish.specular <= 0 || !(finish.roughness > 0)) return hn::Zero(Doubles());
    const Triple halfway = minus(light, view);
    const Vector length = hn::Sqrt(dot(halfway, halfway));
    const Vector cosine = hn::IfThenElseZero(positive(length), hn::Div(dot(halfway, normal), length));
    return hn::Mul(constant(finish.specular), power(cosine, 1 / finish.roughness));
}

/// What a thin film on the surface makes of the diffuse light, where the cosines of the angles of light and
/// view add up to `cosines`.
HWY_INLINE Triple withFilm(const Lighting& lighting, const Triple& light, Vector cosines) {
    const Finish& finish = lighting.finish;
    const auto channel = [&](double wavelength, Vector value) HWY_ATTR {
        const double turns = 2 * std::numbers::pi * finish.iridThickness / wavelength;
        const Vector wave = sleefCos(hn::Mul(constant(turns), cosines));
        return hn::Mul(value, hn::MulAdd(constant(finish.irid), wave, constant(1)));
    };
    return {channel(lighting.wavelengths.x, light.x), channel(lighting.wavelengths.y, light.y),
            channel(lighting.wavelengths.z, light.z)};
}

/// What a white light of strength 1 makes the surface return.
HWY_INLINE Triple returned(const Lighting& lighting, const Triple& pigment, const Triple& normal,
                           const Triple& view, const Triple& light) {
    const Finish& finish = lighting.finish;
    const Vector turn = hn::IfThenElse(positive(dot(normal, view)), constant(-1), constant(1));
    const Triple facing = lighting.bent ? normal : times(normal, turn);
    const Vector cosine = dot(facing, light);
    const Vector lit = lighting.doubled ? hn::Abs(cosine) : cosine;
    Vector diffuse = hn::Mul(constant(finish.diffuse), power(lit, finish.brilliance));
    if (finish.diffuseBack > 0)
        diffuse = hn::Add(diffuse,
                          hn::Mul(constant(finish.diffuseBack), power(hn::Neg(cosine), finish.brilliance)));
    Triple result = times(pigment, diffuse);
    if (finish.irid != 0) result = withFilm(lighting, result, hn::Sub(cosine, dot(facing, view)));
    if (!lighting.highlights) return result;
    const Vector strength =
        hn::Add(phong(finish, facing, view, light), specular(finish, facing, view, light));
    const Vector highlight = hn::IfThenElseZero(positive(cosine), strength);
    return plus(result, times(highlightTint(finish.metallic, cosine, pigment), highlight));
}

template <bool patterned>
void findRange(const Lighting& lighting, const PointRange& range, SurfacePoints& points) {
    const Triple light = constant(lighting.light);
    Triple pigment = constant(lighting.pigment);
    for (std::size_t k = range.first; k < range.end; k += hn::Lanes(Doubles())) {
        if constexpr (patterned) pigment = load(points.pigment, k);
        const Vector strength = hn::LoadU(Doubles(), &points.strength[k]);
        const Triple white = returned(lighting, pigment, load(points.normal, k), load(points.view, k),
                                      load(points.toLight, k));
        const Triple arriving = times(light, strength);
        // Endless light shows only where something returns it.
        for (std::size_t c = 0; c < 3; ++c)
            hn::StoreU(hn::IfThenElseZero(positive(white[c]), hn::Mul(arriving[c], white[c])), Doubles(),
                       &points.returned[c][k]);
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

/// Where textures are made of parts the pigments of all points are found one by one.
bool pigmentVaries(const Material& material, const SurfacePoints& points) {
    return material.pigmentTape || points.weighted;
}

}  // namespace

void findSelfLight(const Material& material, OpacityRule rule, const glm::dvec3& ambientLight,
                   const PointRange& range, SurfacePoints& points) {
    const Finish& finish = material.finish;
    const glm::dvec3 white = rgb(finish.ambient) * ambientLight + rgb(finish.emission);
    const glm::dvec3 shine = solidColor(material, rule) * white;
    if (!pigmentVaries(material, points)) {
        HWY_DYNAMIC_DISPATCH(fillAll)(shine, range, points.shine);
        return;
    }
    for (int c = 0; c < 3; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        double* const column = points.shine[channel].data();
        for (std::size_t k = range.first; k < range.end; ++k)
            column[k] = points.pigment[channel][k] * white[c];
    }
}

void findReturned(const LightSource& light, const Material& material, OpacityRule rule,
                  const glm::dvec3& wavelengths, const PointRange& range, SurfacePoints& points) {
    const Lighting lighting{solidColor(material, rule),
                            rgb(light.color),
                            material.finish,
                            !light.shadowless,
                            pigmentVaries(material, points),
                            material.doubleIlluminate,
                            wavelengths,
                            material.normalTape != nullptr};
    HWY_DYNAMIC_DISPATCH(findAll)(lighting, range, points);
}

void addReturned(SurfacePoints& points) { HWY_DYNAMIC_DISPATCH(addAll)(points); }

}  // namespace isoscope
#endif

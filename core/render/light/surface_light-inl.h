// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. What surfaces return of light, for several points in vector registers.
#if defined(ISOSCOPE_RENDER_SURFACE_LIGHT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_RENDER_SURFACE_LIGHT_INL
#undef ISOSCOPE_RENDER_SURFACE_LIGHT_INL
#else
#define ISOSCOPE_RENDER_SURFACE_LIGHT_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <numbers>

#include "core/render/light/lighting.h"
#include "core/shapes/patches/vector_triple-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

HWY_INLINE hn::Mask<Doubles> positive(Vector a) { return hn::Gt(a, hn::Zero(Doubles())); }

/// The light that arrives where something returns it, else 0: endless light shows only there. Negative
/// pigments return negative light.
HWY_INLINE Vector returnedLight(Vector white, Vector arriving) {
    return hn::IfThenElseZero(positive(hn::Abs(white)), hn::Mul(arriving, white));
}

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
    const auto some = positive(base);
    if (hn::AllFalse(Doubles(), some)) return hn::Zero(Doubles());
    if (exponent == 1) return hn::IfThenElseZero(some, base);
    constexpr double greatest = 1000;
    if (exponent > 0 && exponent <= greatest && exponent == std::floor(exponent))
        return hn::IfThenElseZero(some, wholePower(base, static_cast<unsigned>(exponent)));
    return hn::IfThenElseZero(some, sleefPow(hn::IfThenElse(some, base, constant(1)), constant(exponent)));
}

/// The colour of a highlight: the light's own, or tinted by the colour of a metal, less so towards grazing
/// light. Fresnel term of Cook and Torrance's metals in the closed form that POV-Ray's pictures show.
HWY_INLINE Triple highlightTint(double metallic, Vector cosine, const Triple& metal) {
    const Triple white = constant(glm::dvec3(1));
    if (metallic == 0) return white;
    const Vector inside = hn::Min(hn::Max(cosine, constant(-1)), constant(1));
    const Vector x = hn::Div(sleefAcos(inside), constant(std::numbers::pi / 2));
    const Vector way = hn::Sub(x, constant(1.12));
    const Vector term = hn::Sub(hn::Div(constant(0.014567225), hn::Mul(way, way)), constant(0.011612903));
    const Vector fresnel = hn::Min(hn::Max(term, hn::Zero(Doubles())), constant(1));
    const Vector amount = hn::Mul(constant(metallic), hn::Sub(constant(1), fresnel));
    return plus(white, times(minus(metal, white), amount));
}

HWY_INLINE Vector phong(const Finish& finish, const Triple& normal, const Triple& view, const Triple& light) {
    if (finish.phong <= 0) return hn::Zero(Doubles());
    const Vector twice = hn::Mul(constant(2), dot(view, normal));
    const Triple mirrored = minus(view, times(normal, twice));
    return hn::Mul(constant(finish.phong), power(dot(mirrored, light), finish.phongSize));
}

HWY_INLINE Vector specular(const Finish& finish, const Triple& normal, const Triple& view,
                           const Triple& light) {
    if (finish.specular <= 0) return hn::Zero(Doubles());
    const Triple halfway = minus(light, view);
    const Vector length = hn::Sqrt(dot(halfway, halfway));
    const Vector cosine = hn::IfThenElseZero(positive(length), hn::Div(dot(halfway, normal), length));
    return hn::Mul(constant(finish.specular), power(cosine, finish.specularExponent()));
}

/// What a thin film on the surface makes of the light that comes back from it, where the cosines of the
/// angles of light and view add up to `cosines`; filmShare() of reflectance.h says the same of mirrors.
HWY_INLINE Triple withFilm(const Lighting& lighting, const Triple& light, Vector thickness, Vector cosines) {
    const auto channel = [&](double wavelength, Vector value) HWY_ATTR {
        const Vector turns = hn::Mul(thickness, constant(2 * std::numbers::pi / wavelength));
        const Vector wave = sleefCos(hn::Mul(turns, cosines));
        return hn::Mul(value, hn::MulAdd(constant(lighting.finish.irid), wave, constant(1)));
    };
    return {channel(lighting.wavelengths.x, light.x), channel(lighting.wavelengths.y, light.y),
            channel(lighting.wavelengths.z, light.z)};
}

/// What a white light of strength 1 makes the surface return, which has a film as thick as `film`.
HWY_INLINE Triple returned(const Lighting& lighting, const Triple& pigment, const Triple& tint,
                           const Triple& normal, const Triple& view, const Triple& light, Vector film) {
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
    if (lighting.highlights) {
        const Vector strength =
            hn::Add(phong(finish, facing, view, light), specular(finish, facing, view, light));
        const Vector highlight = hn::IfThenElseZero(positive(cosine), strength);
        result = plus(result, times(highlightTint(finish.metallic, cosine, tint), highlight));
    }
    if (finish.irid == 0) return result;
    return withFilm(lighting, result, film, hn::Sub(cosine, dot(facing, view)));
}

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

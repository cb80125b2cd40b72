// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/julia_fractal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/shapes/isosurface/julia_algebra.h"
#include "core/shapes/isosurface/povray_julia.h"
#include "core/shapes/rays/centered_ray.h"
#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

/// Steps are not halved below this; features that are smaller still may be passed.
constexpr double shortestStep = 1e-6;
constexpr int stepLimit = 20'000;
/// No step is longer where balls are estimates.
constexpr double longestEstimated = 0.02;

/// How large a ball becomes that is squared or cubed, or an estimate of that.
double grown(JuliaFunction function, double size, double radius, double slope) {
    if (function == JuliaFunction::sqr) return radius * (2 * size + radius);
    if (function == JuliaFunction::cube) return radius * (3 * size * size + radius * (3 * size + radius));
    return 2 * slope * radius;
}

bool hasCuts(JuliaFunction function) {
    using F = JuliaFunction;
    switch (function) {
        case F::asin:
        case F::asinh:
        case F::acos:
        case F::acosh:
        case F::atan:
        case F::atanh:
        case F::ln:
        case F::pwr: return true;
        default: return false;
    }
}

/// Whether the values of neighbouring numbers are none.
bool jumps(const Complex& one, const Complex& other, const Complex& value, const Complex& otherValue) {
    return std::abs(one - other) < 1e-6 && std::abs(value - otherValue) > 1e-3;
}

/// Whether the real axis lies between them, rather than the imaginary one.
bool crossesReal(const Complex& one, const Complex& other) {
    return std::signbit(one.imag()) != std::signbit(other.imag());
}

}  // namespace

JuliaFractal::JuliaFractal(const JuliaSettings& settings) : settings_(settings) {
    settings_.slice = glm::normalize(settings_.slice);
    settings_.precision = std::max(settings_.precision, 1.0);
    const bool quaternion = settings_.algebra == JuliaAlgebra::quaternion;
    reach_ = quaternion ? std::min(2.0, 1 + glm::length(settings_.parameter)) : 4;
    stretch_ = 1 / std::abs(settings_.slice.w);
    exact_ = settings_.function == JuliaFunction::sqr || settings_.function == JuliaFunction::cube;
}

glm::dvec4 JuliaFractal::start(const glm::dvec3& p) const {
    const glm::dvec4& n = settings_.slice;
    return {p.x, p.y, p.z, (settings_.sliceDistance - n.x * p.x - n.y * p.y - n.z * p.z) / n.w};
}

int JuliaFractal::escape(const glm::dvec3& point) const {
    const double limit = reach_ * reach_;
    const JuliaFunction f = settings_.function;
    if (settings_.algebra == JuliaAlgebra::quaternion) {
        glm::dvec4 h = start(point);
        for (int n = 0; n < settings_.maxIteration; ++n) {
            if (!(glm::dot(h, h) <= limit)) return n;
            const glm::dvec4 square = quaternionProduct(h, h);
            h = (f == JuliaFunction::cube ? quaternionProduct(square, h) : square) + settings_.parameter;
        }
        return settings_.maxIteration;
    }
    ComplexPair h(start(point));
    const ComplexPair p(settings_.parameter);
    for (int n = 0; n < settings_.maxIteration; ++n) {
        if (!(h.squaredNorm() <= limit)) return n;
        h.a = juliaFunction(f, h.a, settings_.exponent) + p.a;
        h.b = juliaFunction(f, h.b, settings_.exponent) + p.b;
    }
    return settings_.maxIteration;
}

bool JuliaFractal::ballKeeps(const glm::dvec3& point, double radius, bool inside) const {
    const JuliaFunction f = settings_.function;
    double e = radius * stretch_;
    if (settings_.algebra == JuliaAlgebra::quaternion) {
        glm::dvec4 h = start(point);
        for (int n = 0; n < settings_.maxIteration; ++n) {
            const double size = glm::length(h);
            if (size - e > reach_) return !inside;
            if (size + e > reach_) {
                if (inside) return false;
                if (!(size - e < 1e6)) return false;
            }
            e = grown(f, size, e, 0);
            const glm::dvec4 square = quaternionProduct(h, h);
            h = (f == JuliaFunction::cube ? quaternionProduct(square, h) : square) + settings_.parameter;
        }
        return inside;
    }
    ComplexPair h(start(point));
    const ComplexPair p(settings_.parameter);
    double ea = e * std::sqrt(2.0), eb = ea;
    for (int n = 0; n < settings_.maxIteration; ++n) {
        const double size = std::sqrt(h.squaredNorm()), room = std::sqrt((ea * ea + eb * eb) / 2);
        if (size - room > reach_) return !inside;
        if (size + room > reach_ && (inside || !(room < 1e6))) return false;
        const auto slopeAt = [&](const Complex& z) {
            return exact_ ? 0 : std::abs(juliaSlope(f, z, settings_.exponent));
        };
        // std::abs guards against overflow, at a third of the whole cost; what is as large has escaped.
        ea = grown(f, std::sqrt(std::norm(h.a)), ea, slopeAt(h.a));
        eb = grown(f, std::sqrt(std::norm(h.b)), eb, slopeAt(h.b));
        h.a = juliaFunction(f, h.a, settings_.exponent) + p.a;
        h.b = juliaFunction(f, h.b, settings_.exponent) + p.b;
    }
    return inside;
}

double JuliaFractal::safeStep(const glm::dvec3& point, bool inside, double most) const {
    double step = exact_ ? most : std::min(most, longestEstimated);
    while (step > shortestStep && !ballKeeps(point, step, inside)) step /= 2;
    return std::max(step, shortestStep);
}

void JuliaFractal::trace(const Ray& ray, RayInterval interval, bool first, TraceContext& context,
                         HitList& hits) const {
    ++context.rays;
    if (context.rootFinder == RootFinder::lipschitz && PovrayJulia::appliesTo(settings_))
        return traceAsPovray(ray, interval, first, context, hits);
    const CenteredRay line(ray, glm::dvec3(0));
    const double squaredMiss = glm::dot(line.origin, line.origin);
    if (!line.usable || !(squaredMiss < reach_ * reach_)) return;
    const double half = std::sqrt(reach_ * reach_ - squaredMiss) + 1e-9;
    double s = std::max(-half, line.fromRay(interval.near));
    const double end = std::min(half, line.fromRay(interval.far));
    bool inside = escape(line.at(s)) == settings_.maxIteration;
    double last = reach_ / 4;
    for (int count = 0; s < end && count < stepLimit && !context.stop.stop_requested(); ++count) {
        last = safeStep(line.at(s), inside, std::min(4 * last, reach_));
        const double next = std::min(s + last, end);
        const bool then = escape(line.at(next)) == settings_.maxIteration;
        if (then != inside) {
            double low = s, high = next;
            while (high - low > 1e-14 * reach_) {
                const double middle = low + (high - low) / 2;
                if (!(middle > low && middle < high)) break;
                ((escape(line.at(middle)) == settings_.maxIteration) == inside ? low : high) = middle;
            }
            const double outer = inside ? high : low, inner = inside ? low : high;
            const double t = line.toRay(low + (high - low) / 2);
            // POV-Ray's normals are those of one iterate more than it tests.
            const int iterate = escape(line.at(outer)) + (exact_ ? 1 : 0);
            if (interval.near <= t && t <= interval.far) {
                const std::optional<glm::dvec3> cut = cutNormal(line.at(inner), line.at(outer));
                hits.push_back({t, ray.at(t), cut ? *cut : normalAt(line.at(outer), iterate)});
                if (first) return;
            }
            inside = then;
        }
        s = next;
    }
}

void JuliaFractal::traceAsPovray(const Ray& ray, RayInterval interval, bool first, TraceContext& context,
                                 HitList& hits) const {
    const CenteredRay line(ray, glm::dvec3(0));
    const double squaredMiss = glm::dot(line.origin, line.origin);
    if (!line.usable || !(squaredMiss < reach_ * reach_)) return;
    const double half = std::sqrt(reach_ * reach_ - squaredMiss);
    const double end = std::min(half, line.fromRay(interval.far) + 1 / settings_.precision);
    // Its steps are counted from the ray's origin or the sphere, also where only a part of the ray is asked
    // for.
    const double origin = interval.near < 0 ? -half : line.fromRay(0);
    const auto keeps = [this](const glm::dvec3& point, double radius, bool inside) {
        return ballKeeps(point, radius, inside);
    };
    PovrayJulia povray(settings_);
    PovrayJulia::Place place;
    povray.begin(line, std::max(origin, -half), end, origin > -half);
    while (povray.next(line, keeps, context.stop, place)) {
        const double t = line.toRay(place.s);
        if (!(interval.near <= t && t <= interval.far)) continue;
        hits.push_back({t, ray.at(t), place.normal});
        if (first) return;
    }
}

glm::dvec3 JuliaFractal::normalAt(const glm::dvec3& point, int iterate) const {
    // The iterate's derivatives along x, y and z. As in POV-Ray the slice's own slope is left out of them.
    std::array<glm::dvec4, 3> moved{glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0)};
    const JuliaFunction f = settings_.function;
    glm::dvec3 normal(0);
    if (settings_.algebra == JuliaAlgebra::quaternion) {
        glm::dvec4 h = start(point);
        for (int k = 0; k < iterate; ++k) {
            const glm::dvec4 square = quaternionProduct(h, h);
            for (glm::dvec4& d : moved) {
                const glm::dvec4 squareMoved = quaternionProduct(h, d) + quaternionProduct(d, h);
                d = f == JuliaFunction::cube
                        ? quaternionProduct(squareMoved, h) + quaternionProduct(square, d)
                        : squareMoved;
            }
            h = (f == JuliaFunction::cube ? quaternionProduct(square, h) : square) + settings_.parameter;
        }
        for (int axis = 0; axis < 3; ++axis)
            normal[axis] = glm::dot(h, moved[static_cast<std::size_t>(axis)]);
        return unitNormal(normal);
    }
    ComplexPair h(start(point));
    const ComplexPair p(settings_.parameter);
    Complex slopeA = 1, slopeB = 1;
    for (int k = 0; k < iterate; ++k) {
        slopeA *= juliaSlope(f, h.a, settings_.exponent);
        slopeB *= juliaSlope(f, h.b, settings_.exponent);
        h.a = juliaFunction(f, h.a, settings_.exponent) + p.a;
        h.b = juliaFunction(f, h.b, settings_.exponent) + p.b;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const ComplexPair d(moved[static_cast<std::size_t>(axis)]);
        normal[axis] = std::real(std::conj(h.a) * slopeA * d.a + std::conj(h.b) * slopeB * d.b);
    }
    return unitNormal(normal);
}

std::optional<glm::dvec3> JuliaFractal::cutNormal(const glm::dvec3& inner, const glm::dvec3& outer) const {
    if (settings_.algebra == JuliaAlgebra::quaternion || !hasCuts(settings_.function)) return std::nullopt;
    ComplexPair in(start(inner)), out(start(outer));
    const ComplexPair p(settings_.parameter);
    Complex slopeA = 1, slopeB = 1;
    const auto value = [&](const Complex& z) {
        return juliaFunction(settings_.function, z, settings_.exponent);
    };
    for (int k = 0; k < settings_.maxIteration; ++k) {
        const Complex inA = value(in.a), outA = value(out.a), inB = value(in.b), outB = value(out.b);
        const bool cutA = jumps(in.a, out.a, inA, outA), cutB = jumps(in.b, out.b, inB, outB);
        if (cutA || cutB) {
            const Complex slope = cutA ? slopeA : slopeB;
            // The cuts lie on the axes of the plane.
            const bool real = cutA ? crossesReal(in.a, out.a) : crossesReal(in.b, out.b);
            // What a move along y does to the imaginary part of the pair's half, one along z does up to sign.
            const Complex x = slope, y = slope * Complex(0, 1), z = cutA ? y : -y;
            const glm::dvec3 normal =
                real ? glm::dvec3(x.imag(), y.imag(), z.imag()) : glm::dvec3(x.real(), y.real(), z.real());
            return unitNormal(glm::dot(normal, outer - inner) < 0 ? -normal : normal);
        }
        slopeA *= juliaSlope(settings_.function, in.a, settings_.exponent);
        slopeB *= juliaSlope(settings_.function, in.b, settings_.exponent);
        in.a = inA + p.a;
        in.b = inB + p.b;
        out.a = outA + p.a;
        out.b = outB + p.b;
    }
    return std::nullopt;
}

void JuliaFractal::intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                             HitList& hits) const {
    trace(ray, interval, false, context, hits);
}

void JuliaFractal::nearest(std::span<const Ray> rays, TraceContext& context,
                           std::span<NearestHit> nearest) const {
    traceOneByOne(rays, context.nearLimit, nearest, [&](const Ray& ray, RayInterval interval, HitList& hits) {
        trace(ray, interval, true, context, hits);
    });
}

bool JuliaFractal::contains(const glm::dvec3& point, TraceContext&) const {
    return escape(point) == settings_.maxIteration;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "core/shapes/julia_algebra.h"
#include "core/shapes/julia_fractal.h"

namespace isoscope::test {

/// What POV-Ray 3.7.0.10 answers for the normal of a hypercomplex Julia set of a function other than sqr,
/// cube and reciprocal, worked out from its answers: with the iterates h[0] to h[m], m = max_iteration, it is
/// the part <x, y, z> of the hypercomplex number
///
///     conj(h[0] f(h[1]) f(h[2]) ... f(h[m - 1])) h[m]
///
/// which is no gradient of anything: the functions' own values stand in for their slopes. Moreover the
/// iteration begins at <x, y, y, w> instead of <x, y, z, w>, and where it escapes the iterates of the true
/// point remain in force from there on.
inline std::optional<glm::dvec3> povrayJuliaNormal(const JuliaSettings& settings, const glm::dvec3& point) {
    constexpr double reach = 4;
    const glm::dvec4& n = settings.slice;
    const double w = (settings.sliceDistance - n.x * point.x - n.y * point.y - n.z * point.z) / n.w;
    const auto last = static_cast<std::size_t>(settings.maxIteration);
    const ComplexPair p(settings.parameter);
    const auto value = [&](const Complex& z) {
        return juliaFunction(settings.function, z, settings.exponent);
    };
    const auto iterates = [&](double z) {
        std::vector<ComplexPair> h{ComplexPair(glm::dvec4(point.x, point.y, z, w))};
        while (h.size() <= last) {
            ComplexPair next = h.back();
            next.a = value(next.a) + p.a;
            next.b = value(next.b) + p.b;
            h.push_back(next);
        }
        return h;
    };
    std::vector<ComplexPair> h = iterates(point.z);
    const std::vector<ComplexPair> mistaken = iterates(point.y);
    for (std::size_t k = 0; k <= last; ++k) {
        h[k] = mistaken[k];
        if (!(mistaken[k].squaredNorm() <= reach * reach)) break;
    }
    Complex a = std::conj(h[0].a), b = std::conj(h[0].b);
    for (std::size_t k = 1; k < last; ++k) {
        a *= std::conj(value(h[k].a));
        b *= std::conj(value(h[k].b));
    }
    a *= h[last].a;
    b *= h[last].b;
    const glm::dvec3 normal((a + b).real(), (a + b).imag(), (a - b).imag());
    const double length = glm::length(normal);
    if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
    return normal / length;
}

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/povray_julia.h"

#include <cmath>

#include "core/shapes/rays/hit_list.h"

namespace isoscope {

namespace {

constexpr double squaredReach = 16;
constexpr double coarsest = 5'000, finest = 20'000;  ///< of the precisions followed
/// Crossings are halved down to this. Rays that begin within the sphere are followed from here on, and from
/// three times as far when they begin within the set.
constexpr double least = 1e-7;
/// Balls are estimates, and good ones only when they are small.
constexpr double longestStride = 0.02;

/// Whether it has neither poles nor cuts, which the balls overlook.
bool isEntire(JuliaFunction function) {
    using F = JuliaFunction;
    return function == F::exp || function == F::sin || function == F::cos || function == F::sinh ||
           function == F::cosh;
}

}  // namespace

bool PovrayJulia::appliesTo(const JuliaSettings& settings) {
    return settings.algebra == JuliaAlgebra::hypercomplex && settings.function != JuliaFunction::sqr &&
           settings.function != JuliaFunction::cube && settings.precision >= coarsest &&
           settings.precision <= finest;
}

PovrayJulia::PovrayJulia(const JuliaSettings& settings)
    : settings_(settings),
      parameter_(settings.parameter),
      mistaken_(settings.function != JuliaFunction::reciprocal),
      longestStride_(isEntire(settings.function) ? longestStride : 0),
      iterates_(static_cast<std::size_t>(settings.maxIteration) + 1, ComplexPair(glm::dvec4(0))) {}

bool PovrayJulia::iterate(const glm::dvec3& p, bool mistaken) {
    const glm::dvec4& n = settings_.slice;
    const double z = mistaken ? p.y : p.z;
    const double w = (settings_.sliceDistance - n.x * p.x - n.y * p.y - n.z * z) / n.w;
    iterates_[0] = ComplexPair(glm::dvec4(p.x, p.y, z, w));
    for (std::size_t k = 0; k + 1 < iterates_.size(); ++k) {
        const ComplexPair& h = iterates_[k];
        if (!(h.squaredNorm() <= squaredReach)) return false;
        iterates_[k + 1].a = juliaFunction(settings_.function, h.a, settings_.exponent) + parameter_.a;
        iterates_[k + 1].b = juliaFunction(settings_.function, h.b, settings_.exponent) + parameter_.b;
    }
    return true;
}

glm::dvec3 PovrayJulia::normal() const {
    const auto factor = [&](const Complex& z) {
        return std::conj(mistaken_ ? juliaFunction(settings_.function, z, settings_.exponent)
                                   : juliaSlope(settings_.function, z, settings_.exponent));
    };
    Complex a = std::conj(iterates_.front().a), b = std::conj(iterates_.front().b);
    for (std::size_t k = 1; k + 1 < iterates_.size(); ++k) {
        a *= factor(iterates_[k].a);
        b *= factor(iterates_[k].b);
    }
    a *= iterates_.back().a;
    b *= iterates_.back().b;
    return unitNormal({(a + b).real(), (a + b).imag(), (a - b).imag()});
}

void PovrayJulia::begin(const CenteredRay& line, double s, double end, bool atOrigin) {
    s_ = s + (atOrigin ? least : 0);
    end_ = end;
    // On the sphere itself rounding would decide.
    inside_ = atOrigin && iterate(line.at(s_), false);
    if (inside_) s_ = s + 3 * least;
}

bool PovrayJulia::next(const CenteredRay& line, const Keeps& keeps, std::stop_token stop, Place& place) {
    const double step = 1 / settings_.precision;
    while (!stop.stop_requested()) {
        const glm::dvec3 here = line.at(s_);
        while (stride_ > 1 && !keeps(here, stride_ * step, inside_)) stride_ /= 2;
        const double ahead = s_ + stride_ * step;
        if (ahead > end_ && stride_ == 1) return false;
        const bool crossed = iterate(line.at(ahead), false) != inside_;
        if (stride_ > 1 && (crossed || ahead > end_)) {
            stride_ /= 2;
            continue;
        }
        s_ = ahead;
        if (!crossed) {
            if (2 * stride_ * step <= longestStride_) stride_ *= 2;
            continue;
        }
        double same = s_ - step, other = s_;
        while (other - same > least) {
            const double middle = same + (other - same) / 2;
            (iterate(line.at(middle), mistaken_) == inside_ ? same : other) = middle;
        }
        s_ = inside_ ? same : other;
        iterate(line.at(s_), mistaken_);
        place = {s_, normal()};
        inside_ = !inside_;
        return true;
    }
    return false;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/health/ailment_probe.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

namespace isoscope {

namespace {

/// Halvings of a way across a jump: down to some 1e-11 of the box.
constexpr int halvings = 36;
/// Of what lies between two places so near to each other, this many times more than slopes explain is a jump.
constexpr double unexplained = 1000;
/// How far gradients on both sides of a kink differ, in parts of the longer one.
constexpr double kinkShare = 1e-3;
/// Values, or slopes, that grow by this factor while a place is approached grow without end.
constexpr double growth = 1e6;
constexpr int climbs = 60;
/// Samples along each axis of a box, its faces and a little beyond them.
constexpr int samplesAlong = 4;

double steepnessOf(const glm::dvec3& slope) { return glm::length(slope); }

}  // namespace

AilmentProbe::Sample AilmentProbe::at(const glm::dvec3& place) {
    const ValueAndGradient all = gradients_.evaluate(place.x, place.y, place.z);
    return {place, all.value, {all.gradient[0], all.gradient[1], all.gradient[2]}};
}

std::optional<AilmentProbe::Met> AilmentProbe::look(Ailment ailment, const GradientBox& box) {
    std::vector<Sample> samples;
    const glm::dvec3 extent = box.high - box.low;
    for (int x = 0; x < samplesAlong; ++x)
        for (int y = 0; y < samplesAlong; ++y)
            for (int z = 0; z < samplesAlong; ++z) {
                const glm::dvec3 share = glm::dvec3(x, y, z) / (samplesAlong - 1.0);
                const glm::dvec3 place = box.low + (1.02 * share - 0.01) * extent;
                if (domain_.contains(place)) samples.push_back(at(place));
            }
    const auto undefined =
        std::ranges::find_if(samples, [](const Sample& one) { return std::isnan(one.value); });
    if (ailment == Ailment::undefined)
        return undefined == samples.end() ? std::nullopt : std::optional(Met{undefined->place, 0});
    std::erase_if(samples, [](const Sample& one) { return std::isnan(one.value); });
    if (samples.empty()) return {};
    if (ailment == Ailment::infinite) {
        const auto steepest = std::ranges::max_element(samples, {}, [](const Sample& one) {
            return std::max(std::abs(one.value), steepnessOf(one.slope));
        });
        return climb(*steepest, box.width());
    }
    // Between the first and each other sample lies what tells the two sides apart.
    for (const Sample& other : samples)
        if (const auto met = step(ailment, samples.front(), other)) return met;
    return {};
}

/// Halves the way from a to b towards where the value, or the gradient, changes most.
std::optional<AilmentProbe::Met> AilmentProbe::step(Ailment ailment, Sample a, Sample b) {
    const bool jump = ailment == Ailment::jump;
    const auto change = [&](const Sample& p, const Sample& q) {
        return jump ? std::abs(q.value - p.value) : glm::length(q.slope - p.slope);
    };
    const double before = change(a, b);
    if (!(before > 0) || !std::isfinite(before)) return {};
    const double way = glm::distance(a.place, b.place);
    for (int i = 0; i < halvings; ++i) {
        const Sample middle = at(0.5 * a.place + 0.5 * b.place);
        const double first = change(a, middle), second = change(middle, b);
        if (std::isnan(first) || std::isnan(second)) return {};
        (first >= second ? b : a) = middle;
    }
    const double left = change(a, b), length = std::ldexp(way, -halvings);
    const glm::dvec3 place = 0.5 * a.place + 0.5 * b.place;
    if (jump) {
        const double slopes = std::max(steepnessOf(a.slope), steepnessOf(b.slope));
        const double noise = 1e-12 * std::max(std::abs(a.value), std::abs(b.value));
        return left > unexplained * slopes * length + noise ? std::optional(Met{place, left}) : std::nullopt;
    }
    const double longer = std::max(steepnessOf(a.slope), steepnessOf(b.slope));
    return left > kinkShare * longer && std::isfinite(longer) ? std::optional(Met{place, 0}) : std::nullopt;
}

/// Looks in ever smaller surroundings for larger values or slopes.
std::optional<AilmentProbe::Met> AilmentProbe::climb(Sample best, double width) {
    const auto height = [](const Sample& one) {
        return std::max(std::abs(one.value), steepnessOf(one.slope));
    };
    const double before = std::max(height(best), 1e-300);
    double reach = 0.5 * width;
    for (int i = 0; i < climbs; ++i) {
        Sample highest = best;
        for (int k = 0; k < 3; ++k)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 place = best.place;
                place[k] += sign * reach;
                if (!domain_.contains(place)) continue;
                const Sample next = at(place);
                if (std::isnan(next.value)) continue;
                if (height(next) > height(highest)) highest = next;
            }
        if (std::isinf(height(highest)) || height(highest) > growth * before ||
            height(highest) >= GradientEvaluator::steepest)
            return Met{highest.place, 0};
        if (height(highest) == height(best)) reach *= 0.5;
        best = highest;
    }
    return {};
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/surface_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace isoscope {

namespace {

/// Of halvings and better steps; enough for halvings alone.
constexpr int mostSteps = 60;
/// How far beside a jump others are looked for, by the length of the way.
constexpr double probeReach = 0.02;
/// A change of value is a jump if it is so many times what the slope explains.
constexpr double jumpFactor = 8;

/// Values as the search has them: without infinities.
double usable(double g) { return std::clamp(g, -1e30, 1e30); }

/// The search on one way; shares are those of the way.
struct Search {
    double a = 0, b = 1, c = 0;     ///< the last place, the other end of the interval, the one before
    double fa = 0, fb = 0, fc = 0;  ///< values there
    double next = 0.5;              ///< where to look, from a to b
    bool settled = false;

    double place() const { return a + next * (b - a); }
    double root() const { return std::abs(fa) < std::abs(fb) ? a : b; }

    void take(double value, double closeness) {
        const double at = place();
        if (countsInside(value) == countsInside(fa)) {
            c = a;
            fc = fa;
        } else {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = at;
        fa = value;
        plan(closeness);
    }

  private:
    void plan(double closeness) {
        const double limit = closeness / std::abs(b - a);
        if (!(limit < 0.5)) {
            settled = true;
            return;
        }
        const double along = (a - b) / (c - b), rise = (fa - fb) / (fc - fb);
        next = 0.5;
        if (rise * rise < along && (1 - rise) * (1 - rise) < 1 - along) {
            const double step =
                fa / (fb - fa) * (fc / (fb - fc)) + (c - a) / (b - a) * (fa / (fc - fa)) * (fb / (fc - fb));
            if (std::isfinite(step)) next = step;
        }
        next = std::clamp(next, limit, 1 - limit);
    }
};

glm::dvec3 at(const SurfaceWay& way, double share) { return way.inside + share * (way.outside - way.inside); }

/// Finds where many ways cross; the values at their ends must be known.
class CrossingSearch {
  public:
    CrossingSearch(SolidSampler& sampler, std::span<const SurfaceWay> ways, double closeness)
        : sampler_(sampler), ways_(ways), closeness_(closeness), searches_(ways.size()) {}

    /// The interval of a way. It should have different signs at its ends; one that has not, by roundings, is
    /// left as it is.
    void begin(std::size_t way, double share, double valueInside, double valueOutside) {
        searches_[way] = {0, share, 0, usable(valueInside), usable(valueOutside), 0};
        if (countsInside(valueInside) != countsInside(valueOutside)) open_.push_back(way);
    }
    void run() {
        std::vector<double> values;
        std::vector<glm::dvec3> points;
        for (int step = 0; step < mostSteps && !open_.empty(); ++step) {
            points.clear();
            for (const std::size_t way : open_) points.push_back(at(ways_[way], searches_[way].place()));
            values.resize(points.size());
            sampler_.values(points, values);
            for (std::size_t i = 0; i < open_.size(); ++i)
                searches_[open_[i]].take(usable(values[i]), closeness_);
            std::erase_if(open_, [&](std::size_t way) { return searches_[way].settled; });
        }
    }
    const Search& operator[](std::size_t way) const { return searches_[way]; }

  private:
    SolidSampler& sampler_;
    std::span<const SurfaceWay> ways_;
    double closeness_;
    std::vector<Search> searches_;
    std::vector<std::size_t> open_;
};

/// Two directions across a way, along axes where it is along one.
std::array<glm::dvec3, 2> across(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int most = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    glm::dvec3 first(0);
    first[(most + 1) % 3] = 1;
    first = glm::normalize(first - glm::dot(first, direction) * direction);
    return {first, glm::cross(direction, first)};
}

/// Gives the crossings at jumps normals of the surface between crossings on ways beside them.
void probeNormals(SolidSampler& sampler, std::span<const SurfaceWay> ways, std::span<const std::size_t> which,
                  double closeness, std::span<SurfaceCrossing> crossings) {
    std::vector<SurfaceWay> probes;
    for (const std::size_t i : which) {
        const glm::dvec3 along = ways[i].outside - ways[i].inside;
        const double reach = probeReach * glm::length(along);
        const glm::dvec3 direction = glm::normalize(along), place = at(ways[i], crossings[i].share);
        for (const glm::dvec3& side : across(direction))
            for (const double sign : {-1.0, 1.0}) {
                const glm::dvec3 beside = place + sign * reach * side;
                probes.push_back({beside - 2 * reach * direction, beside + 2 * reach * direction});
            }
    }
    std::vector<glm::dvec3> ends;
    for (const SurfaceWay& probe : probes) {
        ends.push_back(probe.inside);
        ends.push_back(probe.outside);
    }
    std::vector<double> values(ends.size());
    sampler.values(ends, values);
    CrossingSearch search(sampler, probes, std::max(closeness, 1e-4));
    std::vector<std::uint8_t> meets(probes.size());
    for (std::size_t k = 0; k < probes.size(); ++k) {
        meets[k] = countsInside(values[2 * k]) && !countsInside(values[2 * k + 1]) ? 1 : 0;
        if (meets[k] != 0) search.begin(k, 1, values[2 * k], values[2 * k + 1]);
    }
    search.run();
    for (std::size_t n = 0; n < which.size(); ++n) {
        const glm::dvec3 direction = glm::normalize(ways[which[n]].outside - ways[which[n]].inside);
        const std::array<glm::dvec3, 2> sides = across(direction);
        glm::dvec3 normal = direction;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t low = 4 * n + 2 * side, high = low + 1;
            // A probe is four reaches long, and both are two apart; its middle is beside the crossing.
            const double before = meets[low] != 0 ? 4 * search[low].root() - 2 : 0;
            const double behind = meets[high] != 0 ? 4 * search[high].root() - 2 : 0;
            const int met = meets[low] + meets[high];
            if (met > 0) normal -= (behind - before) / met * sides[side];
        }
        crossings[which[n]].normal = glm::vec3(glm::normalize(normal));
    }
}

}  // namespace

void findCrossings(SolidSampler& sampler, std::span<const SurfaceWay> ways, double closeness,
                   std::span<SurfaceCrossing> crossings) {
    const SolidField& field = sampler.field();
    std::vector<glm::dvec3> ends;
    std::vector<double> exits(ways.size(), 1);
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (field.depth(ways[i].outside) < 0) exits[i] = field.exit(ways[i].inside, ways[i].outside);
        ends.push_back(ways[i].inside);
        ends.push_back(at(ways[i], exits[i]));
    }
    std::vector<double> values(ends.size());
    sampler.values(ends, values);
    CrossingSearch search(sampler, ways, closeness);
    for (std::size_t i = 0; i < ways.size(); ++i) {
        crossings[i] = {exits[i], {}, CrossingKind::wall};
        if (exits[i] < 1 && countsInside(values[2 * i + 1])) continue;
        crossings[i].kind = CrossingKind::surface;
        search.begin(i, exits[i], values[2 * i], values[2 * i + 1]);
    }
    search.run();
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (crossings[i].kind == CrossingKind::surface) crossings[i].share = search[i].root();
        places.push_back(at(ways[i], crossings[i].share));
    }
    std::vector<ValueAndGradient> slopes(ways.size());
    sampler.gradients(places, slopes);
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (crossings[i].kind == CrossingKind::wall) {
            crossings[i].normal = glm::vec3(field.wallNormal(places[i]));
            continue;
        }
        const glm::dvec3 slope{slopes[i].gradient[0], slopes[i].gradient[1], slopes[i].gradient[2]};
        const glm::dvec3 way = ways[i].outside - ways[i].inside;
        const double size = glm::length(slope), length = glm::length(way);
        const double change = std::abs(search[i].fb - search[i].fa),
                     passed = std::abs(search[i].b - search[i].a) * length;
        const bool usableSlope = size > 0 && std::isfinite(size);
        if (usableSlope) crossings[i].normal = glm::vec3(slope / size);
        if (usableSlope && change <= jumpFactor * size * passed + 1e-12) continue;
        crossings[i].kind = CrossingKind::jump;
        jumps.push_back(i);
    }
    if (!jumps.empty()) probeNormals(sampler, ways, jumps, closeness, crossings);
}

}  // namespace isoscope

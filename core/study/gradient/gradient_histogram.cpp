// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_histogram.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/roots/certified/certified_root_finder.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/spread_points.h"

namespace isoscope {

namespace {

constexpr std::size_t containerPoints = 16'384;
constexpr std::size_t lineCount = 6'000;
constexpr std::size_t linesAtOnce = 512;
constexpr int binCount = 40;
constexpr int mostRootsOfALine = 10;
/// The smallest values, down to nothing at a critical point, would leave no room for the others.
constexpr double cutShare = 0.01;
constexpr double narrowestSpread = 1.2;

/// The part of a line inside the domain's box and ball; nothing when near > far.
LineQuery clipped(const glm::dvec3& origin, const glm::dvec3& direction, const GradientDomain& domain) {
    LineQuery line{origin, direction, -1e300, 1e300};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (domain.box().low[axis] - origin[axis]) / direction[axis],
                     b = (domain.box().high[axis] - origin[axis]) / direction[axis];
        line.near = std::max(line.near, std::min(a, b));
        line.far = std::min(line.far, std::max(a, b));
    }
    if (domain.isBall()) {
        const glm::dvec3 way = origin - domain.ballCenter();
        const double along = glm::dot(way, direction);
        const double square = along * along - glm::dot(way, way) + domain.radius() * domain.radius();
        if (!(square > 0)) return {origin, direction, 0, -1};
        line.near = std::max(line.near, -along - std::sqrt(square));
        line.far = std::min(line.far, -along + std::sqrt(square));
    }
    return line;
}

/// Lines through a ball around the domain, all directions and offsets equally likely.
std::vector<LineQuery> randomLines(const GradientDomain& domain) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> number(0, 1);
    const glm::dvec3 center = domain.box().center();
    const double radius = glm::length(domain.box().high - domain.box().low) / 2;
    std::vector<LineQuery> lines;
    for (std::size_t i = 0; i < lineCount; ++i) {
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        const glm::dvec3 helper = std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 u = glm::normalize(glm::cross(direction, helper)), v = glm::cross(direction, u);
        const double distance = radius * std::sqrt(number(random)), angle = 2 * M_PI * number(random);
        // The origin lies outside, so that the line enters the container.
        const glm::dvec3 origin =
            center + distance * (std::cos(angle) * u + std::sin(angle) * v) - 2 * radius * direction;
        const LineQuery line = clipped(origin, direction, domain);
        if (line.near < line.far) lines.push_back(line);
    }
    return lines;
}

SpreadPoints pointsOn(const Scene& scene, const Isosurface& surface, const GradientDomain& domain,
                      const std::stop_token& stop) {
    SpreadPoints points;
    RootSettings settings = surface.rootSettings();
    settings.maxTrace = mostRootsOfALine;
    CertifiedRootFinder finder(surface.prepared(*scene.parameterTable), settings);
    const std::vector<LineQuery> lines = randomLines(domain);
    std::vector<RootList> roots(linesAtOnce);
    for (std::size_t first = 0; first < lines.size() && !stop.stop_requested(); first += linesAtOnce) {
        const std::size_t count = std::min(linesAtOnce, lines.size() - first);
        RootRequest request;
        request.stop = stop;
        finder.find(std::span(lines).subspan(first, count), request, std::span(roots).first(count));
        for (std::size_t i = 0; i < count; ++i)
            for (const Root& root : roots[i])
                if (root.kind == RootKind::crossing)
                    points.add(lines[first + i].origin + root.t * lines[first + i].direction);
    }
    return points;
}

/// Finite lengths of the gradient; the others are counted.
std::vector<double> lengthsAt(const Scene& scene, const Isosurface& surface, const SpreadPoints& points,
                              std::uint64_t& infinite) {
    std::vector<ValueAndGradient> found(points.x.size());
    GradientEvaluator(surface.prepared(*scene.parameterTable)).evaluate(points.x, points.y, points.z, found);
    std::vector<double> lengths;
    for (const ValueAndGradient& at : found) {
        if (!std::isfinite(at.value)) continue;
        const double length = slopeOf(at);
        if (std::isfinite(length))
            lengths.push_back(length);
        else
            ++infinite;
    }
    return lengths;
}

std::vector<double> edgesFor(std::vector<double> lengths) {
    std::erase_if(lengths, [](double length) { return !(length > 0); });
    if (lengths.empty()) return {};
    std::sort(lengths.begin(), lengths.end());
    double low = lengths[static_cast<std::size_t>(cutShare * static_cast<double>(lengths.size()))],
           high = lengths.back();
    if (high < low * narrowestSpread) {
        low /= std::sqrt(narrowestSpread);
        high *= std::sqrt(narrowestSpread);
    }
    std::vector<double> edges;
    for (int k = 0; k <= binCount; ++k)
        edges.push_back(low * std::pow(high / low, static_cast<double>(k) / binCount));
    return edges;
}

std::vector<double> sharesOf(const std::vector<double>& lengths, const std::vector<double>& edges) {
    std::vector<double> shares(edges.size() - 1, 0);
    for (const double length : lengths) {
        const auto next = std::upper_bound(edges.begin(), edges.end(), length);
        const auto bin = std::clamp<std::ptrdiff_t>(next - edges.begin() - 1, 0,
                                                    static_cast<std::ptrdiff_t>(shares.size()) - 1);
        shares[static_cast<std::size_t>(bin)] += 1 / static_cast<double>(lengths.size());
    }
    return shares;
}

}  // namespace

GradientHistogram gradientHistogram(const Scene& scene, std::size_t isosurface, std::stop_token stop) {
    GradientHistogram histogram;
    if (isosurface >= scene.isosurfaces.size() || !scene.isosurfaces[isosurface].shape) return histogram;
    const Isosurface& surface = *scene.isosurfaces[isosurface].shape;
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return histogram;
    const LoopStop loops(stop);
    const std::vector<double> inside =
        lengthsAt(scene, surface, spreadPoints(domain, containerPoints), histogram.infinite);
    const std::vector<double> on =
        lengthsAt(scene, surface, pointsOn(scene, surface, domain, stop), histogram.infinite);
    if (stop.stop_requested()) return {};
    std::vector<double> all = inside;
    all.insert(all.end(), on.begin(), on.end());
    histogram.edges = edgesFor(std::move(all));
    if (histogram.empty()) return histogram;
    histogram.containerSamples = inside.size();
    histogram.surfaceSamples = on.size();
    histogram.container = sharesOf(inside, histogram.edges);
    histogram.surface = sharesOf(on, histogram.edges);
    return histogram;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/line_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/view/surface_distance.h"

namespace isoscope {

double LineSamples::length() const { return glm::distance(from, to); }

std::vector<double> LineSamples::crossings(std::size_t most) const {
    std::vector<double> shares;
    for (std::size_t i = 1; i < values.size() && shares.size() < most; ++i) {
        const double a = values[i - 1], b = values[i];
        if (!std::isfinite(a) || !std::isfinite(b) || (a < 0) == (b < 0)) continue;
        shares.push_back((static_cast<double>(i) - 1 + a / (a - b)) / static_cast<double>(values.size() - 1));
    }
    return shares;
}

LineSamples sampleLine(const LineRequest& request, std::stop_token stop) {
    LineSamples line;
    line.from = request.from;
    line.to = request.to;
    const double length = line.length();
    if (!request.surface || !(length > 0) || !std::isfinite(length)) return {};
    const auto count = static_cast<std::size_t>(std::max(2, request.samples));
    std::array<std::vector<double>, 3> points;
    for (auto& coordinate : points) coordinate.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 p = line.at(static_cast<double>(i) / static_cast<double>(count - 1));
        for (int k = 0; k < 3; ++k) points[static_cast<std::size_t>(k)][i] = p[k];
    }
    const LoopStop loops(stop);
    const std::span<const double> parameters =
        request.parameterTable ? std::span<const double>(*request.parameterTable) : std::span<const double>();
    std::vector<ValueAndGradient> found(count);
    GradientEvaluator(request.surface->tape(), parameters).evaluate(points[0], points[1], points[2], found);
    if (stop.stop_requested()) return {};
    const double threshold = request.surface->settings().threshold;
    line.maxGradient = request.surface->rootSettings().maxGradient;
    for (const ValueAndGradient& at : found) {
        line.values.push_back(at.value - threshold);
        line.slopes.push_back(slopeOf(at));
        line.distances.push_back(surfaceDistance(line.values.back(), line.slopes.back()));
    }
    return line;
}

}  // namespace isoscope

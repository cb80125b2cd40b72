// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_sampler.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/view/surface_distance.h"

namespace isoscope {

namespace {

std::span<const double> parametersOf(const SectionRequest& request) {
    return request.parameterTable ? std::span<const double>(*request.parameterTable)
                                  : std::span<const double>();
}

/// Tells for many points whether they lie in the container.
class InContainer {
  public:
    explicit InContainer(const Container& container)
        : sphere_(std::get_if<ContainerSphere>(&container)), bounds_(containerBounds(container)) {}

    bool operator()(const glm::dvec3& point) const {
        if (!sphere_) return bounds_.contains(point);
        const glm::dvec3 d = point - sphere_->center;
        return glm::dot(d, d) <= sphere_->radius * sphere_->radius;
    }

  private:
    const ContainerSphere* sphere_;
    Bounds bounds_;
};

/// Of values at the places of the field.
double typicalExtent(const SectionField& field, const std::vector<float>& values) {
    std::vector<float> sizes;
    sizes.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (field.contained[i] && std::isfinite(values[i])) sizes.push_back(std::abs(values[i]));
    if (sizes.empty()) return 1;
    const auto ninth = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
    std::nth_element(sizes.begin(), ninth, sizes.end());
    return roundedUp(*ninth);
}

/// |grad f| along rows of points.
class SlopeSampler {
  public:
    SlopeSampler(const SectionRequest& request, std::size_t columns)
        : evaluator_(request.surface->tape(), parametersOf(request)), found_(columns) {}

    void sample(const std::array<std::vector<double>, 3>& points, float* out) {
        evaluator_.evaluate(points[0], points[1], points[2], found_);
        for (const ValueAndGradient& at : found_) *out++ = static_cast<float>(slopeOf(at));
    }

  private:
    GradientEvaluator evaluator_;
    std::vector<ValueAndGradient> found_;
};

/// One row of samples at a time, so that a stop request is seen soon even when f is slow.
bool fill(const SectionRequest& request, SectionField& field, std::stop_token stop) {
    const std::size_t columns = static_cast<std::size_t>(field.columns);
    std::array<std::vector<double>, 3> points;
    for (auto& coordinate : points) coordinate.resize(columns);
    std::vector<double> across(columns);
    for (std::size_t i = 0; i < columns; ++i)
        across[i] = field.left +
                    (field.right - field.left) * static_cast<double>(i) / static_cast<double>(columns - 1);

    const LoopStop loops(stop);
    PointEvaluator evaluator(request.surface->tape(), parametersOf(request));
    const double threshold = request.surface->settings().threshold;
    std::vector<double> values(columns);
    const InContainer inside(field.container);
    std::optional<SlopeSampler> slopes;
    if (!field.slopes.empty()) slopes.emplace(request, columns);
    for (int row = 0; row < field.rows; ++row) {
        if (stop.stop_requested()) return false;
        const double height = field.bottom + (field.top - field.bottom) * row / (field.rows - 1);
        for (std::size_t i = 0; i < columns; ++i) {
            const glm::dvec3 p = field.plane.at(across[i], height);
            points[0][i] = p.x, points[1][i] = p.y, points[2][i] = p.z;
        }
        evaluator.evaluate(points[0], points[1], points[2], values);
        if (slopes) slopes->sample(points, &field.slopes[static_cast<std::size_t>(row) * columns]);
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t at = static_cast<std::size_t>(row) * columns + i;
            field.values[at] = static_cast<float>(values[i] - threshold);
            if (!field.distances.empty())
                field.distances[at] =
                    static_cast<float>(surfaceDistance(values[i] - threshold, field.slopes[at]));
            field.contained[at] = inside({points[0][i], points[1][i], points[2][i]});
            if (field.contained[at] && std::isnan(field.values[at])) field.undefined = true;
        }
    }
    return !stop.stop_requested();
}

}  // namespace

SectionField sampleSection(const SectionRequest& request, std::stop_token stop) {
    SectionField field;
    if (!request.surface) return field;
    const auto begin = std::chrono::steady_clock::now();
    field.container = request.surface->settings().container;
    field.plane = request.plane;
    const SectionRectangle sides = rectangleOf(field.plane, field.container);
    field.left = sides.left;
    field.right = sides.right;
    field.bottom = sides.bottom;
    field.top = sides.top;
    const double width = field.right - field.left, height = field.top - field.bottom;
    if (!(width > 0) || !(height > 0) || !std::isfinite(width) || !std::isfinite(height)) return {};

    const int resolution = std::max(2, request.resolution);
    const double step = std::max(width, height) / (resolution - 1);
    field.columns = std::clamp(static_cast<int>(std::lround(width / step)) + 1, 2, resolution);
    field.rows = std::clamp(static_cast<int>(std::lround(height / step)) + 1, 2, resolution);
    const std::size_t count = static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
    field.values.resize(count);
    field.contained.resize(count);
    field.quantity = request.quantity;
    if (request.quantity != SectionQuantity::value) field.slopes.resize(count);
    if (request.quantity == SectionQuantity::distance) field.distances.resize(count);
    field.maxGradient = request.surface->rootSettings().maxGradient;
    if (!fill(request, field, stop)) return {};
    field.extent = typicalExtent(field, field.values);
    field.distanceExtent = typicalExtent(field, field.distances);
    for (std::size_t i = 0; i < field.slopes.size(); ++i)
        if (field.contained[i] && std::isfinite(field.slopes[i]))
            field.steepest = std::max(field.steepest, static_cast<double>(field.slopes[i]));
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    field.milliseconds = elapsed.count();
    return field;
}

}  // namespace isoscope

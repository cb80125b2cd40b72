// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/contour/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

constexpr std::size_t trianglesOfBatch = 256, samplesOfTriangle = 4;
/// Beyond the way that the tangent tells, by which it may be short.
constexpr double tangentSlack = 1.25, toleranceSlack = 0.01;
/// Ways along the triangle's normal that are tried, by the tolerance.
constexpr double probes[] = {0.25, 0.5, 1, 2, 4, 8, 16};

constexpr double unknown = std::numeric_limits<double>::infinity();

/// A place on the mesh.
struct Sample {
    glm::dvec3 point, normal;
    bool inside = false;
    double distance = unknown;  ///< the surface is no further
};

/// The samples of some triangles.
class Measuring {
  public:
    Measuring(SolidSampler& sampler, double tolerance)
        : sampler_(sampler), open_(sampler.field().open()), tolerance_(tolerance) {}

    /// A triangle, and a point of the surface that is near it.
    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& known) {
        glm::dvec3 normal = glm::cross(b - a, c - a);
        const double length = glm::length(normal);
        normal = length > 0 ? normal / length : glm::dvec3(0, 0, 1);
        for (const glm::dvec3& point : {(a + b + c) / 3.0, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
            samples_.push_back({point, normal, false, glm::distance(point, known)});
    }

    void measure() {
        followTangents();
        for (const double way : probes) {
            tryNormals(way * tolerance_);
            tryNormals(-way * tolerance_);
        }
    }

    const std::vector<Sample>& samples() const { return samples_; }

  private:
    /// Looks behind the place where the tangent of the function, or the container, ends the solid or begins
    /// it.
    void followTangents() {
        const SolidField& field = sampler_.field();
        std::vector<glm::dvec3> points;
        for (const Sample& sample : samples_)
            points.push_back(open_ ? sample.point : field.nearestInside(sample.point));
        std::vector<ValueAndGradient> slopes(points.size());
        sampler_.gradients(points, slopes);
        std::vector<glm::dvec3> behind(points.size());
        std::vector<double> ways(points.size(), unknown);
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const bool below = countsInside(slopes[i].value);
            const double depth = open_ ? unknown : field.depth(samples_[i].point);
            samples_[i].inside = below && depth >= 0;
            // The wall is as near as the sample is deep; from outside, if the solid reaches it.
            if (below) samples_[i].distance = std::min(samples_[i].distance, std::abs(depth));
            behind[i] = points[i];
            const glm::dvec3 slope(slopes[i].gradient[0], slopes[i].gradient[1], slopes[i].gradient[2]);
            const double size = glm::length(slope), way = std::abs(slopes[i].value) / size;
            if (!(size > 0) || !std::isfinite(size) || !(way < 16 * tolerance_)) continue;
            const double step = tangentSlack * way + toleranceSlack * tolerance_;
            behind[i] += (below ? step : -step) / size * slope;
            if (!samples_[i].inside && !open_) behind[i] = field.nearestInside(behind[i]);
            ways[i] = glm::distance(behind[i], samples_[i].point);
        }
        takeNearer(behind, ways);
    }

    /// What lies on the other side of the surface bounds the distance of a sample.
    void takeNearer(const std::vector<glm::dvec3>& behind, const std::vector<double>& ways) {
        std::vector<std::uint8_t> inside(behind.size());
        sampler_.inside(behind, inside, open_);
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if ((inside[i] != 0) != samples_[i].inside)
                samples_[i].distance = std::min(samples_[i].distance, ways[i]);
    }

    /// Looks along the normals of those samples that are too far off.
    void tryNormals(double way) {
        const SolidField& field = sampler_.field();
        std::vector<std::size_t> which;
        std::vector<glm::dvec3> points;
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            if (!(samples_[i].distance > std::max(tolerance_, std::abs(way)))) continue;
            which.push_back(i);
            points.push_back(samples_[i].point + way * samples_[i].normal);
            if (!samples_[i].inside && !open_) points.back() = field.nearestInside(points.back());
        }
        std::vector<std::uint8_t> inside(points.size());
        sampler_.inside(points, inside, open_);
        for (std::size_t k = 0; k < which.size(); ++k) {
            Sample& sample = samples_[which[k]];
            if ((inside[k] != 0) != sample.inside)
                sample.distance = std::min(sample.distance, glm::distance(points[k], sample.point));
        }
    }

    SolidSampler& sampler_;
    bool open_;
    double tolerance_;
    std::vector<Sample> samples_;
};

/// The furthest samples of one batch.
struct BatchResult {
    double most = 0;
    std::vector<std::uint32_t> failing;
};

}  // namespace

MeshDistance measureDistance(const PolygonMesh& mesh, double tolerance, SamplerPool& samplers,
                             WorkerPool& workers, const std::stop_token& stop) {
    const std::size_t count = mesh.mesh.triangles.size();
    std::vector<BatchResult> results((count + trianglesOfBatch - 1) / trianglesOfBatch);
    workers.run(results.size(), [&](std::size_t batch) {
        if (stop.stop_requested()) return;
        const SamplerPool::Loan sampler(samplers);
        Measuring measuring(*sampler, tolerance);
        const std::size_t first = batch * trianglesOfBatch, end = std::min(count, first + trianglesOfBatch);
        for (std::size_t t = first; t < end; ++t) {
            const Triangle& triangle = mesh.mesh.triangles[t];
            measuring.add(mesh.mesh.points[triangle[0]], mesh.mesh.points[triangle[1]],
                          mesh.mesh.points[triangle[2]], mesh.crossings[mesh.polygonOf[t]]);
        }
        measuring.measure();
        BatchResult& result = results[batch];
        for (std::size_t i = 0; i < measuring.samples().size(); ++i) {
            const double distance = measuring.samples()[i].distance;
            result.most = std::max(result.most, distance);
            if (!(distance <= tolerance))
                result.failing.push_back(mesh.polygonOf[first + i / samplesOfTriangle]);
        }
    });
    MeshDistance all;
    all.samples = samplesOfTriangle * count + mesh.offCrossing.size();
    for (std::size_t p = 0; p < mesh.offCrossing.size(); ++p) {
        all.most = std::max(all.most, mesh.offCrossing[p]);
        if (mesh.offCrossing[p] > tolerance) all.failing.push_back(static_cast<std::uint32_t>(p));
    }
    for (const BatchResult& result : results) {
        all.most = std::max(all.most, result.most);
        all.failing.insert(all.failing.end(), result.failing.begin(), result.failing.end());
    }
    std::sort(all.failing.begin(), all.failing.end());
    all.failing.erase(std::unique(all.failing.begin(), all.failing.end()), all.failing.end());
    return all;
}

}  // namespace isoscope

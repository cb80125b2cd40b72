// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/render/light/light_path.h"
#include "core/render/light/surface_points.h"
#include "core/roots/verdict.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/ray_batch.h"

namespace isoscope {

/// Some samples that go through the stages together: of the picture, or of what surfaces mirror and let
/// through. Lists keep their memory from batch to batch.
struct SampleBatch {
    /// Where the sample lies in the picture: pixels from the left and from the top, pixel centres at one
    /// half.
    struct PixelPosition {
        double x = 0, y = 0;
    };

    /// A rectangle of the picture, its sides included.
    struct Extent {
        PixelPosition low, high;

        /// Grows to hold the other rectangle too.
        void add(const Extent& other) {
            low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
            high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
        }
    };

    // Entry i of each belongs to sample i.
    std::vector<PixelPosition> places;  ///< of samples of the picture
    std::vector<glm::dvec2> lens;       ///< where they cross the lens, a disc of radius 1; empty: its middle
    std::vector<LightPath> paths;       ///< of all others; empty for samples of the picture
    std::vector<glm::dvec3> colors;     ///< in the colour space of the scene (GlobalSettings::assumedGamma)
    std::vector<Verdict> verdicts;  ///< what is certain about the hit or miss, with a certified root finder

    /// How much of what lies at the end of the ray arrives through what fills the space; empty: everything.
    std::vector<glm::dvec3> through;

    /// 1 where the background was left out of the picture (ClearBackground); else empty.
    std::vector<std::uint8_t> cleared;

    /// 1 where the surface mirrors all light by itself, so that its finish does not; may be empty.
    std::vector<std::uint8_t> mirrored;

    /// What `paths` would say of samples of the picture, weight and level; the target is the sample itself.
    LightPath cameraPath;

    // The rays of those samples that may meet something; Ray::sample says whose they are.
    RayBatch rays;
    HitBatch hits;         ///< of each ray, with the material in force
    SurfacePoints points;  ///< where they have met something
    RayBatch sight;        ///< of all samples, where a stage has asked for them (SightRays)

    /// Whether it holds samples of the picture, whose rays begin at the camera.
    bool fromCamera() const { return paths.empty(); }
    /// Samples, of which some may have no ray.
    std::size_t size() const { return fromCamera() ? places.size() : paths.size(); }
    /// What has happened on the way to this sample's ray; the same for all samples of the picture.
    const LightPath& path(std::size_t sample) const { return fromCamera() ? cameraPath : paths[sample]; }
    /// Whose colour a sample adds to.
    std::uint32_t target(std::uint32_t sample) const { return fromCamera() ? sample : paths[sample].target; }
    /// Where the ray of a sample begins, which must have one.
    glm::dvec3 origin(std::uint32_t sample) const {
        const std::uint32_t* const samples = rays.samples();
        const auto found = std::lower_bound(samples, samples + rays.size(), sample);
        return rays.ray(static_cast<std::size_t>(found - samples)).origin;
    }
    /// A batch for `places` or `paths`: no ray is sent yet, nothing is met, and the colours mean nothing
    /// before the background is laid.
    void begin() {
        colors.resize(size());
        beginUnpainted();
    }
    /// The same without colours.
    void beginUnpainted() {
        verdicts.assign(size(), Verdict::certifiedMiss);
        through.clear();
        cleared.clear();
        mirrored.clear();
        rays.clear();
        sight.clear();
        points.clear();
    }
};

}  // namespace isoscope

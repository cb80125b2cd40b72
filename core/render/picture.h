// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/render/light/secondary_rays.h"
#include "core/render/light/simple_shading.h"
#include "core/render/progressive/pixel_order.h"
#include "core/render/render_plan.h"
#include "core/render/render_request.h"
#include "core/render/render_statistics.h"
#include "core/render/stages/primary_rays.h"
#include "core/render/stages/stage.h"
#include "core/render/progressive/tile_scratch.h"

namespace isoscope {

/// How the pixels of a tile follow each other.
enum class RayOrder {
    neighbours,  ///< all of them, row by row: what POV-Ray remembers from ray to ray applies
    scattered,   ///< some of them
};

/// A request made ready: its plan, and the planned stages built and in order. Never changes while drawing, so
/// all threads share one.
class Picture {
  public:
    /// Whether the request can be drawn: it has a scene, at least one pixel, and no more than pixelLimit.
    static bool drawable(const RenderRequest& request);

    /// `request` must be drawable.
    explicit Picture(const RenderRequest& request);

    /// What was asked for, and what of it is drawn.
    const RenderRequest& request() const { return request_; }
    const RenderPlan& plan() const { return plan_; }

    /// Whether pixels depend on those drawn before them in the same tile, as they do in POV-Ray: by its
    /// memory of missed rays, and by `evaluate`. The final picture then has to be drawn tile by tile, row by
    /// row.
    bool orderMatters() const;
    /// Whether fine pixels are made of several samples, so that they differ from those of coarser passes.
    bool manySamples() const { return request_.antialias || plan_.has(StageKind::focalBlur); }
    PixelOrder pixelOrder() const { return orderMatters() ? PixelOrder::rows : PixelOrder::squares; }
    /// What drawing tiles takes; to be used with this picture only.
    TileScratch makeWork() const;
    /// Makes `work` ready for another tile. `stop` ends even the search along a single ray.
    void begin(TileScratch& work, RayOrder order, std::stop_token stop) const;
    /// Whether no ray through this part of the picture can meet anything, and all it shows is emptiness().
    /// Says no as well where what is drawn there has to be written down pixel by pixel.
    bool isEmpty(const SampleBatch::Extent& extent) const;
    /// Counts so many pixels of an empty part as drawn.
    void countEmpty(std::size_t pixels, TileScratch& work) const;
    /// A pixel of a part that is empty.
    const LinearColor& emptiness() const { return emptiness_; }
    /// Draws work.pixels into work.colors, in order, a small batch at a time; before each batch `stopped` is
    /// asked. False when it said so. `fine` pixels have focal blur and smooth edges, where the request asks
    /// for them.
    bool draw(bool fine, TileScratch& work, const std::function<bool()>& stopped) const;

    /// Statistics of nothing drawn yet: the planned stages with their reasons.
    RenderStatistics emptyStatistics() const;
    /// Adds what finished tiles (TileScratch::finish) have cost.
    void collect(const TileScratch& work, RenderStatistics& statistics) const;
    /// Adds what the last tile has shown of gradients, before the next one begins.
    void collectGradients(const TileScratch& work, RenderStatistics& statistics) const;

  private:
    void build();
    /// How pixels look where nothing is met, and the fast path: both for pictures of surfaces alone.
    void prepareEmptiness();
    bool drawBlurred(TileScratch& work, const std::function<bool()>& stopped) const;
    /// The colours of many samples, batch by batch, in the linear space, and how much of the background each
    /// shows.
    bool shade(std::span<const SampleBatch::PixelPosition> places, std::span<const glm::dvec2> lens,
               TileScratch& work, const std::function<bool()>& stopped,
               std::vector<glm::dvec4>& colors) const;
    bool drawAdaptively(TileScratch& work, const std::function<bool()>& stopped) const;
    /// The interiors around the camera.
    InteriorList aroundCamera() const;
    /// The opacity of `count` pixels from number `first` on, by the samples of the batch.
    void noteOpacity(TileScratch& work, std::size_t first, std::size_t count) const;
    /// Paints the samples of a batch, one for each of the pixels, by simpleShading_.
    void drawPlainly(TileScratch& work, std::span<LinearColor> pixels) const;
    /// Begins a batch at work.batch.places.
    void sendRays(TileScratch& work) const;
    /// False when it was stopped.
    bool runStages(TileScratch& work, const std::function<bool()>& stopped) const;
    /// After sendRays(): the stages behind it. False when it was stopped.
    bool followRays(TileScratch& work, const std::function<bool()>& stopped) const;
    void countBatch(TileScratch& work) const;
    /// After sendRays(): whether all samples show the background, as it is everywhere.
    bool showsNothing(const TileScratch& work) const { return onlySurfaces_ && work.batch.rays.empty(); }

    RenderRequest request_;
    RenderPlan plan_;
    std::unique_ptr<PrimaryRays> primaryRays_;
    std::vector<std::unique_ptr<Stage>> stages_;    ///< those behind it that run by themselves, in order
    std::unique_ptr<SecondaryRays> secondaryRays_;  ///< only where surfaces send rays
    InteriorList cameraInside_;
    bool onlySurfaces_ = false;  ///< besides them there is but an even background
    LinearColor emptiness_{};    ///< a pixel of that
    LinearColor backdrop_{};     ///< the same in the colour space of the scene
    std::optional<SimpleShading> simpleShading_;
};

/// Pictures of more pixels are refused: they would take gigabytes.
constexpr std::size_t pixelLimit = std::size_t{1} << 27;

}  // namespace isoscope

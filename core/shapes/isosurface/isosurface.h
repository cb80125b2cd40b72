// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/tape/tape.h"
#include "core/roots/line_root_finder.h"
#include "core/roots/root_settings.h"
#include "core/shapes/rays/container.h"
#include "core/shapes/rays/line_interval.h"
#include "core/shapes/shape.h"

namespace isoscope {

class FunctionKeeper;
class PreparedFunction;

/// The settings of an isosurface statement, with POV-Ray's defaults (docs/povray/isosurface.md).
struct IsosurfaceSettings : RootSettings {
    Function function;  ///< three arguments, one result
    Container container = ContainerBox{};
    /// Always the certified root finder, whatever the context says: for scene languages that have no
    /// max_gradient.
    bool certifiedOnly = false;
};

/// The region f < threshold inside a container (docs/povray/isosurface.md). Parameter values and the root
/// finder come from the TraceContext, so that a slider needs neither a new shape nor a new tape.
class Isosurface : public Shape {
  public:
    explicit Isosurface(IsosurfaceSettings settings);

    /// As given, but with the corners of the container in order.
    const IsosurfaceSettings& settings() const { return settings_; }
    /// The function, compiled once: evaluators of all threads share it.
    const std::shared_ptr<const Tape>& tape() const { return tape_; }
    /// The function made ready for its evaluators. All threads and pictures that ask with the same values of
    /// the parameters get the same; those asked for last are kept.
    std::shared_ptr<const PreparedFunction> prepared(std::span<const double> parameters) const;
    /// The settings that root finders work with: POV-Ray's defaults in the place of useless numbers.
    const RootSettings& rootSettings() const { return rootSettings_; }

    void intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const override;
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override;
    void allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const override;
    /// The container (walls included) and f, whatever `open` says; where f is NaN the answer is yes, as in
    /// POV-Ray.
    bool contains(const glm::dvec3& point, TraceContext& context) const override;
    /// The box around the container.
    Bounds bounds() const override;
    bool searchesBundles() const override { return true; }
    bool mayBeMet(const RayBundle& rays) const override;
    PrimitivePointer primitive() const override { return this; }

    /// What the Lipschitz root finder of `context` saw of this surface's gradient, for POV-Ray's warnings at
    /// the end of a picture; nothing when no ray was traced.
    std::optional<RootFinderReport> gradientReport(const TraceContext& context) const;

  private:
    LineRootFinder& finder(TraceContext& context) const;
    bool containerHolds(const glm::dvec3& point) const;
    /// Finds the roots of all rays, at least up to the first with t >= sufficient. Rays whose entry of
    /// `known` (which may be empty) lies before the container are left out.
    void search(std::span<const Ray> rays, double sufficient, std::span<const NearestHit> known,
                TraceContext& context) const;
    // nearestInBatch() by the certified method: of rays from anywhere; of shadow rays, of which hits say only
    // that something is there; and of other rays that begin on a surface.
    void findHits(const RayBatch& rays, TraceContext& context, HitBatch& hits) const;
    void block(const RayBatch& rays, TraceContext& context, HitBatch& hits) const;
    void findSecondary(const RayBatch& rays, TraceContext& context, HitBatch& hits) const;
    /// The first roots of the reversed rays, as far as `hits` reach, in the state's lines and firstRoots.
    void searchBack(const RayBatch& rays, const HitBatch& hits, TraceContext& context) const;
    /// nearest() by find(), which answers in lists: for POV-Ray's method.
    void nearestByLists(std::span<const Ray> rays, TraceContext& context,
                        std::span<NearestHit> nearest) const;

    IsosurfaceSettings settings_;
    RootSettings rootSettings_;  ///< settings_.usable()
    std::shared_ptr<const Tape> tape_;
    std::shared_ptr<const FunctionKeeper> functions_;
};

/// The shape as an isosurface; null when it is another shape, or null.
std::shared_ptr<const Isosurface> asIsosurface(const ShapePointer& shape);

}  // namespace isoscope

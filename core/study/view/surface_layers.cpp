// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/surface_layers.h"

#include <algorithm>
#include <limits>

#include "core/evaluate/tape/loop_stop.h"
#include "core/render/light/object_tracer.h"
#include "core/render/progressive/worker_pool.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

namespace {

/// Some rows of a picture on the way to their layers.
class LayerTracer {
  public:
    LayerTracer(const RenderRequest& request, int firstRow, int rows, SurfaceLayers& layers)
        : request_(request),
          firstRow_(firstRow),
          rows_(rows),
          objects_(*request.scene, [](const SceneObject& object) { return object.visible; }),
          layers_(layers) {}

    std::size_t tiles() const {
        return static_cast<std::size_t>(across() * ((rows_ + rendererTile - 1) / rendererTile));
    }

    void trace(std::size_t tile, std::stop_token stop) {
        const int left = static_cast<int>(tile) % across() * rendererTile,
                  top = static_cast<int>(tile) / across() * rendererTile;
        const int right = std::min(left + rendererTile, request_.width),
                  bottom = std::min(top + rendererTile, rows_);
        std::vector<Ray> rays;
        std::vector<std::size_t> places;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                Ray ray = pixelRay(request_, x, firstRow_ + y);
                // Beside a round picture nothing is seen.
                if (ray.direction == glm::dvec3(0)) continue;
                ray.sample = static_cast<std::uint32_t>(rays.size());
                rays.push_back(ray);
                places.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(request_.width) +
                                 static_cast<std::size_t>(x));
            }
        std::vector<NearestHit> nearest(rays.size());
        std::vector<Verdict> verdicts(rays.size(), Verdict::certifiedMiss);
        find(rays, std::move(stop), nearest, verdicts);
        for (std::size_t i = 0; i < rays.size(); ++i) keep(nearest[i], verdicts[i], places[i]);
    }

  private:
    int across() const { return (request_.width + rendererTile - 1) / rendererTile; }

    void find(std::span<const Ray> rays, std::stop_token stop, std::span<NearestHit> nearest,
              std::span<Verdict> verdicts) const {
        TraceContext context(request_.scene->parameterTable, request_.rootFinder);
        context.missMemory = request_.scene->isosurfaces.size() == 1;
        context.stop = std::move(stop);
        context.verdicts = verdicts;
        const LoopStop loops(context.stop);
        GatheredRays gathered;
        objects_.nearest(rays, context, gathered, nearest);
    }

    void keep(const NearestHit& nearest, Verdict verdict, std::size_t place) {
        if (nearest.found) {
            layers_.distance[place] = static_cast<float>(nearest.hit.t);
            for (int c = 0; c < 3; ++c)
                layers_.normal[place][static_cast<std::size_t>(c)] =
                    static_cast<float>(nearest.hit.normal[c]);
            if (verdict <= Verdict::certifiedMiss) verdict = Verdict::certifiedHit;
        }
        if (!layers_.verdict.empty()) layers_.verdict[place] = verdict;
    }

    const RenderRequest& request_;
    int firstRow_;
    int rows_;
    ObjectTracer objects_;
    SurfaceLayers& layers_;
};

}  // namespace

SurfaceLayers surfaceLayers(const RenderRequest& request, int firstRow, int rows, int threads,
                            std::stop_token stop) {
    SurfaceLayers layers;
    if (!request.scene || request.width <= 0 || rows <= 0) return layers;
    const std::size_t pixels = static_cast<std::size_t>(request.width) * static_cast<std::size_t>(rows);
    layers.distance.assign(pixels, std::numeric_limits<float>::infinity());
    layers.normal.assign(pixels, {});
    if (request.rootFinder == RootFinder::certified) layers.verdict.assign(pixels, Verdict::certifiedMiss);
    LayerTracer tracer(request, firstRow, rows, layers);
    WorkerPool(threads).run(tracer.tiles(), [&](std::size_t tile) {
        if (!stop.stop_requested()) tracer.trace(tile, stop);
    });
    return layers;
}

}  // namespace isoscope

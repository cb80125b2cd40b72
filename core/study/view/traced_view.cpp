// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/traced_view.h"

#include <algorithm>
#include <mutex>

#include "core/evaluate/tape/loop_stop.h"
#include "core/render/light/object_tracer.h"
#include "core/render/picture.h"
#include "core/render/progressive/worker_pool.h"

namespace isoscope {

namespace {

struct TileRectangle {
    int left, top, right, bottom;
};

void traceTile(const RenderRequest& request, const ObjectTracer& objects, const TileRectangle& tile,
               TraceContext& context, TracedView& view) {
    std::vector<Ray> rays;
    for (int y = tile.top; y < tile.bottom; ++y)
        for (int x = tile.left; x < tile.right; ++x) rays.push_back(pixelRay(request, x, y));
    std::vector<NearestHit> nearest(rays.size());
    GatheredRays gathered;
    objects.nearest(rays, context, gathered, nearest);
    std::size_t next = 0;
    for (int y = tile.top; y < tile.bottom; ++y)
        for (int x = tile.left; x < tile.right; ++x) {
            const NearestHit& hit = nearest[next++];
            view.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
                        static_cast<std::size_t>(x)] = {hit.found, hit.hit.kind, hit.hit.t};
        }
}

}  // namespace

Ray pixelRay(const RenderRequest& request, int x, int y) {
    return request.camera.ray((x + 0.5) / request.width - 0.5, 0.5 - (y + 0.5) / request.height);
}

TracedView traceView(const RenderRequest& request, int threads, std::stop_token stop,
                     const ShareReport& report, int tileSize) {
    TracedView view;
    tileSize = std::max(1, tileSize);
    if (!Picture::drawable(request)) return view;
    view.width = request.width;
    view.height = request.height;
    view.pixels.resize(static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height));
    const Scene& scene = *request.scene;
    view.steepestOf.resize(scene.isosurfaces.size());
    const ObjectTracer objects(scene, [](const SceneObject& object) { return object.visible; });
    const int across = (request.width + tileSize - 1) / tileSize,
              down = (request.height + tileSize - 1) / tileSize;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::size_t tilesDone = 0;
    std::mutex sumMutex;
    WorkerPool(threads).run(tiles, [&](std::size_t index) {
        if (stop.stop_requested()) return;
        const int left = static_cast<int>(index) % across * tileSize,
                  top = static_cast<int>(index) / across * tileSize;
        const TileRectangle tile{left, top, std::min(left + tileSize, request.width),
                                 std::min(top + tileSize, request.height)};
        TraceContext context(scene.parameterTable, request.rootFinder);
        context.missMemory = scene.isosurfaces.size() == 1;
        context.stop = stop;
        const LoopStop loops(stop);
        const double begin = threadCpuSeconds();
        traceTile(request, objects, tile, context, view);
        const double seconds = threadCpuSeconds() - begin;
        const std::lock_guard lock(sumMutex);
        view.cpuSeconds += seconds;
        view.evaluations += context.evaluations;
        for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i)
            if (scene.isosurfaces[i].shape)
                if (const auto seen = scene.isosurfaces[i].shape->gradientReport(context)) {
                    view.steepestOf[i] = std::max(view.steepestOf[i], seen->steepest);
                    view.steepest = std::max(view.steepest, seen->steepest);
                }
        if (report) report(static_cast<double>(++tilesDone) / static_cast<double>(tiles));
    });
    view.complete = !stop.stop_requested();
    return view;
}

}  // namespace isoscope

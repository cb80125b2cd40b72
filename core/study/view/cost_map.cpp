// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/cost_map.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <mutex>
#include <numeric>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/render/light/object_tracer.h"
#include "core/render/picture.h"
#include "core/render/progressive/worker_pool.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/shapes/rays/line_interval.h"
#include "core/study/view/container_fit.h"
#include "core/study/view/explained_search.h"
#include "core/study/view/ray_enclosures.h"

namespace isoscope {

namespace {

/// A surface that is nearer than this share of its own extent counts as near.
constexpr double nearShare = 0.05;
/// A ray within about 15 degrees of the surface runs along it.
constexpr double grazingCosine = 0.25;
/// Steps this many times shorter than the way to the surface are owed to a slope that is not there.
constexpr double shortStep = 4;
/// A change of f this many times larger than any slope around explains is a jump.
constexpr double jumpFactor = 4;
/// Places of a step that are looked at: beside it, at its ends, in its middle.
constexpr std::size_t lookedAt = 5;

/// Where an isosurface can be: the smallest container that is proven to show the same.
struct Whereabouts {
    Container container;
    bool nowhere = false;
    double extent = 1;  ///< in the coordinates of the function
};

Whereabouts whereaboutsOf(const std::shared_ptr<const Isosurface>& surface,
                          std::span<const double> parameters, const std::stop_token& stop) {
    const ContainerFit fit = fitContainer(surface, parameters, ReachSettings{}, stop);
    Whereabouts there{fit.best().value_or(surface->settings().container), fit.empty, 1};
    if (const auto* box = std::get_if<ContainerBox>(&there.container))
        there.extent = glm::distance(box->low, box->high) / std::sqrt(3.0);
    else
        there.extent = 2 * std::get<ContainerSphere>(there.container).radius;
    return there;
}

LineInterval intervalIn(const Container& container, const Ray& ray) {
    if (const auto* box = std::get_if<ContainerBox>(&container)) return boxInterval(ray, box->low, box->high);
    const auto& sphere = std::get<ContainerSphere>(container);
    return sphereInterval(ray, sphere.center, sphere.radius);
}

/// A piece of a ray that the root finder has settled.
struct Step {
    double begin, end;
};

/// Tells the causes of the steps along rays through one isosurface. One for each thread.
class CauseFinder {
  public:
    CauseFinder(const SceneIsosurface& placed, const std::shared_ptr<const PreparedFunction>& function,
                const Whereabouts& there, RootFinder finder)
        : placed_(placed),
          there_(there),
          settings_(placed.shape->rootSettings()),
          function_(function),
          finder_(placed.shape->settings().certifiedOnly ? RootFinder::certified : finder),
          field_(function),
          gradients_(function) {}

    /// Adds the steps along a ray of the world.
    void add(const Ray& worldRay, CauseCounts& counts) {
        const Ray ray = placed_.transform.toObject(worldRay);
        const LineInterval inside = intervalIn(placed_.shape->settings().container, ray);
        const double near = std::max(0.0, inside.range.near);
        if (!(near < inside.range.far) || !std::isfinite(inside.range.far)) return;
        const LineQuery line{ray.origin, ray.direction, near, inside.range.far};
        takeSteps(line);
        look(line);
        const LineInterval worthwhile = intervalIn(there_.container, ray);
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const double middle = (steps_[i].begin + steps_[i].end) / 2;
            const bool inVain =
                there_.nowhere || !(middle >= worthwhile.range.near && middle <= worthwhile.range.far);
            ++counts[static_cast<std::size_t>(inVain ? CostCause::emptySpace : causeOf(i, line))];
        }
    }

  private:
    void takeSteps(const LineQuery& line) {
        steps_.clear();
        if (finder_ == RootFinder::certified) {
            for (const RayEnclosure& piece : encloseRay(function_, settings_, line))
                steps_.push_back({piece.begin, piece.end});
            return;
        }
        const ExplainedSearch search = explainSearch(line, settings_, [&](double t) {
            const glm::dvec3 p = line.origin + t * line.direction;
            double value = 0;
            field_.values(std::span(&p.x, 1), std::span(&p.y, 1), std::span(&p.z, 1), std::span(&value, 1));
            return value;
        });
        for (const SearchedInterval& interval : search.intervals)
            steps_.push_back({interval.low, interval.high});
    }

    void look(const LineQuery& line) {
        for (auto& coordinate : places_) coordinate.clear();
        for (const Step& step : steps_) {
            const double length = step.end - step.begin;
            for (const double share : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
                const double t = std::clamp(step.begin + share * length, line.near, line.far);
                const glm::dvec3 p = line.origin + t * line.direction;
                for (int axis = 0; axis < 3; ++axis)
                    places_[static_cast<std::size_t>(axis)].push_back(p[axis]);
            }
        }
        found_.resize(places_[0].size());
        gradients_.evaluate(places_[0], places_[1], places_[2], found_);
    }

    CostCause causeOf(std::size_t index, const LineQuery& line) const {
        const std::span at = std::span(found_).subspan(index * lookedAt, lookedAt);
        const double length = steps_[index].end - steps_[index].begin;
        const double speed = glm::length(line.direction);
        double steepest = 0;
        for (const ValueAndGradient& one : at) {
            const double slope = slopeOf(one);
            if (!std::isfinite(one.value) || !std::isfinite(slope)) return CostCause::singularity;
            steepest = std::max(steepest, slope * speed);
        }
        // Rounding alone is no jump.
        const double change = std::abs(at.back().value - at.front().value);
        if (change > jumpFactor * steepest * 3 * length + 1e-9 * (1 + std::abs(at.front().value)))
            return CostCause::singularity;
        // Farther from the threshold on either side of it than around: a pole.
        const auto off = [&](std::size_t i) { return at[i].value - settings_.threshold; };
        if (off(1) * off(3) < 0 && std::abs(off(1)) > std::abs(off(0)) && std::abs(off(3)) > std::abs(off(4)))
            return CostCause::singularity;
        const ValueAndGradient& here = at[lookedAt / 2];
        const glm::dvec3 gradient(here.gradient[0], here.gradient[1], here.gradient[2]);
        const double slope = glm::length(gradient);
        const double away = std::abs(here.value - settings_.threshold);
        const double toSurface = away / std::max(slope * speed, 1e-300);
        if (toSurface * speed <= nearShare * there_.extent &&
            std::abs(glm::dot(gradient, line.direction)) < grazingCosine * slope * speed)
            return CostCause::grazingRay;
        return toSurface > shortStep * length ? CostCause::steepField : CostCause::surface;
    }

    const SceneIsosurface& placed_;
    const Whereabouts& there_;
    const RootSettings& settings_;
    std::shared_ptr<const PreparedFunction> function_;
    RootFinder finder_;
    TapeField field_;
    GradientEvaluator gradients_;
    std::vector<Step> steps_;
    std::array<std::vector<double>, 3> places_;
    std::vector<ValueAndGradient> found_;
};

/// `evaluations` in the proportions of `steps`, in whole numbers that add up.
CauseCounts shareOut(std::uint64_t evaluations, const CauseCounts& steps) {
    CauseCounts shares{};
    const std::uint64_t all = std::accumulate(steps.begin(), steps.end(), std::uint64_t{0});
    if (all == 0) {
        shares[static_cast<std::size_t>(CostCause::emptySpace)] = evaluations;
        return shares;
    }
    // Each takes up to where its end lies, so that nothing is lost to rounding.
    std::uint64_t passed = 0, given = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        passed += steps[i];
        const auto end = static_cast<std::uint64_t>(std::llround(
            static_cast<double>(evaluations) * static_cast<double>(passed) / static_cast<double>(all)));
        shares[i] = end - given;
        given = end;
    }
    return shares;
}

/// Traces one tile of a map.
class TileCounter {
  public:
    TileCounter(const RenderRequest& request, const ObjectTracer& objects, std::span<const Whereabouts> there,
                const std::stop_token& stop)
        : request_(request),
          objects_(objects),
          stop_(stop),
          context_(request.scene->parameterTable, request.rootFinder) {
        context_.missMemory = request.scene->isosurfaces.size() == 1;
        context_.stop = stop;
        const Scene& scene = *request.scene;
        for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i)
            if (const auto& shape = scene.isosurfaces[i].shape)
                finders_.emplace_back(scene.isosurfaces[i], shape->prepared(*scene.parameterTable), there[i],
                                      request.rootFinder);
    }

    CauseCounts pixel(int x, int y) {
        const Ray ray = pixelRay(request_, x, y);
        const std::uint64_t before = context_.evaluations;
        NearestHit nearest;
        objects_.nearest(std::span(&ray, 1), context_, gathered_, std::span(&nearest, 1));
        const std::uint64_t spent = context_.evaluations - before;
        CauseCounts steps{};
        if (spent > 0 && !stop_.stop_requested())
            for (CauseFinder& finder : finders_) finder.add(ray, steps);
        return shareOut(spent, steps);
    }

  private:
    const RenderRequest& request_;
    const ObjectTracer& objects_;
    const std::stop_token& stop_;
    TraceContext context_;
    GatheredRays gathered_;
    std::deque<CauseFinder> finders_;
};

void addUp(CostMap& map) {
    for (const CauseCounts& pixel : map.pixels) {
        for (std::size_t i = 0; i < pixel.size(); ++i) map.totals[i] += pixel[i];
        map.dearest = std::max(map.dearest, std::accumulate(pixel.begin(), pixel.end(), std::uint64_t{0}));
    }
}

}  // namespace

std::string_view name(CostCause cause) {
    switch (cause) {
        case CostCause::emptySpace: return "empty space";
        case CostCause::surface: return "surface";
        case CostCause::steepField: return "steep field";
        case CostCause::grazingRay: return "grazing ray";
        case CostCause::singularity: return "singularity";
    }
    return {};
}

std::uint64_t CostMap::evaluations() const {
    return std::accumulate(totals.begin(), totals.end(), std::uint64_t{0});
}

CostMap costMap(const RenderRequest& request, int threads, std::stop_token stop, const ShareReport& report) {
    CostMap map;
    if (!Picture::drawable(request)) return map;
    map.width = request.width;
    map.height = request.height;
    map.pixels.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    const ObjectTracer objects(*request.scene, [](const SceneObject& object) { return object.visible; });
    std::vector<Whereabouts> there;
    for (const SceneIsosurface& placed : request.scene->isosurfaces)
        there.push_back(placed.shape ? whereaboutsOf(placed.shape, *request.scene->parameterTable, stop)
                                     : Whereabouts{});
    const int across = (map.width + rendererTile - 1) / rendererTile,
              down = (map.height + rendererTile - 1) / rendererTile;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::size_t tilesDone = 0;
    std::mutex reportMutex;
    WorkerPool(threads).run(tiles, [&](std::size_t index) {
        if (stop.stop_requested()) return;
        const LoopStop loops(stop);
        TileCounter counter(request, objects, there, stop);
        const int left = static_cast<int>(index) % across * rendererTile,
                  top = static_cast<int>(index) / across * rendererTile;
        for (int y = top; y < std::min(top + rendererTile, map.height); ++y)
            for (int x = left; x < std::min(left + rendererTile, map.width); ++x) {
                if (stop.stop_requested()) return;
                map.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                           static_cast<std::size_t>(x)] = counter.pixel(x, y);
            }
        const std::lock_guard lock(reportMutex);
        if (report) report(static_cast<double>(++tilesDone) / static_cast<double>(tiles));
    });
    addUp(map);
    map.complete = !stop.stop_requested();
    return map;
}

std::array<float, 3> costColor(CostCause cause) {
    switch (cause) {
        case CostCause::emptySpace: return {0.05f, 0.19f, 0.62f};
        case CostCause::surface: return {0.45f, 0.45f, 0.45f};
        case CostCause::steepField: return {0.80f, 0.09f, 0.05f};
        case CostCause::grazingRay: return {0.92f, 0.68f, 0.02f};
        case CostCause::singularity: return {0.72f, 0.16f, 0.80f};
    }
    return {};
}

Image picture(const CostMap& map) {
    constexpr double faintest = 0.08;
    Image image(map.width, map.height);
    const double top = std::log1p(static_cast<double>(std::max<std::uint64_t>(1, map.dearest)));
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const auto all = static_cast<double>(
            std::accumulate(map.pixels[i].begin(), map.pixels[i].end(), std::uint64_t{0}));
        if (all == 0) continue;
        const double bright = faintest + (1 - faintest) * std::log1p(all) / top;
        for (std::size_t cause = 0; cause < costCauseCount; ++cause) {
            const auto color = costColor(static_cast<CostCause>(cause));
            const double part = bright * static_cast<double>(map.pixels[i][cause]) / all;
            for (std::size_t k = 0; k < 3; ++k) image.pixels[i][k] += static_cast<float>(part) * color[k];
        }
    }
    return image;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/roots/certified_root_finder.h"
#include "core/roots/lipschitz_root_finder.h"
#include "core/roots/tape_field.h"
#include "core/shapes/hit_list.h"

namespace isoscope {

namespace {

/// What one isosurface keeps in a context: its root finders, made when first asked for, and memory that would
/// otherwise be allocated anew for each batch.
class IsosurfaceState : public ShapeState {
  public:
    std::array<std::unique_ptr<LineRootFinder>, 2> finders;
    std::vector<LineQuery> queries;
    std::vector<LineInterval> inside;
    std::vector<RootList> roots;

    /// Room for `count` lines; the lists keep what they have allocated.
    void prepare(std::size_t count) {
        queries.assign(count, {});
        inside.resize(count);
        if (roots.size() < count) roots.resize(count);
    }
};

IsosurfaceState& stateOf(const Isosurface& surface, TraceContext& context) {
    return context.state<IsosurfaceState>(&surface, [] { return std::make_unique<IsosurfaceState>(); });
}

/// The one place that knows which root finders there are.
std::unique_ptr<LineRootFinder> makeFinder(RootFinder kind, const Isosurface& surface,
                                           std::span<const double> parameters) {
    if (kind == RootFinder::certified)
        return std::make_unique<CertifiedRootFinder>(surface.tape(), parameters, surface.rootSettings());
    auto field = std::make_unique<TapeField>(surface.tape(), parameters);
    return std::make_unique<LipschitzRootFinder>(std::move(field), surface.rootSettings());
}

Container sorted(const Container& container) {
    if (const auto* box = std::get_if<ContainerBox>(&container))
        return ContainerBox{glm::min(box->low, box->high), glm::max(box->low, box->high)};
    const auto& sphere = std::get<ContainerSphere>(container);
    return ContainerSphere{sphere.center, std::abs(sphere.radius)};
}

constexpr double allRoots = std::numeric_limits<double>::infinity();

HitKind hitKind(RootKind kind) {
    switch (kind) {
        case RootKind::crossing:
            return HitKind::crossing;
        case RootKind::entryWall:
        case RootKind::exitWall:
            return HitKind::container;
        case RootKind::jump:
            return HitKind::jump;
        case RootKind::pole:
            return HitKind::pole;
        case RootKind::gap:
            return HitKind::gap;
    }
    return HitKind::crossing;
}

}  // namespace

Isosurface::Isosurface(IsosurfaceSettings settings) : settings_(std::move(settings)) {
    settings_.container = sorted(settings_.container);
    rootSettings_.threshold = settings_.threshold;
    rootSettings_.accuracy = settings_.accuracy;
    rootSettings_.maxGradient = settings_.maxGradient;
    rootSettings_.open = settings_.open;
    rootSettings_.maxTrace = settings_.maxTrace;
    rootSettings_.positivePolarity = settings_.positivePolarity;
    rootSettings_.evaluate = settings_.evaluate;
    rootSettings_ = rootSettings_.usable();
    tape_ = Tape::compile(settings_.function);
}

LineRootFinder& Isosurface::finder(TraceContext& context) const {
    std::unique_ptr<LineRootFinder>& slot =
        stateOf(*this, context).finders[static_cast<std::size_t>(context.rootFinder)];
    if (!slot) slot = makeFinder(context.rootFinder, *this, context.parameters());
    return *slot;
}

LineInterval Isosurface::containerInterval(const Ray& ray) const {
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container))
        return boxInterval(ray, box->low, box->high);
    const auto& sphere = std::get<ContainerSphere>(settings_.container);
    return sphereInterval(ray, sphere.center, sphere.radius);
}

bool Isosurface::containerHolds(const glm::dvec3& point) const {
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container))
        return Bounds{box->low, box->high}.contains(point);
    const auto& sphere = std::get<ContainerSphere>(settings_.container);
    return glm::distance(point, sphere.center) <= sphere.radius;
}

std::vector<Isosurface::FoundHit> Isosurface::search(std::span<const Ray> rays, double sufficient,
                                                     std::span<const NearestHit> known,
                                                     TraceContext& context) const {
    IsosurfaceState& state = stateOf(*this, context);
    state.prepare(rays.size());
    std::vector<LineInterval>& inside = state.inside;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        inside[i] = containerInterval(rays[i]);
        const double near = std::max(inside[i].range.near, 0.0);
        if (!known.empty() && known[i].found && known[i].hit.t < near) continue;
        state.queries[i] = {rays[i].origin, rays[i].direction, near, inside[i].range.far};
    }
    LineRootFinder& rootFinder = finder(context);
    const std::uint64_t evaluationsBefore = rootFinder.report().evaluations;
    const std::span<RootList> roots = std::span(state.roots).first(rays.size());
    rootFinder.find(state.queries, {sufficient, context.missMemory && !context.shadowRay, context.stop},
                    roots);

    std::vector<FoundHit> found;
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (const Root& root : roots[i]) {
            Hit hit{root.t, rays[i].at(root.t), {1, 0, 0}, noMaterial, hitKind(root.kind)};
            if (root.kind == RootKind::entryWall) hit.normal = inside[i].nearNormal;
            if (root.kind == RootKind::exitWall) hit.normal = inside[i].farNormal;
            found.push_back({i, hit});
        }
    if (!context.shadowRay) addNormals(rootFinder, found);
    context.rays += rays.size();
    context.evaluations += rootFinder.report().evaluations - evaluationsBefore;
    return found;
}

void Isosurface::addNormals(LineRootFinder& finder, std::vector<FoundHit>& found) {
    std::vector<std::size_t> wanting;
    std::vector<glm::dvec3> points;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (found[k].hit.kind == HitKind::container) continue;
        wanting.push_back(k);
        points.push_back(found[k].hit.point);
    }
    std::vector<glm::dvec3> normals(points.size());
    finder.normals(points, normals);
    for (std::size_t k = 0; k < wanting.size(); ++k) found[wanting[k]].hit.normal = unitNormal(normals[k]);
}

void Isosurface::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    for (const FoundHit& found : search(std::span(&ray, 1), allRoots, {}, context))
        if (interval.near <= found.hit.t && found.hit.t <= interval.far) hits.push_back(found.hit);
}

void Isosurface::nearest(std::span<const Ray> rays, TraceContext& context,
                         std::span<NearestHit> nearest) const {
    for (const FoundHit& found : search(rays, context.nearLimit, nearest, context))
        if (found.hit.t >= context.nearLimit) offer(found.hit, nearest[found.ray]);
}

void Isosurface::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    for (HitList& list : hits) list.clear();
    for (const FoundHit& found : search(rays, allRoots, {}, context)) hits[found.ray].push_back(found.hit);
}

bool Isosurface::contains(const glm::dvec3& point, TraceContext& context) const {
    if (!containerHolds(point)) return false;
    ++context.evaluations;
    return !(rootSettings_.signedValue(finder(context).value(point)) > 0);
}

Bounds Isosurface::bounds() const {
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container)) return {box->low, box->high};
    const auto& sphere = std::get<ContainerSphere>(settings_.container);
    return {sphere.center - sphere.radius, sphere.center + sphere.radius};
}

std::optional<GradientReport> Isosurface::gradientReport(const TraceContext& context) const {
    const auto* state = static_cast<const IsosurfaceState*>(context.find(this));
    if (state == nullptr) return {};
    const auto& finder = state->finders[static_cast<std::size_t>(RootFinder::lipschitz)];
    if (!finder || finder->report().searches == 0) return {};
    const RootFinderReport report = finder->report();
    return GradientReport{report.maxGradient, report.steepest, report.searches, report.exhausted};
}

}  // namespace isoscope

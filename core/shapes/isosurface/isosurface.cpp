// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/evaluate/function_keeper.h"
#include "core/roots/cells/point_membership.h"
#include "core/roots/certified/certified_root_finder.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/shapes/isosurface/secondary_lines.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/rays/hit_list.h"
#include "core/shapes/rays/ray_batch.h"
#include "core/shapes/rays/ray_bundle.h"

namespace isoscope {

namespace {

/// What one isosurface keeps in a context: its root finders and its point membership, made when first asked
/// for, and memory that would otherwise be allocated anew for each batch.
class IsosurfaceState : public ShapeState {
  public:
    std::array<std::unique_ptr<LineRootFinder>, 2> finders;
    std::optional<PointMembership> membership;
    ContainerPassages passages;
    std::vector<LineQuery> queries;
    std::vector<RootList> roots;
    std::vector<Hit*> wanting;  ///< a normal, here or in the caller's lists
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> normals;
    // Of rays and hits in columns.
    FirstRoots firstRoots;
    std::array<AlignedColumn, 3> wallNormals;
    SecondaryLines lines;
    std::vector<std::uint8_t> meets;
    std::vector<std::uint32_t> meeting;         ///< rays that meet something on the way back
    std::size_t sentBack = 0, settledBack = 0;  ///< secondary rays since the restart
    RayBatch meetingRays;
    HitBatch meetingHits;
    RayBatch batch;
    HitBatch hits;

    /// Rays that meet something on the way back are searched twice.
    bool wayBackPays() const { return sentBack < 256 || 2 * settledBack > sentBack; }

    /// Room for `count` lines; the lists keep what they have allocated.
    void prepare(std::size_t count) {
        queries.resize(count);
        if (roots.size() < count) roots.resize(count);
        wanting.clear();
    }

    void restart() override {
        for (const auto& finder : finders)
            if (finder) finder->restart();
        sentBack = settledBack = 0;
    }
};

IsosurfaceState& stateOf(const Isosurface& surface, TraceContext& context) {
    return context.state<IsosurfaceState>(&surface, [] { return std::make_unique<IsosurfaceState>(); });
}

/// The one place that knows which root finders there are.
std::unique_ptr<LineRootFinder> makeFinder(RootFinder kind, const Isosurface& surface,
                                           std::span<const double> parameters) {
    std::shared_ptr<const PreparedFunction> function = surface.prepared(parameters);
    if (kind == RootFinder::certified)
        return std::make_unique<CertifiedRootFinder>(std::move(function), surface.rootSettings());
    auto field = std::make_unique<TapeField>(std::move(function));
    return std::make_unique<LipschitzRootFinder>(std::move(field), surface.rootSettings());
}

/// Charges a context with the evaluations of a finder during its life.
class EvaluationMeter {
  public:
    EvaluationMeter(const LineRootFinder& finder, TraceContext& context)
        : finder_(finder), context_(context), before_(finder.report().evaluations) {}
    ~EvaluationMeter() { context_.evaluations += finder_.report().evaluations - before_; }
    EvaluationMeter(const EvaluationMeter&) = delete;
    EvaluationMeter& operator=(const EvaluationMeter&) = delete;

  private:
    const LineRootFinder& finder_;
    TraceContext& context_;
    std::uint64_t before_;
};

Container sorted(const Container& container) {
    if (const auto* box = std::get_if<ContainerBox>(&container))
        return ContainerBox{glm::min(box->low, box->high), glm::max(box->low, box->high)};
    const auto& sphere = std::get<ContainerSphere>(container);
    return ContainerSphere{sphere.center, std::abs(sphere.radius)};
}

/// Whether eight verdicts that follow each other are certain hits or misses.
bool allCertain(const Verdict* verdicts) {
    static_assert(sizeof(Verdict) == 1 && static_cast<int>(Verdict::certifiedHit) == 0 &&
                  static_cast<int>(Verdict::certifiedMiss) == 1);
    std::uint64_t eight;
    std::memcpy(&eight, verdicts, sizeof eight);
    return (eight & 0xfefefefefefefefe) == 0;
}

/// Tells the samples of the rays, sampleOf(0) and so on, what the search that has just ended is certain of.
template <class SampleOf>
void noteVerdicts(SampleOf sampleOf, const LineRootFinder& finder, TraceContext& context) {
    if (context.verdicts.empty() || context.shadowRay || context.rootFinder != RootFinder::certified) return;
    const std::span<const Verdict> found = finder.verdicts();
    for (std::size_t i = 0; i < found.size(); ++i) {
        while (i + 8 <= found.size() && allCertain(&found[i])) i += 8;
        // As all verdicts begin.
        if (i == found.size()) break;
        if (found[i] <= Verdict::certifiedMiss || sampleOf(i) >= context.verdicts.size()) continue;
        Verdict& worst = context.verdicts[sampleOf(i)];
        worst = std::max(worst, found[i]);
    }
}

constexpr double allRoots = std::numeric_limits<double>::infinity();

/// The hits wait for their normals, if they need any.
void wantNormals(std::span<Hit> hits, IsosurfaceState& state) {
    for (Hit& hit : hits)
        if (hit.kind != HitKind::container) state.wanting.push_back(&hit);
}

/// Sets the normals of the hits that wait.
void addNormals(LineRootFinder& finder, IsosurfaceState& state, const std::stop_token& stop) {
    state.points.clear();
    for (const Hit* hit : state.wanting) state.points.push_back(hit->point);
    state.normals.assign(state.points.size(), glm::dvec3(1, 0, 0));
    finder.computeNormals(state.points, stop, state.normals);
    for (std::size_t k = 0; k < state.wanting.size(); ++k)
        state.wanting[k]->normal = unitNormal(state.normals[k]);
}

HitKind hitKind(RootKind kind) {
    switch (kind) {
        case RootKind::crossing: return HitKind::crossing;
        case RootKind::entryWall:
        case RootKind::exitWall: return HitKind::container;
        case RootKind::jump: return HitKind::jump;
        case RootKind::pole: return HitKind::pole;
    }
    return HitKind::crossing;
}

void takeCrossings(HitBatch::Table& found, HitBatch& hits) {
    if (hits.takeWhole(found, HitKind::crossing)) return;
    hits.take({found.size(),
               found[FirstRoots::t],
               {found[FirstRoots::normalX], found[FirstRoots::normalY], found[FirstRoots::normalZ]}},
              HitKind::crossing);
}

/// Makes `hit` that of ray number `i` at a root; a crossing has no normal yet.
void setHit(const Container& container, const ContainerPassages& passages, const Ray& ray, std::size_t i,
            const Root& root, Hit& hit) {
    hit.t = root.t;
    hit.point = ray.at(root.t);
    hit.material = noMaterial;
    hit.kind = hitKind(root.kind);
    hit.normal = hit.kind == HitKind::container
                     ? passages.wallNormal(container, ray, i, root.kind == RootKind::entryWall)
                     : glm::dvec3(1, 0, 0);
}

}  // namespace

Isosurface::Isosurface(IsosurfaceSettings settings) : settings_(std::move(settings)) {
    settings_.container = sorted(settings_.container);
    rootSettings_ = settings_.usable();
    const Bounds reach = bounds();
    rootSettings_.region = LineRegion{reach.low, reach.high};
    tape_ = Tape::compile(settings_.function);
    functions_ = std::make_shared<const FunctionKeeper>(tape_);
}

std::shared_ptr<const PreparedFunction> Isosurface::prepared(std::span<const double> parameters) const {
    return functions_->prepared(parameters);
}

LineRootFinder& Isosurface::finder(TraceContext& context) const {
    const RootFinder kind = settings_.certifiedOnly ? RootFinder::certified : context.rootFinder;
    std::unique_ptr<LineRootFinder>& slot = stateOf(*this, context).finders[static_cast<std::size_t>(kind)];
    if (!slot) slot = makeFinder(kind, *this, context.parameters());
    return *slot;
}

bool Isosurface::containerHolds(const glm::dvec3& point) const {
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container))
        return Bounds{box->low, box->high}.contains(point);
    const auto& sphere = std::get<ContainerSphere>(settings_.container);
    return glm::distance(point, sphere.center) <= sphere.radius;
}

void Isosurface::search(std::span<const Ray> rays, double sufficient, std::span<const NearestHit> known,
                        TraceContext& context) const {
    IsosurfaceState& state = stateOf(*this, context);
    state.prepare(rays.size());
    state.passages.find(settings_.container, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RayInterval inside = state.passages.range(i);
        const double near = std::max(inside.near, 0.0);
        const bool hidden = !known.empty() && known[i].found && known[i].hit.t < near;
        state.queries[i] =
            hidden ? LineQuery()
                   : LineQuery{rays[i].origin, rays[i].direction, near, inside.far, context.nearLimit};
    }
    LineRootFinder& rootFinder = finder(context);
    rootFinder.find(state.queries, {sufficient, context.missMemory && !context.shadowRay, context.stop},
                    std::span(state.roots).first(rays.size()));
    noteVerdicts([&](std::size_t i) { return rays[i].sample; }, rootFinder, context);
    context.rays += rays.size();
}

void Isosurface::intersect(const Ray& ray, RayInterval interval, TraceContext& context, HitList& hits) const {
    const EvaluationMeter meter(finder(context), context);
    search({&ray, 1}, allRoots, {}, context);
    IsosurfaceState& state = stateOf(*this, context);
    const std::size_t first = hits.size();
    for (const Root& root : state.roots[0])
        if (interval.near <= root.t && root.t <= interval.far)
            setHit(settings_.container, state.passages, ray, 0, root, hits.emplace_back());
    if (context.shadowRay) return;
    wantNormals(std::span(hits).subspan(first), state);
    addNormals(finder(context), state, context.stop);
}

void Isosurface::searchBack(const RayBatch& rays, const HitBatch& hits, TraceContext& context) const {
    IsosurfaceState& state = stateOf(*this, context);
    state.passages.find(settings_.container, rays);
    state.lines.reverse(rays, state.passages, context.nearLimit, hits[HitBatch::t]);
    finder(context).findFirst(state.lines.columns(), {0, false, context.stop}, state.firstRoots);
    context.rays += rays.size();
    // Where a line ends inside the container there is no wall.
    std::erase_if(state.firstRoots.exitWalls, [&](std::size_t i) { return !state.lines.endsAtWall(i); });
    std::erase_if(state.firstRoots.others, [&](const FirstRoots::Other& other) {
        return other.root.kind == RootKind::exitWall && !state.lines.endsAtWall(other.line);
    });
}

/// Any hit will do.
void Isosurface::block(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    searchBack(rays, hits, context);
    const IsosurfaceState& state = stateOf(*this, context);
    const FirstRoots& found = state.firstRoots;
    const LineColumns lines = state.lines.columns();
    const auto set = [&](std::size_t i, double place, HitKind kind) {
        if (const double t = state.lines.onRay(i, place); t < hits[HitBatch::t][i])
            hits.set(i, t, glm::dvec3(1, 0, 0), kind, noMaterial);
    };
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (found.crossings[FirstRoots::t][i] < FirstRoots::none)
            set(i, found.crossings[FirstRoots::t][i], HitKind::crossing);
    for (const std::size_t i : found.entryWalls) set(i, lines.near[i], HitKind::container);
    for (const std::size_t i : found.exitWalls) set(i, lines.far[i], HitKind::container);
    for (const FirstRoots::Other& other : found.others)
        set(other.line, other.root.t, hitKind(other.root.kind));
}

/// Most rays that leave a surface meet nothing more, which is soon known on the way back.
void Isosurface::findSecondary(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    IsosurfaceState& state = stateOf(*this, context);
    if (!state.wayBackPays()) return findHits(rays, context, hits);
    searchBack(rays, hits, context);
    const FirstRoots& found = state.firstRoots;
    const std::span<const Verdict> verdicts = finder(context).verdicts();
    state.meets.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        state.meets[i] =
            found.crossings[FirstRoots::t][i] < FirstRoots::none || verdicts[i] != Verdict::certifiedMiss;
    for (const std::size_t i : found.entryWalls) state.meets[i] = 1;
    for (const std::size_t i : found.exitWalls) state.meets[i] = 1;
    for (const FirstRoots::Other& other : found.others) state.meets[other.line] = 1;
    state.meeting.clear();
    for (std::uint32_t i = 0; i < rays.size(); ++i)
        if (state.meets[i]) state.meeting.push_back(i);
    state.sentBack += rays.size();
    state.settledBack += rays.size() - state.meeting.size();
    if (state.meeting.empty()) return;
    state.meetingRays.gather(rays, state.meeting);
    state.meetingHits.gatherLimits(hits, state.meeting);
    findHits(state.meetingRays, context, state.meetingHits);
    hits.takeNearer(state.meetingHits, state.meeting);
}

void Isosurface::nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    if (context.rootFinder != RootFinder::certified) return Shape::nearestInBatch(rays, context, hits);
    const EvaluationMeter meter(finder(context), context);
    if (context.shadowRay) return block(rays, context, hits);
    if (context.nearLimit > 0) return findSecondary(rays, context, hits);
    findHits(rays, context, hits);
}

void Isosurface::findHits(const RayBatch& rays, TraceContext& context, HitBatch& hits) const {
    IsosurfaceState& state = stateOf(*this, context);
    state.passages.find(settings_.container, rays);
    state.passages.beginWithRays(rays.size(), hits[HitBatch::t]);
    LineRootFinder& rootFinder = finder(context);
    FirstRoots& found = state.firstRoots;
    if (context.nearLimit > 0) {
        state.lines.start(rays, state.passages, context.nearLimit);
        rootFinder.findFirst(state.lines.columns(), {0, false, context.stop}, found);
        for (std::size_t i = 0; i < rays.size(); ++i)
            found.crossings[FirstRoots::t][i] = state.lines.onRay(i, found.crossings[FirstRoots::t][i]);
        for (FirstRoots::Other& other : found.others)
            other.root.t = state.lines.onRay(other.line, other.root.t);
    } else {
        rootFinder.findFirst({rays.size(), rays.origins(), rays.directions(), state.passages.near().data(),
                              state.passages.far().data()},
                             {0, context.missMemory, context.stop}, found);
    }
    noteVerdicts([&](std::size_t i) { return rays.samples()[i]; }, rootFinder, context);
    context.rays += rays.size();
    takeCrossings(found.crossings, hits);
    const auto setWalls = [&](std::span<const std::size_t> lines, const double* places, bool entering) {
        const auto& normals = state.wallNormals;
        state.passages.wallNormals(settings_.container, rays, lines, entering, state.wallNormals);
        for (std::size_t k = 0; k < lines.size(); ++k)
            if (const std::size_t i = lines[k]; places[i] < hits[HitBatch::t][i])
                hits.set(i, places[i], {normals[0][k], normals[1][k], normals[2][k]}, HitKind::container,
                         noMaterial);
    };
    setWalls(found.entryWalls, state.passages.near().data(), true);
    setWalls(found.exitWalls, state.passages.far().data(), false);
    for (const FirstRoots::Other& other : found.others) {
        const std::size_t i = other.line;
        if (!(other.root.t < hits[HitBatch::t][i])) continue;
        const HitKind kind = hitKind(other.root.kind);
        const glm::dvec3 normal = kind == HitKind::container
                                      ? state.passages.wallNormal(settings_.container, rays, i,
                                                                  other.root.kind == RootKind::entryWall)
                                      : unitNormal(other.normal);
        hits.set(i, other.root.t, normal, kind, noMaterial);
    }
}

void Isosurface::nearest(std::span<const Ray> rays, TraceContext& context,
                         std::span<NearestHit> nearest) const {
    if (context.rootFinder != RootFinder::certified) return nearestByLists(rays, context, nearest);
    IsosurfaceState& state = stateOf(*this, context);
    state.batch.assign(rays);
    state.hits.reset(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (nearest[i].found) state.hits.limit(i, nearest[i].hit.t);
    nearestInBatch(state.batch, context, state.hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double t = state.hits[HitBatch::t][i];
        if (!state.hits.found(i) || (nearest[i].found && !(t < nearest[i].hit.t))) continue;
        nearest[i] = {true,
                      {t, rays[i].at(t), state.hits.normal(i), state.hits.material(i), state.hits.kind(i)}};
    }
}

void Isosurface::nearestByLists(std::span<const Ray> rays, TraceContext& context,
                                std::span<NearestHit> nearest) const {
    const EvaluationMeter meter(finder(context), context);
    search(rays, context.nearLimit, nearest, context);
    IsosurfaceState& state = stateOf(*this, context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RootList& roots = state.roots[i];
        const auto first = std::find_if(roots.begin(), roots.end(),
                                        [&](const Root& root) { return root.t >= context.nearLimit; });
        if (first == roots.end() || (nearest[i].found && !(first->t < nearest[i].hit.t))) continue;
        nearest[i].found = true;
        setHit(settings_.container, state.passages, rays[i], i, *first, nearest[i].hit);
        if (!context.shadowRay) wantNormals({&nearest[i].hit, 1}, state);
    }
    addNormals(finder(context), state, context.stop);
}

void Isosurface::allHits(std::span<const Ray> rays, TraceContext& context, std::span<HitList> hits) const {
    const EvaluationMeter meter(finder(context), context);
    search(rays, allRoots, {}, context);
    IsosurfaceState& state = stateOf(*this, context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hits[i].clear();
        for (const Root& root : state.roots[i])
            setHit(settings_.container, state.passages, rays[i], i, root, hits[i].emplace_back());
        if (!context.shadowRay) wantNormals(hits[i], state);
    }
    addNormals(finder(context), state, context.stop);
}

bool Isosurface::contains(const glm::dvec3& point, TraceContext& context) const {
    if (!containerHolds(point)) return false;
    ++context.evaluations;
    std::optional<PointMembership>& membership = stateOf(*this, context).membership;
    if (!membership) membership.emplace(prepared(context.parameters()), rootSettings_);
    return membership->isInside(point);
}

Bounds Isosurface::bounds() const {
    if (const auto* box = std::get_if<ContainerBox>(&settings_.container)) return {box->low, box->high};
    const auto& sphere = std::get<ContainerSphere>(settings_.container);
    return {sphere.center - sphere.radius, sphere.center + sphere.radius};
}

bool Isosurface::mayBeMet(const RayBundle& rays) const {
    const auto* sphere = std::get_if<ContainerSphere>(&settings_.container);
    return sphere == nullptr || rays.mayMeetBall(sphere->center, sphere->radius);
}

std::optional<RootFinderReport> Isosurface::gradientReport(const TraceContext& context) const {
    const auto* state = static_cast<const IsosurfaceState*>(context.find(this));
    if (state == nullptr) return {};
    const auto& finder = state->finders[static_cast<std::size_t>(RootFinder::lipschitz)];
    if (!finder || finder->report().searches == 0) return {};
    return finder->report();
}

std::shared_ptr<const Isosurface> asIsosurface(const ShapePointer& shape) {
    const auto* surface = shape ? shape->primitive().as<Isosurface>() : nullptr;
    return surface ? std::shared_ptr<const Isosurface>(shape, surface) : nullptr;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/certified_root_finder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/roots/certified/line_points.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/roots/povray_hits.h"
#include "core/roots/povray_normal.h"

namespace isoscope {

namespace {

bool isSearchable(const LineQuery& query) { return query.near < query.far && std::isfinite(query.far); }

}  // namespace

CertifiedRootFinder::CertifiedRootFinder(std::shared_ptr<const PreparedFunction> function,
                                         const RootSettings& settings, std::uint32_t budget)
    : settings_(settings.usable()),
      function_(std::move(function)),
      global_(function_->global()),
      forms_(function_, function_->globalFor(settings_.threshold)),
      points_(function_),
      gradients_(function_),
      bundles_(function_->cost()),
      polish_(points_, settings_),
      lanes_({settings_, forms_, points_, budget}),
      parts_(*function_, settings_),
      partTapes_(*function_, parts_),
      slabs_(*function_, {settings_, forms_, points_, budget}, partTapes_),
      march_(forms_, settings_),
      newton_(gradients_, settings_),
      cells_(*function_, {settings_, forms_, march_, newton_, polish_, gradients_, parts_}),
      sheets_(function_, points_, gradients_, settings_) {
    const Tape& tape = *function_->tape();
    if (!function_->cost().holdsNoise || !TaylorEvaluator::covers(tape)) return;
    // Choices that are the same everywhere may leave a constant.
    const SimplifiedTape* const decided = global_->decided();
    if (decided != nullptr && tape.isUniform(decided->result)) return;
    tangents_.emplace(function_);
}

CertifiedRootFinder::CertifiedRootFinder(std::shared_ptr<const Tape> tape, std::span<const double> parameters,
                                         const RootSettings& settings, std::uint32_t budget)
    : CertifiedRootFinder(PreparedFunction::of(std::move(tape), parameters), settings, budget) {}

void CertifiedRootFinder::find(std::span<const LineQuery> queries, const RootRequest& request,
                               std::span<RootList> roots) {
    for (RootList& list : roots) list.clear();
    isPicture_ = isPicture(queries.size(), request);
    prepare(queries);
    if (!forms_.certain()) return findUncertain(queries, request, roots);
    search(queries, request, roots);
    searchByPovray(queries, request, roots);
    finish(queries, request, roots);
}

/// Enclosures that never narrow decide nothing: all is left to POV-Ray's method.
void CertifiedRootFinder::findUncertain(std::span<const LineQuery> queries, const RootRequest& request,
                                        std::span<RootList> roots) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
        if (!wanted_[i]) continue;
        verdicts_[i] = Verdict::notCertified;
        ++searches_;
    }
    LipschitzRootFinder& finder = povray();
    finder.find(queries, {request.sufficient, false, request.stop}, roots);
    povrayValues_ += finder.report().evaluations;
}

bool CertifiedRootFinder::isPicture(std::size_t lines, const RootRequest& request) {
    return lines >= BundleMarch::bundleLines && std::isfinite(request.sufficient);
}

void CertifiedRootFinder::prepare(std::span<const LineQuery> queries) {
    verdicts_.assign(queries.size(), Verdict::certifiedMiss);
    ends_.assign(queries.size(), EndSign::unknown);
    wanted_.resize(queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) wanted_[i] = isSearchable(queries[i]);
    pending_.clear();
    unproven_.clear();
    starts_.reset(queries.size());
}

void CertifiedRootFinder::finish(std::span<const LineQuery> queries, const RootRequest& request,
                                 std::span<RootList> roots) {
    if (request.stop.stop_requested()) {
        for (RootList& list : roots) list.clear();
        return;
    }
    polish_.run(pending_, queries, roots);
    if (!settings_.open) addExitWalls(queries, request, roots);
}

void CertifiedRootFinder::search(std::span<const LineQuery> queries, const RootRequest& request,
                                 std::span<RootList> roots) {
    const bool many = queries.size() >= BundleMarch::bundleLines;
    if (slabs_.worthwhile() && many && slabs_.pays(queries, wanted_))
        searchSlabs(queries, SlabSearch::batchLines, request, roots);
    else if (slabs_.worthwhile() && !many && !keepsValues_ && partTapes_.begin())
        searchSlabs(queries, 1, request, roots);
    else
        searchWhole(queries, 0, queries.size(), request, roots);
}

/// So many lines at a time.
void CertifiedRootFinder::searchSlabs(std::span<const LineQuery> queries, std::size_t batch,
                                      const RootRequest& request, std::span<RootList> roots) {
    for (std::size_t first = 0; first < queries.size() && !request.stop.stop_requested(); first += batch) {
        const std::size_t end = std::min(first + batch, queries.size());
        if (!slabs_.begin(queries.first(end), std::span(wanted_).first(end), first)) {
            searchWhole(queries, first, end, request, roots);
            continue;
        }
        const std::size_t before = pending_.size();
        slabs_.noteStarts(starts_);
        addEntryWalls(queries, first, end, request, roots, slabs_.tape());
        slabs_.run(
            queries, wanted_, request.sufficient, allowanceOf(queries, first, end, request), request.stop,
            [&](std::size_t line, const GeneralSearch& search, double endSign) {
                retire(line, search, endSign, roots);
            },
            [&](std::size_t line, double sign) { miss(line, sign); });
        if (slabs_.tape() == nullptr) continue;
        polish_.run(std::span(pending_).subspan(before), queries, roots, slabs_.tape());
        pending_.resize(before);
    }
}

/// Finds out what is certain about the beginnings of the lines [first, end).
void CertifiedRootFinder::marchBundles(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                                       const RootRequest& request) {
    const std::size_t count = end - first;
    if (count < BundleMarch::bundleLines) return;
    // The wall where a line enters is all that is asked for.
    const bool wallEnds = !settings_.open && std::isfinite(request.sufficient);
    bundles_.run(queries.subspan(first, count), std::span(wanted_).subspan(first, count),
                 {{settings_.threshold, settings_.positivePolarity}, wallEnds}, forms_, starts_, first);
}

/// Searches the lines [first, end) with the whole tape.
void CertifiedRootFinder::searchWhole(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                                      const RootRequest& request, std::span<RootList> roots) {
    marchBundles(queries, first, end, request);
    addEntryWalls(queries, first, end, request, roots);
    searchLines(queries, first, end, request, roots);
}

/// From where they are certain on.
void CertifiedRootFinder::searchLines(std::span<const LineQuery> queries, std::size_t first, std::size_t end,
                                      const RootRequest& request, std::span<RootList> roots) {
    lanes_.clear();
    lanes_.allow(allowanceOf(queries, first, end, request));
    for (std::size_t next = first; (next < end || !lanes_.empty()) && !request.stop.stop_requested();) {
        for (; next < end && !lanes_.full(); ++next) {
            if (!wanted_[next]) continue;
            const CertainStart start = starts_[next];
            if (start.sign != 0 && start.start >= queries[next].far)
                miss(next, start.sign);
            else
                lanes_.add(next, queries[next], request.sufficient, start);
        }
        if (lanes_.empty()) continue;
        lanes_.step(queries, nullptr, [&](std::size_t line, const GeneralSearch& search, double endSign) {
            retire(line, search, endSign, roots);
        });
    }
}

/// What the lines [first, end) may take: without a limit unless they are of a picture.
SearchAllowance CertifiedRootFinder::allowanceOf(std::span<const LineQuery> queries, std::size_t first,
                                                 std::size_t end, const RootRequest& request) {
    if (!isPicture_) return {};
    const auto wanted = std::span(wanted_).subspan(first, end - first);
    const auto lines = static_cast<std::size_t>(std::ranges::count_if(wanted, std::identity()));
    return {lines, forms_.evaluations(), [this, part = queries.subspan(first, end - first), &request] {
                return priceByPovray(part, request);
            }};
}

LipschitzRootFinder& CertifiedRootFinder::povray() {
    if (!povray_)
        povray_ = std::make_unique<LipschitzRootFinder>(std::make_unique<TapeField>(function_), settings_);
    povray_->restart();
    return *povray_;
}

/// About how many values a line takes by POV-Ray's method, by some of them.
std::uint64_t CertifiedRootFinder::priceByPovray(std::span<const LineQuery> queries,
                                                 const RootRequest& request) {
    constexpr std::size_t asked = 8;
    std::vector<LineQuery> lines;
    for (std::size_t k = 0; k < asked; ++k) lines.push_back(queries[k * queries.size() / asked]);
    std::vector<RootList> found(asked);
    LipschitzRootFinder& finder = povray();
    finder.find(lines, {request.sufficient, false, request.stop}, found);
    const std::uint64_t values = finder.report().evaluations;
    povrayValues_ += values;
    return values / asked;
}

/// What POV-Ray shows of the lines of which too little can be proven.
void CertifiedRootFinder::searchByPovray(std::span<const LineQuery> queries, const RootRequest& request,
                                         std::span<RootList> roots) {
    if (unproven_.empty() || request.stop.stop_requested()) return;
    std::vector<LineQuery> lines;
    for (const std::size_t line : unproven_) lines.push_back(queries[line]);
    std::vector<RootList> found(lines.size());
    LipschitzRootFinder& finder = povray();
    finder.find(lines, {request.sufficient, false, request.stop}, found);
    povrayValues_ += finder.report().evaluations;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        roots[unproven_[k]] = std::move(found[k]);
        // Walls are among what it has found.
        ends_[unproven_[k]] = EndSign::outside;
    }
}

/// The function is known to have one sign all along the line.
void CertifiedRootFinder::miss(std::size_t line, double sign) {
    ++searches_;
    noteEnd(line, sign);
}

void CertifiedRootFinder::retire(std::size_t line, const GeneralSearch& search, double endSign,
                                 std::span<RootList> roots) {
    ++searches_;
    verdicts_[line] = search.verdict();
    exhausted_ += search.verdict() == Verdict::budgetExceeded;
    noteEnd(line, endSign);
    if (isPicture_ && search.verdict() == Verdict::budgetExceeded) return unproven_.push_back(line);
    for (const BracketedRoot& found : search.roots()) {
        if (found.refinable)
            pending_.push_back(
                {line, roots[line].size(), found.low, found.high, found.steepness, found.leftover});
        roots[line].push_back(found.root);
    }
}

void CertifiedRootFinder::noteEnd(std::size_t line, double sign) {
    if (sign != 0) ends_[line] = sign < 0 ? EndSign::inside : EndSign::outside;
}

/// Lines that come from outside into the solid meet its wall at once. By a tape that holds along the lines,
/// or by the whole one.
void CertifiedRootFinder::addEntryWalls(std::span<const LineQuery> queries, std::size_t first,
                                        std::size_t end, const RootRequest& request,
                                        std::span<RootList> roots, const SimplifiedTape* tape) {
    if (settings_.open) return;
    asked_.clear();
    const auto enter = [&](std::size_t i) {
        roots[i].push_back({queries[i].near, RootKind::entryWall});
        wanted_[i] = queries[i].near < request.sufficient;
        if (!wanted_[i]) verdicts_[i] = Verdict::certifiedHit;
    };
    for (std::size_t i = first; i < end; ++i) {
        if (!(queries[i].near > 0) || !wanted_[i]) continue;
        const double sign = starts_[i].start >= queries[i].near ? starts_[i].sign : 0;
        if (sign < 0)
            enter(i);
        else if (sign == 0)
            asked_.push_back(i);
    }
    LinePoints(points_, settings_, tape)
        .evaluate(
            asked_.size(), [&](std::size_t k) -> const LineQuery& { return queries[asked_[k]]; },
            [&](std::size_t k) { return queries[asked_[k]].near; },
            [&](std::size_t k, double value) {
                if (value < 0) enter(asked_[k]);
            });
}

void CertifiedRootFinder::addExitWalls(std::span<const LineQuery> queries, const RootRequest& request,
                                       std::span<RootList> roots) {
    asked_.clear();
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const bool satisfied = !roots[i].empty() && roots[i].back().t >= request.sufficient;
        if (satisfied || !isSearchable(queries[i]) || ends_[i] == EndSign::outside) continue;
        if (ends_[i] == EndSign::inside)
            roots[i].push_back({queries[i].far, RootKind::exitWall});
        else
            asked_.push_back(i);
    }
    LinePoints(points_, settings_)
        .evaluate(
            asked_.size(), [&](std::size_t k) -> const LineQuery& { return queries[asked_[k]]; },
            [&](std::size_t k) { return queries[asked_[k]].far; },
            [&](std::size_t k, double value) {
                if (value < 0) roots[asked_[k]].push_back({queries[asked_[k]].far, RootKind::exitWall});
            });
}

void CertifiedRootFinder::findFirst(const LineColumns& lines, const RootRequest& request, FirstRoots& roots) {
    if (!forms_.certain()) return LineRootFinder::findFirst(lines, request, roots);
    roots.clear(lines.count);
    isPicture_ = isPicture(lines.count, request);
    firstVerdicts_.assign(lines.count, Verdict::certifiedMiss);
    rest_.lines.clear();
    rest_.queries.clear();
    const bool byCells = cells_.worthwhile() && cellsMayPay() && findByCells(lines, request, roots);
    if (!byCells) findPlain(lines, request, roots);
    verdicts_.swap(firstVerdicts_);
    if (request.stop.stop_requested()) return roots.clear(lines.count);
    setNormals(lines, request.stop, roots);
    setJumpNormals(lines, roots);
}

/// At a jump the gradient tells nothing about the face that is seen: what POV-Ray shows there is the height
/// of the jump along the axes that lead across it from where its halving ends.
void CertifiedRootFinder::setJumpNormals(const LineColumns& lines, FirstRoots& roots) {
    std::vector<FirstRoots::Other*> jumps;
    for (FirstRoots::Other& other : roots.others)
        if (other.root.kind == RootKind::jump) jumps.push_back(&other);
    if (jumps.empty()) return;
    enum Column : std::size_t { root, near, far };
    jumps_.reserve(jumps.size());
    for (std::size_t k = 0; k < jumps.size(); ++k) {
        jumps_[root][k] = jumps[k]->root.t;
        jumps_[near][k] = lines.near[jumps[k]->line];
        jumps_[far][k] = lines.far[jumps[k]->line];
    }
    endPovrayHalvings(jumps.size(), settings_.accuracy, jumps_[root], jumps_[near], jumps_[far]);
    std::vector<glm::dvec3> places(jumps.size()), normals(jumps.size());
    for (std::size_t k = 0; k < jumps.size(); ++k) {
        const LineQuery line = lines[jumps[k]->line];
        places[k] = line.origin + jumps_[far][k] * line.direction;
    }
    povrayNormals<batchLanes>(
        places, settings_, [&](auto x, auto y, auto z, auto values) { points_.evaluate(x, y, z, values); },
        normals);
    for (std::size_t k = 0; k < jumps.size(); ++k) jumps[k]->normal = normals[k];
}

/// False, and nothing is done, where it does not pay.
bool CertifiedRootFinder::findByCells(const LineColumns& lines, const RootRequest& request,
                                      FirstRoots& roots) {
    const CellMarch::Outcome outcome = cells_.run(lines, request.sufficient, request.stop, roots);
    paidCells_ += outcome == CellMarch::Outcome::done;
    vainCells_ += outcome == CellMarch::Outcome::vain;
    if (outcome != CellMarch::Outcome::done) {
        roots.clear(lines.count);
        return false;
    }
    if (request.stop.stop_requested()) return true;
    searches_ += cells_.searched() - cells_.rest().size();
    const Verdict hit = Verdict::certifiedHit;
    roots.noteCrossings(hit, firstVerdicts_);
    for (const std::size_t line : roots.entryWalls) firstVerdicts_[line] = hit;
    for (const FirstRoots::Other& other : roots.others) firstVerdicts_[other.line] = hit;
    std::erase_if(roots.exitWalls, [&](std::size_t line) { return lines.far[line] < request.sufficient; });
    std::erase_if(roots.others, [&](const auto& other) { return other.root.t < request.sufficient; });
    findRest(lines, cells_.rest(), {}, request, roots);
    return true;
}

void CertifiedRootFinder::findPlain(const LineColumns& lines, const RootRequest& request, FirstRoots& roots) {
    starts_.reset(lines.count);
    const Verdict hit = Verdict::certifiedHit;
    if (lines.count >= BundleMarch::bundleLines) {
        marched_.clear();
        bundles_.run(lines, {{settings_.threshold, settings_.positivePolarity}, !settings_.open}, forms_,
                     starts_, sheets_.possible() ? &marched_ : nullptr);
        bool found = sheets_.run(lines, marched_, request.sufficient, starts_, roots);
        if (sheets_.possible()) {
            marched_.clear();
            bundles_.refine(lines, forms_, starts_, &marched_);
            found |= sheets_.run(lines, marched_, request.sufficient, starts_, roots);
        }
        if (found) roots.noteCrossings(hit, firstVerdicts_);
    }
    if (forms_.canJump()) noteWalls(lines);
    MarchKernel::Results& found =
        march_.run(lines, starts_, request.sufficient, request.stop, tangents_.has_value());
    if (tangents_) {
        TangentPolish(*tangents_, settings_).run(found, request.sufficient, global_->decided(), roots);
        roots.noteCrossings(hit, firstVerdicts_);
        march_.resume(request.stop);
    }
    if (request.stop.stop_requested()) return;
    searches_ += march_.searched() - found.rest.size();
    for (std::size_t i = 0; i < found.crossings.size(); ++i)
        firstVerdicts_[static_cast<std::size_t>(found.crossings[MarchKernel::foundLine][i])] = hit;
    for (const std::size_t line : found.entryWalls) firstVerdicts_[line] = hit;
    for (const FirstRoots::Other& jump : found.jumps) firstVerdicts_[jump.line] = hit;
    roots.others.insert(roots.others.end(), found.jumps.begin(), found.jumps.end());
    roots.entryWalls.swap(found.entryWalls);
    for (const std::size_t line : found.insideEnds)
        if (!settings_.open && lines.far[line] >= request.sufficient) roots.exitWalls.push_back(line);
    newton_.run(found.crossings, roots, global_->decided());
    findRest(lines, found.rest, newton_.unsettled(), request, roots);
}

/// Lines that enter their container, and of which nothing is known yet: those that are inside at the wall.
void CertifiedRootFinder::noteWalls(const LineColumns& lines) {
    if (settings_.open) return;
    asked_.clear();
    for (std::size_t i = 0; i < lines.count; ++i) {
        // A bundle may begin, and be left, before one of its lines does.
        const bool known = starts_.sign()[i] != 0 && starts_.start()[i] >= lines.near[i];
        if (lines.near[i] > 0 && lines.near[i] < lines.far[i] && !known) asked_.push_back(i);
    }
    LinePoints(points_, settings_)
        .evaluate(
            asked_.size(), [&](std::size_t k) { return lines[asked_[k]]; },
            [&](std::size_t k) { return lines.near[asked_[k]]; },
            [&](std::size_t k, double value) {
                const std::size_t i = asked_[k];
                if (value < 0) starts_.set(i, 1, {lines.near[i], -1, lines.far[i] - lines.near[i]});
            });
}

void CertifiedRootFinder::findRest(const LineColumns& lines, std::span<const MarchKernel::Line> searched,
                                   std::span<const NewtonPolish::Unsettled> unsettled,
                                   const RootRequest& request, FirstRoots& roots) {
    if (searched.empty() && unsettled.empty()) return;
    for (const MarchKernel::Line& line : searched) rest_.lines.push_back(line.line);
    for (const NewtonPolish::Unsettled& crossing : unsettled) rest_.lines.push_back(crossing.line);
    for (const std::size_t line : rest_.lines) rest_.queries.push_back(lines[line]);
    if (rest_.roots.size() < rest_.lines.size()) rest_.roots.resize(rest_.lines.size());
    const std::span<RootList> lists = std::span(rest_.roots).first(rest_.lines.size());
    for (RootList& list : lists) list.clear();
    prepare(rest_.queries);
    for (std::size_t k = 0; k < searched.size(); ++k) starts_.set(k, 1, searched[k].start);
    addEntryWalls(rest_.queries, 0, searched.size(), request, lists);
    searchLines(rest_.queries, 0, searched.size(), request, lists);
    searchByPovray(rest_.queries, request, lists);
    for (std::size_t k = searched.size(); k < lists.size(); ++k) {
        const NewtonPolish::Unsettled& crossing = unsettled[k - searched.size()];
        lists[k].push_back({crossing.low + (crossing.high - crossing.low) / 2, RootKind::crossing});
        pending_.push_back({k, 0, crossing.low, crossing.high, crossing.steepness, 1});
        verdicts_[k] = firstVerdicts_[crossing.line];
        ends_[k] = EndSign::outside;
    }
    finish(rest_.queries, request, lists);
    takeRest(request.sufficient, roots);
}

/// What the general search has found.
void CertifiedRootFinder::takeRest(double sufficient, FirstRoots& roots) {
    for (std::size_t k = 0; k < rest_.lines.size(); ++k) {
        const RootList& list = rest_.roots[k];
        const auto first =
            std::find_if(list.begin(), list.end(), [&](const Root& root) { return root.t >= sufficient; });
        if (first != list.end()) roots.others.push_back({rest_.lines[k], *first});
        firstVerdicts_[rest_.lines[k]] = verdicts_[k];
    }
}

void CertifiedRootFinder::normals(std::span<const glm::dvec3> points, std::span<glm::dvec3> out) {
    if (!forms_.certain()) return povray().normals(points, out);
    const double outward = settings_.positivePolarity ? -1 : 1;
    for (std::size_t first = 0; first < points.size(); first += batchLanes) {
        const std::size_t count = std::min(batchLanes, points.size() - first);
        setGradients(points.subspan(first, count));
        flat_.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const auto& [dx, dy, dz] = found_[k].gradient;
            out[first + k] = outward * glm::dvec3(dx, dy, dz);
            if (dx == 0 && dy == 0 && dz == 0) flat_.push_back(first + k);
        }
        setDifferences(points, flat_, outward, out);
    }
}

/// found_[k] = what the function is at points[k], up to batchLanes of them. Of a union, at points on its
/// surface, by the parts that are met there.
void CertifiedRootFinder::setGradients(std::span<const glm::dvec3> points) {
    std::array<double, batchLanes> x, y, z;
    for (std::size_t k = 0; k < points.size(); ++k)
        x[k] = points[k].x, y[k] = points[k].y, z[k] = points[k].z;
    const auto of = [&points](auto& lanes) { return std::span(lanes).first(points.size()); };
    if (slabs_.worthwhile() && partTapes_.begin() &&
        std::ranges::all_of(points, [&](const glm::dvec3& point) { return partTapes_.add(point); })) {
        gradients_.evaluate(of(x), of(y), of(z), of(found_), partTapes_.make());
        // Further outside, as in front of a jump, other parts may be less.
        const auto isOnSurface = [&](const ValueAndGradient& at) {
            constexpr double small = 1e-3;
            return settings_.signedValue(at.value) <= small * settings_.accuracy * slopeOf(at);
        };
        if (std::ranges::all_of(of(found_), isOnSurface)) return;
    }
    gradients_.evaluate(of(x), of(y), of(z), of(found_));
}

/// Central differences over the accuracy at the points of `which`.
void CertifiedRootFinder::setDifferences(std::span<const glm::dvec3> points,
                                         std::span<const std::size_t> which, double outward,
                                         std::span<glm::dvec3> out) {
    // Two points on each axis.
    constexpr std::size_t each = 6, atOnce = batchLanes / each;
    std::array<std::array<double, batchLanes>, 3> place;
    std::array<double, batchLanes> values;
    for (; !which.empty(); which = which.subspan(std::min(atOnce, which.size()))) {
        const std::size_t count = std::min(atOnce, which.size());
        for (std::size_t lane = 0; lane < each * count; ++lane) {
            const int moved = static_cast<int>(lane % each / 2);
            const double step = lane % 2 == 0 ? -settings_.accuracy : settings_.accuracy;
            for (int axis = 0; axis < 3; ++axis)
                place[static_cast<std::size_t>(axis)][lane] =
                    points[which[lane / each]][axis] + (axis == moved ? step : 0);
        }
        const auto of = [&](auto& lanes) { return std::span(lanes).first(each * count); };
        points_.evaluate(of(place[0]), of(place[1]), of(place[2]), of(values));
        for (std::size_t k = 0; k < count; ++k) {
            glm::dvec3& difference = out[which[k]];
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t lane = each * k + 2 * static_cast<std::size_t>(axis);
                const double rise = values[lane + 1] - values[lane];
                difference[axis] = std::isfinite(rise) ? outward * rise : 0;
            }
        }
    }
}

RootFinderReport CertifiedRootFinder::report() const {
    RootFinderReport report;
    report.maxGradient = settings_.maxGradient;
    report.searches = searches_;
    report.evaluations = forms_.evaluations() + sheets_.evaluations() + points_.evaluations() + povrayValues_;
    if (tangents_) report.evaluations += tangents_->evaluations();
    report.exhausted = exhausted_;
    return report;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/picture.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/common.hpp>
#include <span>
#include <utility>

#include "core/evaluate/tape/loop_stop.h"
#include "core/render/camera/adaptive_sampling.h"
#include "core/render/camera/lens_sampling.h"
#include "core/render/camera/pixel_colors.h"
#include "core/render/picture_parts.h"
#include "core/render/stages/clear_background.h"

namespace isoscope {

namespace {

/// Into how many batches a picture is divided at least, as long as they are not too small. What a batch takes
/// is touched for the first time once a picture, which costs a small picture up to a fifth of its time.
constexpr std::size_t fewestBatches = 64;
constexpr std::size_t smallestBatch = 256;
constexpr int antialiasSide = 3;

/// How many rays of a picture of so many pixels go through the stages together. Isosurfaces look at the stop
/// request by themselves, so that these need not be few.
std::size_t batchRaysOf(std::size_t pixels) {
    return std::clamp(std::bit_floor(pixels / fewestBatches), smallestBatch, TileScratch::largestBatch);
}

/// How the verdicts are called, by their number.
std::string verdictName(std::size_t verdict) {
    if (verdict == missCount) return "miss";
    if (verdict >= firstCertainty) return name(static_cast<Verdict>(verdict - firstCertainty));
    const auto kind = static_cast<HitKind>(verdict);
    return kind == HitKind::crossing ? "hit" : name(kind);
}

void countHits(TileScratch& work) {
    const HitBatch& hits = work.batch.hits;
    std::size_t found = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits.found(i)) {
            ++work.verdicts[static_cast<std::size_t>(hits.kind(i))];
            ++found;
        }
    work.verdicts[missCount] += work.batch.size() - found;
}

/// Most samples have the verdict of their neighbours.
void countVerdicts(std::span<const Verdict> verdicts, TileScratch& work) {
    std::size_t first = 0;
    for (std::size_t i = 1; i <= verdicts.size(); ++i) {
        // Many at a time while nothing changes.
        while (i + 256 <= verdicts.size() && std::memcmp(&verdicts[i - 1], &verdicts[i], 256) == 0) i += 256;
        while (i + 8 <= verdicts.size() && std::memcmp(&verdicts[i - 1], &verdicts[i], 8) == 0) i += 8;
        if (i < verdicts.size() && verdicts[i] == verdicts[first]) continue;
        work.verdicts[firstCertainty + static_cast<std::size_t>(verdicts[first])] += i - first;
        first = i;
    }
}

void countCertainties(TileScratch& work, VerdictMap* map) {
    const SampleBatch& batch = work.batch;
    countVerdicts(batch.verdicts, work);
    if (map == nullptr) return;
    for (std::size_t i = 0; i < batch.size(); ++i)
        map->note(static_cast<int>(batch.places[i].x), static_cast<int>(batch.places[i].y),
                  batch.verdicts[i]);
    // Hits belong to rays, of which there are fewer where nothing can be met.
    for (std::size_t ray = 0; ray < batch.rays.size(); ++ray) {
        if (!batch.hits.found(ray) || batch.hits.kind(ray) != HitKind::container) continue;
        const SampleBatch::PixelPosition& place = batch.places[batch.rays.samples()[ray]];
        map->noteWall(static_cast<int>(place.x), static_cast<int>(place.y));
    }
}

/// side * side samples a pixel.
void placeSamples(std::span<const PixelIndex> pixels, int side,
                  std::vector<SampleBatch::PixelPosition>& places) {
    places.resize(pixels.size() * static_cast<std::size_t>(side * side));
    if (side == 1) return placeInMiddles(pixels, places);
    auto place = places.begin();
    for (const PixelIndex& pixel : pixels)
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                *place++ = {pixel.x + (column + 0.5) / side, pixel.y + (row + 0.5) / side};
}

void mergeGradient(const RootFinderReport& seen, RootFinderReport& merged) {
    merged.maxGradient = std::max(merged.maxGradient, seen.maxGradient);
    merged.steepest = std::max(merged.steepest, seen.steepest);
    merged.searches += seen.searches;
    merged.evaluations += seen.evaluations;
    merged.exhausted += seen.exhausted;
}

}  // namespace

bool Picture::drawable(const RenderRequest& request) {
    if (!request.scene || request.width <= 0 || request.height <= 0) return false;
    return static_cast<std::size_t>(request.width) <= pixelLimit / static_cast<std::size_t>(request.height);
}

Picture::Picture(const RenderRequest& request)
    : request_(request), plan_(makePlan(*request.scene, request.leftOut)) {
    for (const std::vector<PlannedStage>* list : {&plan_.leftOut, &plan_.notCalledFor})
        for (const PlannedStage& effect : *list)
            if (const auto takeOut = descriptionOf(effect.kind).takeOut) takeOut(request_);
    build();
    if (onlySurfaces_) prepareEmptiness();
}

void Picture::build() {
    PictureParts parts{request_, plan_};
    bool clear = request_.transparent;
    for (const PlannedStage& effect : plan_.stages) {
        if (clear && effect.kind > StageKind::surround) {
            parts.stages.push_back(std::make_unique<ClearBackground>());
            clear = false;
        }
        if (const auto build = descriptionOf(effect.kind).build) build(parts);
    }
    if (clear) parts.stages.push_back(std::make_unique<ClearBackground>());
    primaryRays_ = std::move(parts.primaryRays);
    stages_ = std::move(parts.stages);
    if (parts.sendsRays) secondaryRays_ = std::make_unique<SecondaryRays>(*request_.scene);
    if (parts.knowsInteriors) cameraInside_ = aroundCamera();
    onlySurfaces_ = parts.onlySurfaces && plan_.has(StageKind::background);
}

void Picture::prepareEmptiness() {
    const Scene& scene = *request_.scene;
    const glm::dvec3 color(scene.background.red, scene.background.green, scene.background.blue);
    if (request_.transparent) return;
    makePixels({&color, 1}, 1, {&backdrop_, 1});
    makePixels({&color, 1}, scene.settings.assumedGamma, {&emptiness_, 1});
    if (primaryRays_) simpleShading_ = SimpleShading::of(scene, plan_);
}

InteriorList Picture::aroundCamera() const {
    InteriorList inside;
    TraceContext context(request_.scene->parameterTable, request_.rootFinder);
    const glm::dvec3& eye = request_.camera.location;
    // POV-Ray asks first for the bounds: no camera is within a disc, which has half the space for its inside.
    for (const SceneObject& object : request_.scene->objects)
        if (object.interior != noInterior && !inside.has(object.interior) && object.shape &&
            object.shape->bounds().contains(eye) && object.shape->contains(eye, context))
            inside.enter(object.interior);
    return inside;
}

bool Picture::orderMatters() const {
    // POV-Ray has one memory for all isosurfaces; where there are several it has hardly any effect.
    const std::vector<SceneIsosurface>& isosurfaces = request_.scene->isosurfaces;
    if (request_.rootFinder != RootFinder::lipschitz) return false;
    return isosurfaces.size() == 1 ||
           std::any_of(isosurfaces.begin(), isosurfaces.end(), [](const SceneIsosurface& isosurface) {
               return isosurface.shape && isosurface.shape->settings().evaluate;
           });
}

TileScratch Picture::makeWork() const {
    TileScratch work;
    work.context = TraceContext(request_.scene->parameterTable, request_.rootFinder);
    work.batch.cameraPath.inside = cameraInside_;
    work.batchRays =
        batchRaysOf(static_cast<std::size_t>(request_.width) * static_cast<std::size_t>(request_.height));
    return work;
}

void Picture::begin(TileScratch& work, RayOrder order, std::stop_token stop) const {
    work.restart();
    work.context.missMemory = order == RayOrder::neighbours && request_.scene->isosurfaces.size() == 1;
    work.context.stop = std::move(stop);
}

bool Picture::draw(bool fine, TileScratch& work, const std::function<bool()>& stopped) const {
    const LoopStop loops(work.context.stop);
    work.colors.resize(work.pixels.size());
    if (request_.transparent) work.opacity.assign(work.pixels.size(), 0);
    if (fine && plan_.has(StageKind::focalBlur)) return drawBlurred(work, stopped);
    const bool antialias = fine && request_.antialias;
    if (antialias && request_.antialiasing.method != SamplingMethod::box)
        return drawAdaptively(work, stopped);
    const int side = antialias ? antialiasSide : 1;
    const auto samplesPerPixel = static_cast<std::size_t>(side * side);
    const std::size_t pixelsPerBatch = std::max<std::size_t>(1, work.batchRays / samplesPerPixel);
    for (std::size_t first = 0; first < work.pixels.size(); first += pixelsPerBatch) {
        if (stopped()) return false;
        const std::size_t count = std::min(pixelsPerBatch, work.pixels.size() - first);
        placeSamples(std::span(work.pixels).subspan(first, count), side, work.batch.places);
        const std::span<LinearColor> pixels = std::span(work.colors).subspan(first, count);
        if (simpleShading_ && side == 1) {
            drawPlainly(work, pixels);
            if (work.context.stop.stop_requested()) return false;
            continue;
        }
        sendRays(work);
        if (showsNothing(work)) {
            fillPixels(emptiness_, pixels);
            work.charge(StageKind::background);
            countBatch(work);
            continue;
        }
        if (!followRays(work, stopped)) return false;
        if (work.context.stop.stop_requested()) return false;
        makePixels(work.batch.colors, request_.scene->settings.assumedGamma, pixels);
        if (request_.transparent) noteOpacity(work, first, count);
    }
    return true;
}

/// Every pixel is the mean of as many samples of the batch as belong to it.
void Picture::noteOpacity(TileScratch& work, std::size_t first, std::size_t count) const {
    const std::size_t each = work.backgroundSeen.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
        double seen = 0;
        for (std::size_t k = 0; k < each; ++k) seen += std::min(work.backgroundSeen[i * each + k], 1.0);
        work.opacity[first + i] = static_cast<float>(1 - seen / static_cast<double>(each));
    }
}

void Picture::drawPlainly(TileScratch& work, std::span<LinearColor> pixels) const {
    SampleBatch& batch = work.batch;
    work.startMeter();
    batch.beginUnpainted();
    primaryRays_->find(work, batch);
    fillPixels(batch.rays.empty() ? emptiness_ : backdrop_, pixels);
    work.charge(StageKind::background);
    if (!batch.rays.empty()) {
        simpleShading_->paint(batch.rays, batch.hits, pixels, batch.verdicts);
        makeLinear(pixels, request_.scene->settings.assumedGamma);
        work.charge(StageKind::directLight);
    }
    countBatch(work);
}

bool Picture::isEmpty(const SampleBatch::Extent& extent) const {
    return onlySurfaces_ && primaryRays_ && !manySamples() && !request_.verdicts &&
           !primaryRays_->mayMeet(extent);
}

void Picture::countEmpty(std::size_t pixels, TileScratch& work) const {
    work.meter(StageKind::primaryRays).rays += pixels;
    const bool certified = work.context.rootFinder == RootFinder::certified;
    work.verdicts[certified ? firstCertainty + static_cast<std::size_t>(Verdict::certifiedMiss)
                            : missCount] += pixels;
}

/// Like POV-Ray, which adds samples up in the colour space of the scene.
bool Picture::drawAdaptively(TileScratch& work, const std::function<bool()>& stopped) const {
    std::vector<float> background(request_.transparent ? work.pixels.size() : 0);
    const bool drawn =
        AdaptiveSampling(request_.antialiasing, request_.width, request_.height)
            .draw(
                work.pixels,
                [&](auto places, auto& colors) { return shade(places, {}, work, stopped, colors); },
                work.colors, background);
    for (std::size_t i = 0; i < background.size(); ++i) work.opacity[i] = 1 - background[i];
    makeLinear(work.colors, request_.scene->settings.assumedGamma);
    return drawn;
}

bool Picture::drawBlurred(TileScratch& work, const std::function<bool()>& stopped) const {
    StageMeter& sent = work.meter(StageKind::primaryRays);
    const std::uint64_t before = sent.rays;
    std::vector<float> background(request_.transparent ? work.pixels.size() : 0);
    const bool drawn = LensSampling(request_.camera.blur)
                           .draw(
                               work.pixels,
                               [&](auto places, auto lens, auto& colors) {
                                   return shade(places, lens, work, stopped, colors);
                               },
                               work.colors, background);
    for (std::size_t i = 0; i < background.size(); ++i) work.opacity[i] = 1 - background[i];
    work.batch.lens.clear();
    makeLinear(work.colors, request_.scene->settings.assumedGamma);
    // One ray a pixel would have been sent without.
    const std::uint64_t more =
        sent.rays - before - std::min<std::uint64_t>(sent.rays - before, work.pixels.size());
    work.meter(StageKind::focalBlur).rays += more;
    sent.rays -= more;
    return drawn;
}

bool Picture::shade(std::span<const SampleBatch::PixelPosition> places, std::span<const glm::dvec2> lens,
                    TileScratch& work, const std::function<bool()>& stopped,
                    std::vector<glm::dvec4>& colors) const {
    colors.clear();
    for (std::size_t first = 0; first < places.size(); first += work.batchRays) {
        if (stopped()) return false;
        const std::size_t count = std::min(work.batchRays, places.size() - first);
        work.batch.places.assign(places.begin() + static_cast<std::ptrdiff_t>(first),
                                 places.begin() + static_cast<std::ptrdiff_t>(first + count));
        const auto through = lens.empty() ? lens : lens.subspan(first, count);
        work.batch.lens.assign(through.begin(), through.end());
        if (!runStages(work, stopped) || work.context.stop.stop_requested()) return false;
        for (std::size_t i = 0; i < count; ++i)
            colors.emplace_back(work.batch.colors[i], request_.transparent ? work.backgroundSeen[i] : 0);
    }
    // Nothing, NaN neither, is darker than black.
    for (glm::dvec4& color : colors) color = glm::max(glm::dvec4(0), color);
    return true;
}

void Picture::sendRays(TileScratch& work) const {
    work.startMeter();
    work.batch.begin();
    if (secondaryRays_) SecondaryRays::begin(work);
    if (request_.transparent) beginBackgroundSeen(work);
    if (primaryRays_) primaryRays_->run(work, work.batch);
}

bool Picture::runStages(TileScratch& work, const std::function<bool()>& stopped) const {
    sendRays(work);
    return followRays(work, stopped);
}

bool Picture::followRays(TileScratch& work, const std::function<bool()>& stopped) const {
    for (const auto& stage : stages_) stage->run(work, work.batch);
    noteBackgroundSeen(work, work.batch);
    if (secondaryRays_ && !secondaryRays_->follow(work, stages_, stopped)) return false;
    countBatch(work);
    return true;
}

void Picture::countBatch(TileScratch& work) const {
    if (work.context.rootFinder == RootFinder::certified)
        countCertainties(work, request_.verdicts.get());
    else
        countHits(work);
}

RenderStatistics Picture::emptyStatistics() const {
    RenderStatistics statistics;
    statistics.leftOut = plan_.leftOut;
    statistics.notCalledFor = plan_.notCalledFor;
    for (const PlannedStage& stage : plan_.stages) statistics.stages.push_back({stage.kind, stage.reason});
    for (const SceneIsosurface& isosurface : request_.scene->isosurfaces)
        statistics.gradients.push_back({isosurface.shape ? isosurface.shape->settings().maxGradient : 0});
    return statistics;
}

void Picture::collect(const TileScratch& work, RenderStatistics& statistics) const {
    for (std::size_t i = 0; i < plan_.stages.size(); ++i) {
        const StageMeter& meter = work.meters[static_cast<std::size_t>(plan_.stages[i].kind)];
        statistics.stages[i].rays += meter.rays;
        statistics.stages[i].blocked += meter.blocked;
        statistics.stages[i].evaluations += meter.evaluations;
        statistics.stages[i].cpuSeconds += meter.cpuSeconds;
        statistics.rays += meter.rays;
        statistics.evaluations += meter.evaluations;
    }
    statistics.cpuSeconds += work.cpuSeconds();
    statistics.cutSamples += work.cutSamples;
    for (std::size_t verdict = 0; verdict < verdictCount; ++verdict)
        if (work.verdicts[verdict] > 0) statistics.verdicts[verdictName(verdict)] += work.verdicts[verdict];
}

void Picture::collectGradients(const TileScratch& work, RenderStatistics& statistics) const {
    for (std::size_t i = 0; i < statistics.gradients.size(); ++i)
        if (const auto& shape = request_.scene->isosurfaces[i].shape)
            if (const auto seen = shape->gradientReport(work.context))
                mergeGradient(*seen, statistics.gradients[i]);
}

}  // namespace isoscope

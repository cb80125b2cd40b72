// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_study.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "widgets/background_priority.h"
#include "widgets/either_stop.h"
#include "widgets/refused_memory.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// Of the view in which pixels are counted.
constexpr int viewWidth = 160;
/// Boxes for each isosurface: the quick look decides most of them, and those that take long come last.
constexpr std::uint64_t quickLook = 20'000;
constexpr std::uint64_t longerLooks[] = {60'000, 200'000, GradientStudySettings().boxLimit};
/// A slice of a proof should take no longer than this, in milliseconds: so soon it gives way.
constexpr double sliceTime = 3;
constexpr std::uint64_t firstSlice = 100, longestSlice = 5'000;
constexpr int oneThread = 1;

}  // namespace

struct VerdictStudy::Work {
    Job job;
    std::stop_token stop;
    std::vector<std::shared_ptr<GradientProof>> proofs;  ///< by isosurface; null for those without a setting
    std::vector<std::size_t> order;
    std::optional<SettingEffects> effects;
    std::vector<std::optional<double>> wastes;
    Clock::time_point told{};
    std::size_t decided = 0;

    RenderRequest view() const {
        RenderRequest request;
        request.scene = job.scene;
        request.camera = job.camera;
        request.width = viewWidth;
        request.height = std::clamp(viewWidth * job.size.height() / job.size.width(), 1, 4 * viewWidth);
        return request;
    }

    SurfaceVerdict verdictOf(std::size_t i) const {
        SurfaceVerdict verdict;
        verdict.isosurface = i;
        verdict.setting = job.scene->isosurfaces[i].shape->rootSettings().maxGradient;
        verdict.bracket = proofs[i]->bracket();
        if (effects) {
            verdict.effects = effects->surfaces[i];
            verdict.pixels = effects->pixels;
        }
        verdict.waste = wastes[i];
        return verdict;
    }

    /// Whether a tighter bracket would change neither the verdict nor the value suggested.
    bool settled(std::size_t i) const {
        const SurfaceVerdict verdict = verdictOf(i);
        return verdict.bracket.state != GradientState::running || (verdict.verdict() && verdict.suggested());
    }

    std::vector<SurfaceVerdict> verdicts() const {
        std::vector<SurfaceVerdict> all;
        for (std::size_t i = 0; i < proofs.size(); ++i)
            if (proofs[i]) all.push_back(verdictOf(i));
        return all;
    }
};

VerdictStudy::VerdictStudy(QObject* parent)
    : QObject(parent), thread_([this](std::stop_token stop) { run(stop); }) {}

VerdictStudy::~VerdictStudy() {
    const std::lock_guard lock(mutex_);
    jobStop_.request_stop();
    holdStop_.request_stop();
}

const SurfaceVerdict* VerdictStudy::verdictOf(std::size_t isosurface) const {
    const auto found = std::ranges::find(verdicts_, isosurface, &SurfaceVerdict::isosurface);
    return found == verdicts_.end() ? nullptr : &*found;
}

void VerdictStudy::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    stopped_ = false;
    submit();
}

void VerdictStudy::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    if (scene_ && !stopped_) submit();
}

void VerdictStudy::stop() {
    if (!busy_) return;
    {
        const std::lock_guard lock(mutex_);
        jobStop_.request_stop();
        waiting_.reset();
    }
    ++generation_;
    busy_ = false;
    stopped_ = true;
    emit changed();
}

void VerdictStudy::goOn() {
    if (!std::exchange(stopped_, false)) return;
    submit();
    emit changed();
}

void VerdictStudy::submit() {
    ++generation_;
    const bool nothing = !scene_ || scene_->isosurfaces.empty();
    {
        const std::lock_guard lock(mutex_);
        jobStop_.request_stop();
        waiting_.reset();
        if (!nothing) waiting_ = Job{generation_, scene_, camera_, size_, chosen_};
    }
    wake_.notify_one();
    busy_ = !nothing;
    if (nothing) receive(generation_, scene_, {}, true);
}

void VerdictStudy::receive(std::uint64_t generation, const std::shared_ptr<const Scene>& scene,
                           std::vector<SurfaceVerdict> verdicts, bool finished) {
    if (generation != generation_) return;
    judged_ = scene;
    verdicts_ = std::move(verdicts);
    busy_ = !finished;
    emit changed();
}

void VerdictStudy::setHeld(bool held) {
    {
        const std::lock_guard lock(mutex_);
        if (held == std::exchange(held_, held)) return;
        if (held) holdStop_.request_stop();
    }
    wake_.notify_one();
}

void VerdictStudy::run(std::stop_token stop) {
    lowerThreadPriority();
    while (!stop.stop_requested()) {
        Work work;
        {
            std::unique_lock lock(mutex_);
            if (!wake_.wait(lock, stop, [this] { return waiting_ && !held_; })) return;
            work.job = *std::exchange(waiting_, std::nullopt);
            jobStop_ = std::stop_source();
            work.stop = jobStop_.get_token();
        }
        const std::stop_callback onClose(stop, [this] {
            jobStop_.request_stop();
            wake_.notify_all();
        });
        doneUnlessMemoryIsRefused([&] { judge(work); });
    }
}

bool VerdictStudy::mayGoOn(const Work& work) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, work.stop, [this] { return !held_; });
    return !work.stop.stop_requested();
}

void VerdictStudy::judge(Work& work) {
    adoptProofs(work);
    tell(work);
    prove(work, quickLook);
    countPixels(work);
    for (const std::uint64_t boxes : longerLooks) prove(work, boxes);
    countPixels(work);
    if (!work.stop.stop_requested()) tell(work, true);
}

void VerdictStudy::adoptProofs(Work& work) {
    const Scene& scene = *work.job.scene;
    for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i) {
        const auto& shape = scene.isosurfaces[i].shape;
        const bool judged = shape && !shape->settings().certifiedOnly;
        work.proofs.push_back(judged ? proofs_->proofOf(scene, i) : nullptr);
        if (judged) work.order.push_back(i);
    }
    work.wastes.resize(work.proofs.size());
    std::stable_partition(work.order.begin(), work.order.end(),
                          [&](std::size_t i) { return i == work.job.chosen; });
    for (const auto& proof : lastProofs_)
        if (proof && std::ranges::find(work.proofs, proof) == work.proofs.end()) proof->suspend();
    lastProofs_ = work.proofs;
}

void VerdictStudy::prove(Work& work, std::uint64_t boxesEach) {
    for (const std::size_t i : work.order) {
        std::uint64_t slice = firstSlice;
        GradientProof& proof = *work.proofs[i];
        while (!work.settled(i) && proof.bracket().boxes < boxesEach && mayGoOn(work)) {
            const auto hold = beginUnheld();
            if (!hold) continue;
            const EitherStop either(work.stop, *hold);
            const Clock::time_point begin = Clock::now();
            ++slices_;
            proof.advance(slice, work.stop, either.token());
            const double taken = Milliseconds(Clock::now() - begin).count();
            slice = std::clamp(static_cast<std::uint64_t>(static_cast<double>(slice) * sliceTime /
                                                          std::max(taken, sliceTime / 2)),
                               firstSlice, longestSlice);
            tell(work);
        }
        if (work.stop.stop_requested()) return;
    }
    tell(work);
}

std::optional<std::stop_token> VerdictStudy::beginUnheld() {
    const std::lock_guard lock(mutex_);
    holdStop_ = std::stop_source();
    if (held_) return {};
    return holdStop_.get_token();
}

template <typename Result, typename Trace>
Result VerdictStudy::uninterrupted(Work& work, const Trace& trace) {
    while (mayGoOn(work)) {
        const auto hold = beginUnheld();
        if (!hold) continue;
        const EitherStop either(work.stop, *hold);
        Result result = trace(either.token());
        if (!either.requested()) return result;
    }
    return {};
}

void VerdictStudy::countPixels(Work& work) {
    const std::vector<SurfaceVerdict> verdicts = work.verdicts();
    const bool wasteful = std::ranges::any_of(verdicts, [&](const SurfaceVerdict& one) {
        return one.verdict() == GradientVerdict::wasteful && !work.wastes[one.isosurface];
    });
    const bool mayLose = std::ranges::any_of(verdicts, &SurfaceVerdict::mayLose);
    if (!work.effects && (mayLose || wasteful)) {
        ++views_;
        SettingEffects effects = uninterrupted<SettingEffects>(
            work, [&](std::stop_token stop) { return settingEffects(work.view(), oneThread, stop); });
        if (!effects.complete) return;
        work.effects = std::move(effects);
        tell(work);
    }
    for (const SurfaceVerdict& one : verdicts) {
        const auto better = one.suggested();
        if (one.verdict() != GradientVerdict::wasteful || !better || work.wastes[one.isosurface]) continue;
        work.wastes[one.isosurface] = uninterrupted<std::optional<double>>(work, [&](std::stop_token stop) {
            return costBeside(work.view(), one.isosurface, *better, work.effects->evaluations, oneThread,
                              stop);
        });
        tell(work);
    }
}

void VerdictStudy::tell(Work& work, bool finished) {
    if (work.stop.stop_requested()) return;
    std::vector<SurfaceVerdict> verdicts = work.verdicts();
    const auto decided = static_cast<std::size_t>(
        std::ranges::count_if(verdicts, [](const SurfaceVerdict& one) { return one.verdict().has_value(); }));
    const Clock::time_point now = Clock::now();
    const bool due = Milliseconds(now - work.told).count() >= timing::progressInterval;
    if (!finished && !due && decided == work.decided) return;
    work.told = now;
    work.decided = decided;
    QMetaObject::invokeMethod(
        this,
        [this, generation = work.job.generation, scene = work.job.scene, verdicts = std::move(verdicts),
         finished]() mutable { receive(generation, scene, std::move(verdicts), finished); },
        Qt::QueuedConnection);
}

}  // namespace isoscope

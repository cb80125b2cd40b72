// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_proof.h"

#include <algorithm>
#include <utility>

#include "core/evaluate/tape/loop_stop.h"
#include "core/study/gradient/function_likeness.h"

namespace isoscope {

GradientProof::GradientProof(std::shared_ptr<const Tape> tape,
                             std::shared_ptr<const std::vector<double>> parameters,
                             const Container& container, GradientStudySettings settings)
    : tape_(std::move(tape)),
      parameters_(std::move(parameters)),
      container_(container),
      settings_(settings) {}

bool GradientProof::isAbout(const Tape& tape, std::span<const double> parameters,
                            const Container& container) const {
    return sameContainer(container_, container) && sameFunction(*tape_, *parameters_, tape, parameters);
}

bool GradientProof::advance(std::uint64_t boxes, std::stop_token stop, std::stop_token pause) {
    const std::lock_guard lock(workMutex_);
    if (settled() || stop.stop_requested()) return !settled();
    const LoopStop loops(stop);
    if (!study_) {
        auto study = std::make_unique<GradientStudy>(tape_, *parameters_, container_, settings_);
        // Sums and products that ended early say nothing.
        if (stop.stop_requested()) return true;
        study_ = std::move(study);
    }
    study_->step(boxes, std::move(pause));
    adopt(study_->bracket());
    if (settled()) study_.reset();
    return !settled();
}

GradientBracket GradientProof::bracket() const {
    const std::lock_guard lock(bracketMutex_);
    return bracket_;
}

void GradientProof::suspend() {
    const std::lock_guard lock(workMutex_);
    study_.reset();
}

void GradientProof::adopt(const GradientBracket& found) {
    const std::lock_guard lock(bracketMutex_);
    // A study that began anew has to catch up first.
    const bool behind = found.state == GradientState::running &&
                        (found.lower < bracket_.lower || found.upper > bracket_.upper);
    if (!behind) bracket_ = found;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gradient/gradient_proofs.h"

#include <algorithm>

namespace isoscope {

std::shared_ptr<GradientProof> GradientProofs::proofOf(const Scene& scene, std::size_t isosurface) {
    if (isosurface >= scene.isosurfaces.size() || !scene.isosurfaces[isosurface].shape) return nullptr;
    const Isosurface& surface = *scene.isosurfaces[isosurface].shape;
    const Container& container = surface.settings().container;
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find_if(proofs_, [&](const auto& proof) {
        return proof->isAbout(*surface.tape(), *scene.parameterTable, container);
    });
    if (known != proofs_.end()) {
        proofs_.splice(proofs_.begin(), proofs_, known);
        return proofs_.front();
    }
    ++begun_;
    proofs_.push_front(
        std::make_shared<GradientProof>(surface.tape(), scene.parameterTable, container, settings_));
    if (proofs_.size() > capacity) proofs_.pop_back();
    return proofs_.front();
}

std::uint64_t GradientProofs::begun() const {
    const std::lock_guard lock(mutex_);
    return begun_;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/tile_scratch_pool.h"

#include <new>

namespace isoscope {

TileScratchPool::Loan TileScratchPool::take(RayOrder order, std::stop_token stop) {
    std::unique_ptr<TileScratch> work = idle();
    if (!work) work = std::make_unique<TileScratch>(picture_.makeWork());
    picture_.begin(*work, order, std::move(stop));
    return {*this, std::move(work)};
}

std::unique_ptr<TileScratch> TileScratchPool::idle() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return nullptr;
    std::unique_ptr<TileScratch> work = std::move(idle_.back());
    idle_.pop_back();
    return work;
}

void TileScratchPool::giveBack(std::unique_ptr<TileScratch> work) noexcept {
    const std::lock_guard lock(mutex_);
    try {
        idle_.push_back(std::move(work));
    } catch (const std::bad_alloc&) {
        // Another one is made where there is memory again.
    }
}

}  // namespace isoscope

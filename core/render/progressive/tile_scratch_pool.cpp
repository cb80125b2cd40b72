// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/tile_work_pool.h"

namespace isoscope {

TileWorkPool::Loan TileWorkPool::take(RayOrder order, std::stop_token stop) {
    std::unique_ptr<TileWork> work = idle();
    if (!work) work = std::make_unique<TileWork>(picture_.makeWork());
    picture_.begin(*work, order, std::move(stop));
    return {*this, std::move(work)};
}

std::unique_ptr<TileWork> TileWorkPool::idle() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return nullptr;
    std::unique_ptr<TileWork> work = std::move(idle_.back());
    idle_.pop_back();
    return work;
}

void TileWorkPool::giveBack(std::unique_ptr<TileWork> work) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(work));
}

}  // namespace isoscope

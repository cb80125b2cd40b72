// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/tables/object_table.h"

namespace isoscope {

double ObjectTable::value(const std::array<double, 3>& p) const {
    std::unique_ptr<TraceContext> context;
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            context = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (!context) context = std::make_unique<TraceContext>(parameters_, RootFinder::lipschitz);
    const bool inside = shape_->contains({p[0], p[1], p[2]}, *context);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(context));
    return inside ? 1 : 0;
}

}  // namespace isoscope

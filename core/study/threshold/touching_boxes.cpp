// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include "core/study/threshold/critical_study.h"

namespace isoscope {

namespace {

constexpr int cells = 128;

/// Groups of numbers that are joined pair by pair.
class Groups {
  public:
    explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }

    std::size_t of(std::size_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = of(a), b = of(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parents_;
};

}  // namespace

std::vector<std::vector<std::size_t>> touchingBoxes(const GradientBox& domain,
                                                    std::span<const GradientBox> boxes) {
    Groups groups(boxes.size());
    std::unordered_map<int, std::size_t> owners;
    const auto cell = [&](double at, int axis) {
        const double width = domain.high[axis] - domain.low[axis];
        const double share = width > 0 ? (at - domain.low[axis]) / width : 0;
        return std::clamp(static_cast<int>(std::floor(share * cells)), 0, cells - 1);
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        int low[3], high[3];
        for (int k = 0; k < 3; ++k) {
            // A little farther than it reaches, so that what touches shares a cell.
            const double nudge = 1e-9 * (domain.high[k] - domain.low[k]);
            low[k] = cell(boxes[i].low[k] - nudge, k);
            high[k] = cell(boxes[i].high[k] + nudge, k);
        }
        for (int x = low[0]; x <= high[0]; ++x)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int z = low[2]; z <= high[2]; ++z) {
                    const auto [owner, isNew] = owners.try_emplace((x * cells + y) * cells + z, i);
                    if (!isNew) groups.join(owner->second, i);
                }
    }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < boxes.size(); ++i) members[groups.of(i)].push_back(i);
    std::vector<std::vector<std::size_t>> answer;
    for (auto& [first, group] : members) answer.push_back(std::move(group));
    return answer;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/function_keeper.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <deque>
#include <utility>

#include "core/evaluate/tape/tape_likeness.h"

namespace isoscope {

namespace {

bool sameBits(std::span<const double> a, std::span<const double> b) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return std::ranges::equal(a, b, {}, bits, bits);
}

/// Those that keepers had last. They live as long as a keeper, or an evaluator, has them.
class RecentFunctions {
  public:
    /// One that computes the same as `made`, which is remembered where there is none.
    std::shared_ptr<const PreparedFunction> oneLike(std::shared_ptr<const PreparedFunction> made) {
        const std::lock_guard lock(mutex_);
        for (const auto& one : functions_)
            if (const auto known = one.lock(); known && same(*known, *made)) return known;
        std::erase_if(functions_, [](const auto& one) { return one.expired(); });
        if (functions_.size() >= most) functions_.pop_front();
        functions_.push_back(made);
        return made;
    }

  private:
    static bool same(const PreparedFunction& a, const PreparedFunction& b) {
        return a.uniforms().sameAs(b.uniforms()) && sameCode(*a.tape(), *b.tape());
    }

    /// Scenes have few functions as a rule; those with thousands shall not search long.
    static constexpr std::size_t most = 64;
    std::mutex mutex_;
    std::deque<std::weak_ptr<const PreparedFunction>> functions_;
};

std::shared_ptr<const PreparedFunction> shared(std::shared_ptr<const PreparedFunction> made) {
    static RecentFunctions recent;
    return recent.oneLike(std::move(made));
}

}  // namespace

std::shared_ptr<const PreparedFunction> FunctionKeeper::prepared(std::span<const double> parameters) const {
    const std::lock_guard lock(mutex_);
    if (kept_ && sameBits(parameters, parameters_)) return kept_;
    // Another keeper's tape may take other parameters for the same numbers.
    const bool ownTape = kept_ && kept_->tape() == tape_;
    kept_ = shared(ownTape ? kept_->with(parameters) : PreparedFunction::of(tape_, parameters));
    parameters_.assign(parameters.begin(), parameters.end());
    return kept_;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/function_keeper.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace isoscope {

namespace {

bool sameBits(std::span<const double> a, std::span<const double> b) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return std::ranges::equal(a, b, {}, bits, bits);
}

}  // namespace

std::shared_ptr<const PreparedFunction> FunctionKeeper::prepared(std::span<const double> parameters) const {
    const std::lock_guard lock(mutex_);
    if (kept_ && sameBits(parameters, parameters_)) return kept_;
    kept_ = kept_ ? kept_->with(parameters) : PreparedFunction::of(tape_, parameters);
    parameters_.assign(parameters.begin(), parameters.end());
    return kept_;
}

}  // namespace isoscope

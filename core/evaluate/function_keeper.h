// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/evaluate/prepared_function.h"

namespace isoscope {

/// The PreparedFunction of a tape for the values of the parameters that were asked for last, so that all who
/// work with the same values share it: threads, and pictures one after the other. Keepers of tapes that
/// compute the same share it, too, while any of them has it: those of a text that was read again, for one.
/// Several threads may ask.
class FunctionKeeper {
  public:
    explicit FunctionKeeper(std::shared_ptr<const Tape> tape) : tape_(std::move(tape)) {}

    /// The function for these values. Values that the function does not depend on make no new one.
    std::shared_ptr<const PreparedFunction> prepared(std::span<const double> parameters) const;

  private:
    std::shared_ptr<const Tape> tape_;
    mutable std::mutex mutex_;
    mutable std::vector<double> parameters_;  ///< those that kept_ is known to be for
    mutable std::shared_ptr<const PreparedFunction> kept_;
};

}  // namespace isoscope

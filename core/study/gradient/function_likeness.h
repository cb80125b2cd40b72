// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/evaluate/tape/tape.h"
#include "core/shapes/rays/container.h"

namespace isoscope {

/// The same values at the same places. NaN is equal to itself only where numbers of functions are compared.
bool sameContainer(const Container& a, const Container& b);

/// Whether two functions compute the same in the same way: their tapes and all numbers in them are equal.
/// Parameters are those that the tapes are run with.
bool sameFunction(const Tape& a, std::span<const double> parametersOfA, const Tape& b,
                  std::span<const double> parametersOfB);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope {

/// Lets the calling thread, and those that it starts, give way to all others of the machine. Does nothing
/// where the system does not let threads have priorities of their own.
void lowerThreadPriority();

}  // namespace isoscope

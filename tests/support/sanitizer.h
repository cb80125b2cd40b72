// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if !defined(__has_feature)
#define __has_feature(name) 0
#endif

namespace isoscope::test {

/// Whether the program checks its addresses, for which it takes some times as much memory.
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
inline constexpr bool checksAddresses = true;
#else
inline constexpr bool checksAddresses = false;
#endif

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <QString>

namespace isoscope {

/// "99.999 %": `part` of `whole` with one decimal, or as many as it takes not to look like nothing or like
/// all. Only nothing is "0 %", only all is "100 %". Empty when there is no whole.
QString formatShare(std::uint64_t part, std::uint64_t whole);

/// "432 640", with narrow spaces that do not break.
QString formatCount(std::uint64_t count);

}  // namespace isoscope

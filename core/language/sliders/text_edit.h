// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace isoscope {

/// A change of a text: `text` in the place of the bytes from `begin` to before `end`.
struct TextEdit {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::string text;
};

}  // namespace isoscope

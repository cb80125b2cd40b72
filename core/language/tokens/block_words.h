// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Lists of words that several blocks have: with which modifiers and colours begin.
constexpr const char* transformWords = "translate rotate scale matrix transform ";
constexpr const char* colorWords = "color colour rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft red green blue ";

/// The words that may begin an item of a block ("isosurface", "camera", "pigment", ...), for "did you mean".
/// Of a block that is not known: those that may stand in any. The block "" is the scene itself.
const std::vector<std::string>& wordsOfBlock(std::string_view block);

}  // namespace isoscope

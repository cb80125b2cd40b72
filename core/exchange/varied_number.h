// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/language/parse.h"

namespace isoscope {

/// A number of a scene that is to have another value.
struct NumberSetting {
    std::size_t parameter = 0;  ///< its number among the scene's parameters
    double value = 0;
};

/// What a text calls a number, or why it cannot be told.
struct FoundNumber {
    std::optional<std::size_t> parameter;
    std::string problem;  ///< one sentence; empty where the number is found
};

/// The number of the user's own text that is called so: "Minor Radius", "f_torus Minor Radius", "R",
/// "threshold"; in any case of letters. `line`, where positive, is that of the number in the text.
FoundNumber findNumber(const ParseResult& parsed, std::string_view name, int line = 0);

/// The scene with other values for some of its numbers: at once where they are parameters of functions, else
/// by another parse of the text. Null when that has errors.
std::shared_ptr<const Scene> sceneWithNumbers(const ParseResult& parsed,
                                              std::span<const NumberSetting> values);

}  // namespace isoscope

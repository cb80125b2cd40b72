// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/language/sliders/text_edit.h"

namespace isoscope {

/// A named set of values of a text's sliders, kept in a line of its own:
/// `// preset "Thin": R = 0.5, f_torus Minor Radius = 0.1`.
struct ValuePreset {
    std::string name;
    std::vector<std::pair<std::string, double>> values;  ///< by what the slider is called
};

/// The presets of a text, in order. A line that is not of the form is a comment like any other.
std::vector<ValuePreset> presetsOf(std::string_view text);

/// A name, or what a slider is called, as a preset can hold it: on one line, without the signs `"=,`, no
/// blanks at its ends.
std::string presetWord(std::string_view word);

/// The change that adds a preset in a line behind the last one, or at the end of the text.
TextEdit presetAdded(std::string_view text, const ValuePreset& preset);

/// The change that puts `preset` into the line of number `index` of presetsOf(text), which must be there.
TextEdit presetReplaced(std::string_view text, std::size_t index, const ValuePreset& preset);

/// The change that takes that line away.
TextEdit presetRemoved(std::string_view text, std::size_t index);

}  // namespace isoscope

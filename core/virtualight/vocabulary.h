// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace isoscope::virtualight {

/// A word of VirtuaLight's notation, for editors: what the parser understands.
struct VocabularyWord {
    /// The part that the word plays in a text.
    enum class Kind { statement, shape, modifier, constant, function };
    std::string_view word;
    Kind kind = Kind::statement;
    std::string_view call;  ///< "Sphere(center, radius)"; empty for what has no arguments
};

/// By the order of their kinds, each in the order of the alphabet (docs/povray/virtualight.md, section 2).
std::span<const VocabularyWord> vocabulary();

}  // namespace isoscope::virtualight

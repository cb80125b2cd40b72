// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/language/sliders/text_edit.h"

namespace isoscope {

/// How the slider of a number moves, as a comment behind the number keeps it:
/// `// [0:2:0.01 log decimals 2 locked]`, where step and words may be left out.
struct SliderNote {
    double minimum = 0;
    double maximum = 1;
    double step = 0;           ///< between values, counted from the lower end; 0: as fine as the slider is
    bool logarithmic = false;  ///< equal ratios take equal ways; needs minimum > 0
    int decimals = -1;         ///< that a value is written with; -1: as many as it needs
    bool locked = false;       ///< the slider does not move
    bool operator==(const SliderNote&) const = default;
};

/// Most decimals that a note can ask for.
constexpr int mostDecimals = 15;

/// Whether the ends are finite and in order, the step fits between them, and a logarithmic range is positive.
bool isUsable(const SliderNote& note);

/// The note that begins the text, "[0:2]..."; nothing where none does, or one that is not usable.
std::optional<SliderNote> readSliderNote(std::string_view text);

/// The note as readSliderNote() reads it.
std::string toText(const SliderNote& note);

/// The note of the number that ends before byte `numberEnd`: its comment is on the same line, with nothing
/// but blanks and closing signs `;,)}>` between.
std::optional<SliderNote> sliderNoteBehind(std::string_view text, std::size_t numberEnd);

/// A comment that begins as a note, `[0:1`, and is none.
struct SliderNoteMistake {
    std::size_t begin = 0;  ///< byte of the `[`
    std::size_t end = 0;    ///< behind the `]`, or behind the line without one
    std::string reason;     ///< a sentence
};

/// What is wrong with the note of the number that ends before byte `numberEnd`; nothing where it is right, or
/// where the comment does not begin as one.
std::optional<SliderNoteMistake> sliderNoteMistake(std::string_view text, std::size_t numberEnd);

/// The change that gives the number another note, or takes the one it has away; words of the comment stay.
/// Nothing where more than closing signs follows on the line, so that no comment can belong to the number, or
/// where there is nothing to take away.
std::optional<TextEdit> sliderNoteEdit(std::string_view text, std::size_t numberEnd,
                                       const std::optional<SliderNote>& note);

}  // namespace isoscope

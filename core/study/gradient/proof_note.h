// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/scene.h"
#include "core/study/gradient/gradient_bracket.h"

namespace isoscope {

/// What a comment in front of an isosurface statement says that was proven of it.
struct ProofNote {
    SourceRange range;    ///< the comment
    std::string version;  ///< of the program that wrote it
    double bound = 0;     ///< no gradient in the container is longer
    double accuracy = 0;  ///< in force then
};

/// Whether a note still holds.
enum class NoteState : std::uint8_t {
    holds,   ///< the bound was proven again
    broken,  ///< a longer gradient is met, or the accuracy is another one
    open,    ///< neither is known
};

/// The comment that states bound, method, view and version: several lines, with a newline at the end. Empty
/// where no bound is proven.
std::string proofNote(const GradientBracket& bracket, double accuracy, const Camera& view,
                      std::string_view version);

/// The note that ends, but for blanks, where the statement begins; nothing without one, or when it was
/// changed beyond recognition.
std::optional<ProofNote> noteBefore(std::string_view text, const SourceRange& statement);

/// Compares a note with what is proven now.
NoteState checkNote(const ProofNote& note, const GradientBracket& bracket, double accuracy);

/// What is to be said of a note that does not hold: a sentence.
std::string brokenNoteText(const ProofNote& note, const GradientBracket& bracket, double accuracy);

}  // namespace isoscope

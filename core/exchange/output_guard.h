// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace isoscope {

/// What a program is about to write to a file.
enum class OutputKind { picture, statistics, scene, proof };

/// Why the file that stands at `file` is not replaced unasked: it is none of that kind. "stands there already
/// and is no PNG picture". Empty when there is no file, an empty one, a device, or one that may go: a PNG
/// picture, statistics of a picture, an exported scene that bears the mark of markedExport(), a table
/// of proofs.
std::string whyNotReplaced(const std::filesystem::path& file, OutputKind kind);

/// An exported text under a first line that says so, by which later exports know what they may replace. Both
/// POV-Ray and VirtuaLight take it for a comment.
std::string markedExport(const std::string& text);

}  // namespace isoscope

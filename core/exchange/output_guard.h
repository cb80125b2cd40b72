// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isoscope {

/// What a program is about to write to a file.
enum class OutputKind { picture, statistics, scene, renderSettings, mesh, proof };

/// Why the file that stands at `file` is not replaced unasked: it is none of that kind. "stands there already
/// and is no PNG or OpenEXR picture". Empty when there is no file, an empty one, a device, or one that may
/// go: a picture of these, statistics of a picture, an exported scene that bears the mark of markedExport(),
/// settings that begin with renderSettingsMark, a mesh that bears the name of the program, a table of
/// proofs.
std::string whyNotReplaced(const std::filesystem::path& file, OutputKind kind);

/// The beginning of every `.ini` file for POV-Ray that is written.
constexpr std::string_view renderSettingsMark = "; Exported by Isoscope";

/// An exported text under a first line that says so, by which later exports know what they may replace. Both
/// POV-Ray and VirtuaLight take it for a comment.
std::string markedExport(const std::string& text);

}  // namespace isoscope

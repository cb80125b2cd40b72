// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/language/parse_context.h"

namespace isoscope {

/// Finds the texts of `#include` statements: the program's own versions of the standard names first, then
/// what the text itself has written by `#write` (TextFiles), then files beside the including file, beside the
/// scene, and in the library paths. A file is read once and has one number in the SourceLibrary however often
/// it is included.
class IncludeLibrary {
  public:
    /// Bytes; larger include files are refused with a message.
    static constexpr std::uintmax_t fileSizeLimit = 64u << 20;

    explicit IncludeLibrary(ParseContext& context) : context_(context) {}

    /// The answer to an `#include`: a text, or a message for the user. Either `file` or `problem` is set.
    struct Found {
        std::optional<std::uint32_t> file;  ///< its number in the SourceLibrary; empty when there is none
        std::string problem;                ///< why not: a sentence
        std::string hint;                   ///< what helps; may be empty
    };
    /// `name` as written in the statement; backslashes count as slashes. `includer` is the number of the text
    /// that asks.
    Found find(std::string_view name, std::uint32_t includer);

    /// Whether `name` is one of the program's own include files.
    static bool isNative(std::string_view name);
    /// Their names in alphabetical order, functions.inc among them.
    static std::vector<std::string> nativeNames();

  private:
    Found read(const std::filesystem::path& path);

    ParseContext& context_;
    std::map<std::string, std::uint32_t> known_;  ///< by native name or path
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope::test {

/// Something that reads what strangers wrote.
struct FuzzTarget {
    std::string_view name;
    /// Reads the bytes to their end, whatever they are; anything but a return is a find.
    void (*read)(std::string_view bytes);
    /// Endings of the files of the examples and of tests/data that it reads, separated by blanks.
    std::string_view endings;
    bool isText = false;  ///< scene_mutator.h makes sense of it
};

/// scene, function, virtualight, image, font, density, table.
std::span<const FuzzTarget> fuzzTargets();

/// The inputs that come with the sources: tests/fuzz/corpus/NAME, the examples and tests/data, up to 64 kB
/// each; for kinds of files that are not there some are made.
std::vector<std::string> corpusOf(const FuzzTarget& target);

}  // namespace isoscope::test

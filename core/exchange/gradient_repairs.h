// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/language/parse.h"
#include "core/text/text_change.h"

namespace isoscope {

/// New values of max_gradient for a scene and its include files, every other character kept. Of several
/// isosurfaces that one statement makes the largest value counts.
class GradientRepairs {
  public:
    /// `parsed` must outlive the object.
    explicit GradientRepairs(const ParseResult& parsed) : parsed_(parsed) {}

    /// Isosurface `number` is to have this value. False when it cannot be written where the statement stands,
    /// or is not finite.
    bool add(std::size_t number, double value);

    /// Texts that change, by their numbers; 0 is the scene itself.
    std::vector<std::uint32_t> files() const;
    /// The changes of one of them, in the order of their places.
    std::vector<TextChange> changes(std::uint32_t file) const;
    /// A text with its changes.
    std::string text(std::uint32_t file) const;

    /// Why file `file` is not to be written for the scene of that path, as a part of a sentence ("it
    /// stands in another folder than the scene"): only files in the scene's folder or below are, and only
    /// while they are what was read. Empty when it may be.
    static std::string obstacle(const ParseResult& parsed, std::uint32_t file,
                                const std::filesystem::path& scene);

  private:
    const ParseResult& parsed_;
    std::map<std::uint32_t, std::map<std::uint32_t, std::pair<double, TextChange>>> changes_;
};

}  // namespace isoscope

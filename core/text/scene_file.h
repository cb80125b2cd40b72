// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace isoscope {

/// Larger files are no scenes; what reading makes of them takes several times their size.
constexpr std::uintmax_t sceneFileLimit = std::uintmax_t{128} << 20;

/// The bytes of a scene file. Nothing, and a sentence about the file in `problem`, where it cannot be read,
/// is no regular file (a pipe may keep its reader waiting for ever), or is larger than sceneFileLimit.
std::optional<std::string> readSceneText(const std::filesystem::path& file, std::string& problem);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/exchange/virtualight_shapes.h"
#include "core/language/parse.h"

namespace isoscope {

/// What a VirtuaLight text becomes: the text for POV-Ray, and the images that it refers to.
struct VirtualightExport {
    std::string text;
    HeightImages images;

    /// Where write() puts the images.
    std::vector<std::filesystem::path> imagesBeside(const std::filesystem::path& file) const;
    /// Writes the text, marked as an export, to `file` and the images beside it, each whole. Says which one
    /// cannot be written and why; empty when all are.
    std::string write(const std::filesystem::path& file) const;
};

/// A VirtuaLight text as a scene for POV-Ray 3.7: each shape as the object of POV-Ray that is the same
/// surface (the table in core/exchange/virtualight_shapes.h), declared names kept, seen by `camera`. A
/// comment stands for what cannot be written. `parsed` comes from parseVirtualight(); `stem` is the name of
/// the file that the text is for, without its ending.
VirtualightExport exportVirtualight(const ParseResult& parsed, const Camera& camera,
                                    const std::string& stem = "scene");

/// The same objects without camera, lights and settings, for `#include` in a scene; "" when none is shown.
VirtualightExport virtualightObjects(const ParseResult& parsed, const std::string& stem = "scene");

}  // namespace isoscope

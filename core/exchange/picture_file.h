// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "core/render/render_request.h"
#include "core/render/render_statistics.h"

namespace isoscope {

/// How a picture is stored. OpenEXR has the layers of ExrStream.
enum class PictureFormat { png, openExr };

/// By the ending of its name, in any case; none for another than `.png` and `.exr`.
std::optional<PictureFormat> pictureFormat(const std::filesystem::path& file);

/// How a picture is drawn into a file.
struct PictureFileOptions {
    PictureFormat format = PictureFormat::png;
    int bits = 8;     ///< of a channel of a PNG: 8 or 16
    int threads = 0;  ///< 0 means all
    /// A picture that was stopped is written, with the rest black; but for OpenEXR where the rest has more
    /// than largestExrRest pixels, which would take long.
    bool keepStopped = false;
    static constexpr std::int64_t largestExrRest = std::int64_t{1} << 23;
};

/// What became of it.
struct PictureFileResult {
    std::string problem;   ///< why there is no file; empty when there is one
    bool stopped = false;  ///< then there is none, unless it is kept
    bool kept = false;     ///< it was stopped, and is written all the same, with the rest black
    RenderStatistics statistics;
};

/// Draws `request` into `file`, whole or not at all (GrowingFile), a strip of rows at a time: pictures of any
/// size up to StripRenderer::longestSide take little memory. `report` is told the share that is drawn, from
/// any thread.
PictureFileResult writePictureFile(const std::filesystem::path& file, const RenderRequest& request,
                                   const PictureFileOptions& options, std::stop_token stop = {},
                                   const std::function<void(double share)>& report = {});

}  // namespace isoscope

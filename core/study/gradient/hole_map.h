// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/render/image.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// A pixel of POV-Ray's method beside the certified result.
enum class HolePixel : std::uint8_t {
    background,  ///< nothing is hit by either
    right,       ///< the same surface
    lost,        ///< a hole: the surface is there, POV-Ray's method misses it
    gained,      ///< POV-Ray's method hits where nothing is
    wrongPlace,  ///< POV-Ray's method hits another sheet, or further off than accuracy explains
};

/// A picture of POV-Ray's mistakes: one HolePixel for each pixel of a view.
struct HoleMap {
    int width = 0;
    int height = 0;
    std::vector<HolePixel> pixels;          ///< row by row from the top
    std::array<std::uint64_t, 5> counts{};  ///< by HolePixel
    bool complete = false;                  ///< false when tracing was stopped

    /// Pixels of one kind, as compareViews() counted them.
    std::uint64_t count(HolePixel kind) const { return counts[static_cast<std::size_t>(kind)]; }
    /// Pixels of any kind of mistake.
    std::uint64_t mistakes() const {
        return count(HolePixel::lost) + count(HolePixel::gained) + count(HolePixel::wrongPlace);
    }
};

/// Compares two views of the same size. Hits further apart than `tolerance` are on different sheets.
HoleMap compareViews(const TracedView& tested, const TracedView& truth, double tolerance);

/// Traces the request with both root finders and its present settings; the request's own root finder is
/// ignored.
HoleMap holeMap(RenderRequest request, int threads = 0, std::stop_token stop = {},
                const ShareReport& report = {});

/// How far apart two hits of the scene may be because of `accuracy` alone.
double sheetTolerance(const Scene& scene);

/// Grey where right, black where nothing is; lost red, gained blue, wrong place yellow.
Image picture(const HoleMap& map);

}  // namespace isoscope

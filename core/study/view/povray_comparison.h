// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/render/image.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// Why a pixel of POV-Ray's own picture differs from the exact one, as far as the root finders tell.
enum class DifferenceCause : std::uint8_t {
    none,        ///< it does not: no channel is off by more than PovrayComparison::tolerance
    hole,        ///< POV-Ray's method misses the surface: max_gradient is too low
    gained,      ///< POV-Ray's method hits where nothing is
    wrongSheet,  ///< POV-Ray's method hits another sheet
    accuracy,    ///< the same surface, but POV-Ray's method gives other shades: by `accuracy`
    jump,        ///< the function jumps or has a pole there
    outline,     ///< beside it something else is seen: edges fall differently by a part of a pixel
    leftOut,     ///< the scene has effects that are not simulated here
    unknown,
};
constexpr std::size_t differenceCauseCount = static_cast<std::size_t>(DifferenceCause::unknown) + 1;

/// "hole", "outline": static text.
const char* name(DifferenceCause cause);

/// POV-Ray's own picture beside the exact one.
struct PovrayComparison {
    static constexpr int tolerance = 8;  ///< of 255

    int width = 0;
    int height = 0;
    std::vector<DifferenceCause> causes;    ///< of each pixel, row by row from the top
    std::vector<std::uint8_t> differences;  ///< the largest of the channels, of 255
    std::array<std::uint64_t, differenceCauseCount> counts{};
    double mean = 0;  ///< over all channels, of 255
    Image exact;
    bool complete = false;  ///< false when it was stopped, or the sizes are not the same

    /// Pixels of one cause.
    std::uint64_t count(DifferenceCause cause) const { return counts[static_cast<std::size_t>(cause)]; }
    /// Pixels that differ.
    std::uint64_t differing() const { return causes.size() - count(DifferenceCause::none); }
};

/// Draws the request exactly and by POV-Ray's method, and tells why `povray`, a picture of the same view and
/// size, differs. `leavesOut`: the scene has effects that are not simulated. Smooth edges, and the request's
/// own root finder, are left aside.
PovrayComparison compareWithPovray(RenderRequest request, const Image& povray, bool leavesOut,
                                   int threads = 0, std::stop_token stop = {},
                                   const ShareReport& report = {});

/// Grey, the darker the more alike; what differs has the colour of its cause (differenceColor).
Image picture(const PovrayComparison& comparison);
/// 0xffRRGGBB; the colours are told apart by brightness, too.
std::uint32_t differenceColor(DifferenceCause cause);

}  // namespace isoscope

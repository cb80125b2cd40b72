// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/render/image.h"
#include "core/study/view/traced_view.h"

namespace isoscope {

/// Why evaluations along a ray are spent.
enum class CostCause : std::uint8_t {
    emptySpace,   ///< outside of the smallest container that is proven to show the same (ContainerFit)
    surface,      ///< to find the surface, or pass it by, where nothing makes that dear
    steepField,   ///< steps far shorter than the way to the surface, by the slope of f there
    grazingRay,   ///< the ray runs along the surface
    singularity,  ///< f is undefined, infinitely steep, or jumps nearby
};
constexpr std::size_t costCauseCount = 5;

/// A word for it, e.g. "empty space": static text.
std::string_view name(CostCause cause);

/// Evaluations by cause.
using CauseCounts = std::array<std::uint64_t, costCauseCount>;

/// What each pixel of a view takes in evaluations of isosurface functions, by cause. Each ray is traced by
/// itself: with POV-Ray's root finder the sum is that of a picture without light; with the certified one,
/// which shares work between neighbours, it is what the rays would take alone.
struct CostMap {
    int width = 0;
    int height = 0;
    std::vector<CauseCounts> pixels;  ///< row by row from the top
    CauseCounts totals{};             ///< of all pixels
    std::uint64_t dearest = 0;        ///< evaluations of the pixel that takes most
    bool complete = false;            ///< false when stopped, or when the request cannot be drawn

    /// Of all pixels and causes.
    std::uint64_t evaluations() const;
};

/// Traces the rays of the request with its root finder, in tiles as the renderer does, and looks once more at
/// each that has cost anything: where along it the steps are that its root finder takes. `threads` 0 means
/// all cores.
CostMap costMap(const RenderRequest& request, int threads = 0, std::stop_token stop = {},
                const ShareReport& report = {});

/// Linear red, green and blue that stand for a cause in pictures, apart in lightness as well as in hue.
std::array<float, 3> costColor(CostCause cause);
/// Black where nothing is evaluated; else the mean colour of the causes, the brighter the more evaluations,
/// on a logarithmic scale up to the dearest pixel.
Image picture(const CostMap& map);

}  // namespace isoscope

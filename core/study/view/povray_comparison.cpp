// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/povray_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/render/picture.h"
#include "core/render/render_image.h"
#include "core/study/gradient/hole_map.h"

namespace isoscope {

namespace {

/// Of the three channels, of 255.
std::array<int, 3> channelDifferences(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    const std::uint32_t first = encodePixel(a), second = encodePixel(b);
    std::array<int, 3> differences{};
    for (std::size_t c = 0; c < 3; ++c) {
        const int shift = 16 - 8 * static_cast<int>(c);
        differences[c] =
            std::abs(static_cast<int>(first >> shift & 0xff) - static_cast<int>(second >> shift & 0xff));
    }
    return differences;
}

int largestDifference(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return std::ranges::max(channelDifferences(a, b));
}

/// What is known of a view, to find causes in.
struct Evidence {
    const Image& povray;
    const Image& exact;
    const Image& byMethod;  ///< by POV-Ray's method, as it is simulated
    const HoleMap& holes;
    const TracedView& traced;  ///< by the certified root finder
    double sheet;              ///< hits further apart are on different sheets
    bool leavesOut;

    /// Whether a neighbour of the pixel shows something else.
    bool besideAnEdge(int x, int y) const {
        const TracedPixel& here = at(x, y);
        for (int row = std::max(0, y - 1); row <= std::min(traced.height - 1, y + 1); ++row)
            for (int column = std::max(0, x - 1); column <= std::min(traced.width - 1, x + 1); ++column) {
                const TracedPixel& there = at(column, row);
                if (here.found != there.found || (here.found && here.kind != there.kind)) return true;
                // Where surfaces are smooth, neighbours are about a pixel's width apart in depth.
                const double pixel = 2 * here.t / std::max(1, traced.width);
                if (here.found && std::abs(here.t - there.t) > 8 * pixel + sheet) return true;
            }
        return false;
    }

    DifferenceCause causeOf(int x, int y) const {
        const auto i = index(x, y);
        const HitKind kind = traced.pixels[i].kind;
        if (traced.pixels[i].found && (kind == HitKind::jump || kind == HitKind::pole))
            return DifferenceCause::jump;
        switch (holes.pixels[i]) {
            case HolePixel::lost: return DifferenceCause::hole;
            case HolePixel::gained: return DifferenceCause::gained;
            case HolePixel::wrongPlace: return DifferenceCause::wrongSheet;
            case HolePixel::background:
            case HolePixel::right: break;
        }
        const bool methodExplains =
            largestDifference(povray.pixels[i], byMethod.pixels[i]) <= PovrayComparison::tolerance;
        if (methodExplains) return DifferenceCause::accuracy;
        if (besideAnEdge(x, y)) return DifferenceCause::outline;
        return leavesOut ? DifferenceCause::leftOut : DifferenceCause::unknown;
    }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(traced.width) +
               static_cast<std::size_t>(x);
    }
    const TracedPixel& at(int x, int y) const { return traced.pixels[index(x, y)]; }
};

void compare(const Evidence& evidence, PovrayComparison& comparison) {
    double sum = 0;
    std::size_t i = 0;
    for (int y = 0; y < comparison.height; ++y)
        for (int x = 0; x < comparison.width; ++x, ++i) {
            const std::array<int, 3> channels =
                channelDifferences(evidence.povray.pixels[i], evidence.exact.pixels[i]);
            sum += channels[0] + channels[1] + channels[2];
            const int largest = std::ranges::max(channels);
            const DifferenceCause cause =
                largest <= PovrayComparison::tolerance ? DifferenceCause::none : evidence.causeOf(x, y);
            comparison.differences.push_back(static_cast<std::uint8_t>(largest));
            comparison.causes.push_back(cause);
            ++comparison.counts[static_cast<std::size_t>(cause)];
        }
    comparison.mean = sum / (3 * static_cast<double>(std::max<std::size_t>(1, i)));
}

}  // namespace

const char* name(DifferenceCause cause) {
    switch (cause) {
        case DifferenceCause::none: return "none";
        case DifferenceCause::hole: return "hole";
        case DifferenceCause::gained: return "gained";
        case DifferenceCause::wrongSheet: return "wrong-sheet";
        case DifferenceCause::accuracy: return "accuracy";
        case DifferenceCause::jump: return "jump";
        case DifferenceCause::outline: return "outline";
        case DifferenceCause::leftOut: return "left-out";
        case DifferenceCause::unknown: break;
    }
    return "unknown";
}

PovrayComparison compareWithPovray(RenderRequest request, const Image& povray, bool leavesOut, int threads,
                                   std::stop_token stop, const ShareReport& report) {
    PovrayComparison comparison;
    if (!Picture::drawable(request) || povray.width != request.width || povray.height != request.height)
        return comparison;
    request.antialias = false;
    request.transparent = false;
    request.verdicts = nullptr;
    const auto tell = [&report](double from, double part) {
        return [&report, from, part](double share) {
            if (report) report(from + part * share);
        };
    };
    request.rootFinder = RootFinder::certified;
    const TracedView traced = traceView(request, threads, stop, tell(0, 0.2));
    Image exact = renderImage(request, threads, nullptr, stop);
    tell(0.2, 0.2)(1);
    const HoleMap holes = holeMap(request, threads, stop, tell(0.4, 0.4));
    request.rootFinder = RootFinder::lipschitz;
    const Image byMethod = renderImage(request, threads, nullptr, stop);
    if (stop.stop_requested() || exact.pixels.empty() || byMethod.pixels.empty()) return comparison;
    comparison.width = request.width;
    comparison.height = request.height;
    compare({povray, exact, byMethod, holes, traced, sheetTolerance(*request.scene), leavesOut}, comparison);
    comparison.exact = std::move(exact);
    comparison.complete = true;
    tell(0.8, 0.2)(1);
    return comparison;
}

std::uint32_t differenceColor(DifferenceCause cause) {
    switch (cause) {
        case DifferenceCause::none: return 0xff000000u;
        case DifferenceCause::hole: return 0xffe51c23u;
        case DifferenceCause::gained: return 0xff3fa9ffu;
        case DifferenceCause::wrongSheet: return 0xffffe05cu;
        case DifferenceCause::accuracy: return 0xff7fd67fu;
        case DifferenceCause::jump: return 0xffb06fe0u;
        case DifferenceCause::outline: return 0xff8c8c8cu;
        case DifferenceCause::leftOut: return 0xffff9a3cu;
        case DifferenceCause::unknown: break;
    }
    return 0xffffffffu;
}

Image picture(const PovrayComparison& comparison) {
    Image image(comparison.width, comparison.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::uint32_t color = differenceColor(comparison.causes[i]);
        // What counts as alike is shown four times as bright, so that it is seen at all.
        const double grey = 4 * comparison.differences[i] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto channel = color >> (16 - 8 * c) & 0xff;
            image.pixels[i][c] = decodeChannel(
                comparison.causes[i] == DifferenceCause::none ? grey : static_cast<double>(channel) / 255.0);
        }
    }
    return image;
}

}  // namespace isoscope

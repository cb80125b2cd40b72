// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/sweep/parameter_sweep.h"

#include <algorithm>
#include <cmath>

#include "core/study/gradient/gradient_study.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope {

namespace {

constexpr double gradientWidth = 0.02;

}  // namespace

std::vector<double> sweepValues(double from, double to, int count, bool logarithmic) {
    if (!std::isfinite(from) || !std::isfinite(to) || count < 1) return {};
    if (count == 1) return {from};
    const bool byRatio = logarithmic && from > 0 && to > 0;
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        const double share = static_cast<double>(k) / (count - 1);
        values.push_back(k == count - 1 ? to
                         : byRatio      ? from * std::pow(to / from, share)
                                        : from * (1 - share) + to * share);
    }
    return values;
}

std::optional<SweepPoint> ParameterSweep::next(std::stop_token stop, int threads) {
    if (done_ >= request_.values.size() || stop.stop_requested()) return {};
    SweepPoint point;
    point.value = request_.values[done_];
    RenderRequest view = request_.view;
    view.scene = request_.sceneAt(point.value);
    const bool there = view.scene && request_.isosurface < view.scene->isosurfaces.size() &&
                       view.scene->isosurfaces[request_.isosurface].shape;
    if (!there) {
        ++done_;
        return point;
    }
    if (request_.ownCamera) view.camera = view.scene->camera;
    view.height = std::max(1, view.height * request_.width / std::max(1, view.width));
    view.width = request_.width;
    for (const RootFinder finder : {RootFinder::lipschitz, RootFinder::certified}) {
        view.rootFinder = finder;
        const TracedView traced = traceView(view, threads, stop);
        if (!traced.complete) return {};
        const auto pixels = static_cast<double>(traced.pixels.size());
        point.evaluationsPerPixel[static_cast<std::size_t>(finder)] =
            static_cast<double>(traced.evaluations) / pixels;
        point.hitShare =
            static_cast<double>(std::ranges::count_if(traced.pixels, &TracedPixel::found)) / pixels;
    }
    const Isosurface& surface = *view.scene->isosurfaces[request_.isosurface].shape;
    GradientStudy study(surface.prepared(*view.scene->parameterTable), surface.settings().container,
                        {gradientWidth, request_.gradientBoxes});
    const GradientBracket& bracket = study.run(stop);
    point.gradientLow = bracket.lower;
    point.gradientHigh = bracket.upper;
    point.solid = SolidGrid(surface, *view.scene->parameterTable, request_.cells, stop).count();
    if (stop.stop_requested()) return {};
    point.known = true;
    ++done_;
    return point;
}

std::string sweepTableHeader() {
    return csvLine({"value", "povray_evaluations", "certified_evaluations", "hit_share", "gradient_low",
                    "gradient_high", "pieces", "tunnels", "hollows"});
}

std::string sweepTableLine(const SweepPoint& point) {
    if (!point.known) return csvLine({exactNumber(point.value), "", "", "", "", "", "", "", ""});
    return csvLine({exactNumber(point.value), exactNumber(point.evaluationsPerPixel[0]),
                    exactNumber(point.evaluationsPerPixel[1]), exactNumber(point.hitShare),
                    exactNumber(point.gradientLow), exactNumber(point.gradientHigh),
                    std::to_string(point.solid.pieces), std::to_string(point.solid.tunnels),
                    std::to_string(point.solid.hollows)});
}

}  // namespace isoscope

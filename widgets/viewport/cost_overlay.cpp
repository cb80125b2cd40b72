// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/cost_overlay.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>
#include <QLocale>
#include <utility>

#include "core/render/image.h"
#include "widgets/studies/share_text.h"

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(CostOverlay)
};

QString countText(std::uint64_t count) { return QLocale::c().toString(static_cast<qulonglong>(count)); }

QString meaningOf(CostCause cause) {
    switch (cause) {
        case CostCause::emptySpace:
            return Words::tr("empty space: a smaller container would save it (%1, %2)");
        case CostCause::surface: return Words::tr("finding the surface (%1, %2)");
        case CostCause::steepField:
            return Words::tr("steep field: f is flatter here than it may be elsewhere (%1, %2)");
        case CostCause::grazingRay: return Words::tr("grazing rays: along the surface (%1, %2)");
        case CostCause::singularity:
            return Words::tr("singularity: f jumps, is undefined or infinitely steep (%1, %2)");
    }
    return {};
}

}  // namespace

RenderRequest costRequest(RenderRequest request) {
    constexpr int widest = 360;
    if (request.width > widest) {
        request.height = std::max(
            1, static_cast<int>(std::lround(static_cast<double>(request.height) * widest / request.width)));
        request.width = widest;
    }
    return request;
}

RenderRequest coarseCostRequest(RenderRequest request) {
    constexpr int side = 4;
    request = costRequest(std::move(request));
    request.width = std::max(1, request.width / side);
    request.height = std::max(1, request.height / side);
    return request;
}

QString costSummary(const CostMap& map) {
    const std::uint64_t all = map.evaluations();
    if (all == 0) return Words::tr("No function is evaluated in this view");
    const double mean =
        static_cast<double>(all) / static_cast<double>(std::max<std::size_t>(1, map.pixels.size()));
    return Words::tr("Evaluations of f by the rays of the camera: %1 for a pixel, at most %2")
        .arg(QString::number(mean, 'g', 3), countText(map.dearest));
}

QList<LegendEntry> costLegend(const CostMap& map) {
    QList<LegendEntry> entries;
    for (std::size_t i = 0; i < costCauseCount; ++i) {
        const auto cause = static_cast<CostCause>(i);
        const auto color = costColor(cause);
        std::uint32_t encoded = 0;
        encodePixels(std::span(&color, 1), std::span(&encoded, 1));
        entries << LegendEntry{
            QColor::fromRgba(encoded),
            meaningOf(cause).arg(countText(map.totals[i]), formatShare(map.totals[i], map.evaluations()))};
    }
    return entries;
}

}  // namespace isoscope

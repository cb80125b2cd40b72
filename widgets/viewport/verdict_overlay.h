// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <QColor>
#include <QImage>
#include <QString>
#include <string>

#include "core/render/verdict_map.h"
#include "widgets/viewport/legend.h"

namespace isoscope {

/// Marks the pixels of which the certified root finder is not certain. Hits and misses that are certain stay
/// as they are.
QImage verdictImage(const VerdictMap& map);

/// The colour of a verdict in verdictImage() and the legend; invalid for those that are not marked.
QColor verdictColor(Verdict verdict);

/// "100 % proven", or "99.999 % proven: 4 unproven pixels", never rounded to all; empty when `verdicts`
/// (RenderStatistics::verdicts) has none of the certified root finder's.
QString verdictSummary(const std::map<std::string, std::uint64_t>& verdicts);

/// What the colours mean, with counts.
QList<LegendEntry> verdictLegend(const std::map<std::string, std::uint64_t>& verdicts);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/verdict_overlay.h"

#include <array>
#include <QCoreApplication>

#include "widgets/studies/share_text.h"

namespace isoscope {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(VerdictOverlay)
};

constexpr std::array<Verdict, 5> all{Verdict::certifiedHit, Verdict::certifiedMiss, Verdict::gap,
                                     Verdict::budgetExceeded, Verdict::notCertified};

std::uint64_t countOf(const std::map<std::string, std::uint64_t>& verdicts, Verdict verdict) {
    const auto entry = verdicts.find(name(verdict));
    return entry == verdicts.end() ? 0 : entry->second;
}

/// What the legend says about a verdict.
QString meaning(Verdict verdict) {
    switch (verdict) {
        case Verdict::certifiedHit: return Words::tr("the surface: proven");
        case Verdict::certifiedMiss: return Words::tr("nothing there: proven");
        case Verdict::gap: return Words::tr("unproven: proven but for places below accuracy/100 (a gap)");
        case Verdict::budgetExceeded:
            return Words::tr("unproven: took too long, so the rest of the ray was sampled");
        case Verdict::notCertified: return Words::tr("unproven: no bounds of the function are known");
    }
    return {};
}

}  // namespace

QColor verdictColor(Verdict verdict) {
    // Told apart by brightness too, for those who do not see the hues.
    switch (verdict) {
        case Verdict::gap: return QColor(0xff, 0xd6, 0x33, 200);
        case Verdict::budgetExceeded: return QColor(0xe6, 0x4a, 0x19, 200);
        case Verdict::notCertified: return QColor(0x8e, 0x24, 0xaa, 150);
        default: return {};
    }
}

QImage verdictImage(const VerdictMap& map) {
    QImage image(map.width(), map.height(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    std::array<QRgb, all.size()> colors{};
    for (const Verdict verdict : all)
        if (const QColor color = verdictColor(verdict); color.isValid())
            colors[static_cast<std::size_t>(verdict)] = qPremultiply(color.rgba());
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x) line[x] = colors[static_cast<std::size_t>(map.at(x, y))];
    }
    return image;
}

QString verdictSummary(const std::map<std::string, std::uint64_t>& verdicts) {
    std::uint64_t sum = 0;
    for (const Verdict verdict : all) sum += countOf(verdicts, verdict);
    if (sum == 0) return {};
    const std::uint64_t proven =
        countOf(verdicts, Verdict::certifiedHit) + countOf(verdicts, Verdict::certifiedMiss);
    const QString share = Words::tr("%1 proven").arg(formatShare(proven, sum));
    if (proven == sum) return share;
    const std::uint64_t rest = sum - proven;
    return share + QStringLiteral(": ") +
           (rest == 1 ? Words::tr("1 unproven pixel")
                      : Words::tr("%1 unproven pixels").arg(formatCount(rest)));
}

QList<LegendEntry> verdictLegend(const std::map<std::string, std::uint64_t>& verdicts) {
    QList<LegendEntry> entries;
    for (const Verdict verdict : all)
        entries << LegendEntry{
            verdictColor(verdict),
            Words::tr("%1  (%2)").arg(meaning(verdict)).arg(formatCount(countOf(verdicts, verdict)))};
    return entries;
}

}  // namespace isoscope

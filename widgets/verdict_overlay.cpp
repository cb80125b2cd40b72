// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdict_overlay.h"

#include <algorithm>
#include <array>
#include <QCoreApplication>

namespace isoscope {

namespace {

QString text(const char* source) { return QCoreApplication::translate("VerdictOverlay", source); }

constexpr std::array<Verdict, 5> all{Verdict::certifiedHit, Verdict::certifiedMiss, Verdict::gap,
                                     Verdict::budgetExceeded, Verdict::notCertified};

std::uint64_t countOf(const std::map<std::string, std::uint64_t>& verdicts, Verdict verdict) {
    const auto entry = verdicts.find(name(verdict));
    return entry == verdicts.end() ? 0 : entry->second;
}

/// What the legend says about a verdict.
QString meaning(Verdict verdict) {
    switch (verdict) {
        case Verdict::certifiedHit: return text("certified hit");
        case Verdict::certifiedMiss: return text("certified miss");
        case Verdict::gap: return text("gap: certain but for places below accuracy/100");
        case Verdict::budgetExceeded: return text("budget exceeded: the rest of the ray was sampled");
        case Verdict::notCertified: return text("not certified: the function has no proven bounds");
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
    const std::uint64_t certain =
        countOf(verdicts, Verdict::certifiedHit) + countOf(verdicts, Verdict::certifiedMiss);
    if (certain == sum) return text("100 % certified");
    QStringList rest;
    const auto add = [&](Verdict verdict, const char* what) {
        if (const std::uint64_t count = countOf(verdicts, verdict)) rest << text(what).arg(count);
    };
    add(Verdict::gap, "%1 gap");
    add(Verdict::budgetExceeded, "%1 over budget");
    add(Verdict::notCertified, "%1 not certified");
    // Never rounded up to all of them.
    const double percent = std::min(99.9, 100.0 * static_cast<double>(certain) / static_cast<double>(sum));
    return text("%1 % certified: %2").arg(percent, 0, 'f', 1).arg(rest.join(QStringLiteral(", ")));
}

QList<LegendEntry> verdictLegend(const std::map<std::string, std::uint64_t>& verdicts) {
    QList<LegendEntry> entries;
    for (const Verdict verdict : all)
        entries << LegendEntry{verdictColor(verdict),
                               text("%1  (%2)").arg(meaning(verdict)).arg(countOf(verdicts, verdict))};
    return entries;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/povray_overlay.h"

#include <QCoreApplication>
#include <QLocale>

namespace isoscope {

namespace {

QString text(const char* source) { return QCoreApplication::translate("PovrayOverlay", source); }

QString countText(std::uint64_t count) { return QLocale::c().toString(static_cast<qulonglong>(count)); }

const char* reasonOf(DifferenceCause cause) {
    switch (cause) {
        case DifferenceCause::none: break;
        case DifferenceCause::hole:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "hole: max_gradient is too low (%1)");
        case DifferenceCause::gained:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "POV-Ray hits where nothing is (%1)");
        case DifferenceCause::wrongSheet:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "another sheet: max_gradient is too low (%1)");
        case DifferenceCause::accuracy:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "other shades, by accuracy (%1)");
        case DifferenceCause::jump:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "the function jumps there (%1)");
        case DifferenceCause::outline:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "outline: a part of a pixel (%1)");
        case DifferenceCause::leftOut:
            return QT_TRANSLATE_NOOP("PovrayOverlay", "not shown here, see Problems (%1)");
        case DifferenceCause::unknown: return QT_TRANSLATE_NOOP("PovrayOverlay", "for another reason (%1)");
    }
    return "";
}

}  // namespace

QString povraySummary(const PovrayComparison& comparison) {
    const QString all = countText(comparison.causes.size());
    if (comparison.differing() == 0)
        return text("POV-Ray's own picture is the exact one in all of %1 pixels").arg(all);
    return text("POV-Ray's own picture differs in %1 of %2 pixels")
        .arg(countText(comparison.differing()), all);
}

QList<LegendEntry> povrayLegend(const PovrayComparison& comparison) {
    QList<LegendEntry> entries;
    for (std::size_t i = 1; i < differenceCauseCount; ++i) {
        const auto cause = static_cast<DifferenceCause>(i);
        if (comparison.count(cause) > 0)
            entries << LegendEntry{QColor::fromRgba(differenceColor(cause)),
                                   text(reasonOf(cause)).arg(countText(comparison.count(cause)))};
    }
    return entries;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_text.h"

#include <cmath>

#include "widgets/numbers/number_text.h"
#include "widgets/studies/share_text.h"

namespace isoscope {

namespace {

/// Pixels of the view that are wrong; nothing while they are not counted.
std::optional<std::uint64_t> mistakes(const SurfaceVerdict& verdict) {
    if (!verdict.effects) return {};
    return verdict.effects->mistakes;
}

}  // namespace

QString VerdictText::number(double gradient) {
    return std::isfinite(gradient) ? QString::number(gradient, 'g', 5) : QStringLiteral("∞");
}

QString VerdictText::place(const glm::dvec3& place) {
    // Below what matters, a zero is easier to read.
    const auto tidy = [](double value) {
        return QString::number(std::abs(value) < 1e-9 ? 0 : value, 'g', 4);
    };
    return QStringLiteral("<%1, %2, %3>").arg(tidy(place.x), tidy(place.y), tidy(place.z));
}

QString VerdictText::hazard(GradientHazard hazard) {
    switch (hazard) {
        case GradientHazard::jump: return tr("a jump");
        case GradientHazard::steepEdge: return tr("an infinite slope");
        case GradientHazard::pole: return tr("a pole");
        case GradientHazard::overflow: return tr("an overflow");
        default: return tr("an unknown bound");
    }
}

QString VerdictText::word(const SurfaceVerdict& verdict) {
    const auto judged = verdict.verdict();
    if (!judged) return tr("being proven");
    switch (*judged) {
        case GradientVerdict::right: return tr("no holes");
        case GradientVerdict::wasteful: return tr("slower than need be");
        case GradientVerdict::unbounded: return tr("infinitely steep");
        case GradientVerdict::unproven: return tr("not proven");
        case GradientVerdict::holes:
            return mistakes(verdict).value_or(0) > 0 ? tr("holes") : tr("may have holes");
    }
    return {};
}

QString VerdictText::plain(const SurfaceVerdict& verdict) {
    const auto judged = verdict.verdict();
    if (!judged) return tr("Whether POV-Ray's picture has holes here is being found out.");
    const std::uint64_t wrong = mistakes(verdict).value_or(0);
    if (wrong > 0 && verdict.mayLose())
        return tr("POV-Ray's picture has holes: it gets %1 of this view wrong.")
            .arg(formatShare(wrong, verdict.pixels));
    switch (*judged) {
        case GradientVerdict::right:
            return tr("POV-Ray's picture has no holes here, from wherever you look.");
        case GradientVerdict::wasteful:
            return verdict.waste && *verdict.waste >= 1.05
                       ? tr("POV-Ray takes %1 times as long for this view as it has to.")
                             .arg(QString::number(*verdict.waste, 'g', 2))
                       : tr("POV-Ray may take longer than it has to.");
        case GradientVerdict::unbounded:
            return mistakes(verdict)
                       ? tr("No holes in this view; other views may have some, whatever the setting.")
                       : tr("The function is infinitely steep somewhere: views may have holes.");
        case GradientVerdict::unproven:
            return mistakes(verdict) ? tr("No holes in this view; whether others have some is not proven.")
                                     : tr("Whether POV-Ray's picture has holes is not proven.");
        case GradientVerdict::holes:
            return mistakes(verdict) ? tr("No holes in this view; other views may have some.")
                                     : tr("POV-Ray's picture may have holes.");
    }
    return {};
}

QString VerdictText::exact(const SurfaceVerdict& verdict) {
    const GradientBracket& bracket = verdict.bracket;
    const QString setting = number(verdict.setting);
    if (bracket.state == GradientState::unbounded && bracket.singularity)
        return tr("max_gradient is %1, but the gradient has no bound: %2 at %3.")
            .arg(setting, hazard(bracket.singularity->kind), place(bracket.singularity->place));
    const auto judged = verdict.verdict();
    if (judged == GradientVerdict::holes)
        return tr("max_gradient is %1, but the gradient is %2 at %3.")
            .arg(setting, number(bracket.lower), place(bracket.place));
    if (bracket.seams) return tr("max_gradient is %1; the function may jump somewhere.").arg(setting);
    if (!std::isfinite(bracket.upper))
        return tr("max_gradient is %1; the gradient is at least %2, and nothing is known above that.")
            .arg(setting, number(bracket.lower));
    if (!judged || *judged == GradientVerdict::unproven)
        return tr("max_gradient is %1; the largest gradient lies between %2 and %3.")
            .arg(setting, number(bracket.lower), number(bracket.upper));
    return tr("max_gradient is %1; it is proven that no gradient exceeds %2.")
        .arg(setting, number(bracket.upper));
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_badge.h"

#include <algorithm>
#include <QEvent>
#include <QMenu>

#include "widgets/interface_style.h"
#include "widgets/numbers/number_text.h"
#include "widgets/studies/share_text.h"
#include "widgets/verdicts/verdict_symbol.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// Of that many isosurfaces the tooltip tells; more would not fit the screen.
constexpr std::size_t toldLimit = 8;

/// What counts for the badge: being proven tells less than that all others are right, and no more.
std::uint64_t mistakesOf(const SurfaceVerdict& verdict) {
    return verdict.effects ? verdict.effects->mistakes : 0;
}

bool worse(const SurfaceVerdict& a, const SurfaceVerdict& b) {
    const int ofA = badness(a.verdict()), ofB = badness(b.verdict());
    return ofA != ofB ? ofA > ofB : mistakesOf(a) > mistakesOf(b);
}

QString nameOf(std::size_t isosurface, const std::vector<int>& lines) {
    const int line = isosurface < lines.size() ? lines[isosurface] : 0;
    return line > 0 ? VerdictBadge::tr("isosurface in line %1").arg(line)
                    : VerdictBadge::tr("isosurface %1").arg(isosurface + 1);
}

QString labelOf(const SurfaceVerdict& worst) {
    QString label = VerdictText::word(worst);
    if (worst.verdict() == GradientVerdict::right) label = VerdictBadge::tr("no holes: proven");
    if (mistakesOf(worst) > 0 && worst.verdict() != GradientVerdict::right)
        label = VerdictBadge::tr("holes: %1").arg(formatShare(mistakesOf(worst), worst.pixels));
    if (worst.verdict() == GradientVerdict::wasteful && worst.waste && *worst.waste >= 1.05)
        label = VerdictBadge::tr("%1 × slower than need be").arg(QString::number(*worst.waste, 'g', 2));
    label[0] = label[0].toUpper();
    return label;
}

}  // namespace

VerdictBadge::VerdictBadge(QWidget* parent) : QToolButton(parent), menu_(new QMenu(this)) {
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setIconEdge(this, 16);
    setWhatsThis(tr(
        "<p>Whether POV-Ray's picture of the isosurfaces of this text has holes, or takes longer than it "
        "has to. This is proven in the background, for every isosurface; the badge tells the worst.</p>"
        "<p>POV-Ray's root finder trusts <b>max_gradient</b>: where the function is steeper, it steps over "
        "the surface. Click to see the numbers in the panel “Gradient”.</p>"));
    connect(this, &QToolButton::clicked, this, [this] { emit chosen(isosurface_); });
    hide();
}

void VerdictBadge::show(const std::vector<SurfaceVerdict>& verdicts, const std::vector<int>& lines,
                        const std::map<std::size_t, double>& needed) {
    setVisible(!verdicts.empty());
    fillMenu(needed, lines);
    if (verdicts.empty()) return;
    std::vector<SurfaceVerdict> sorted = verdicts;
    std::ranges::stable_sort(sorted, worse);
    const SurfaceVerdict& worst = sorted.front();
    isosurface_ = worst.isosurface;
    QString label = labelOf(worst);
    const auto alike = std::ranges::count_if(sorted, [&](const SurfaceVerdict& one) {
        return badness(one.verdict()) == badness(worst.verdict());
    });
    if (sorted.size() > 1) label += tr(" (%1 of %2)").arg(alike).arg(sorted.size());
    setText(label);
    setIconOf(worst.verdict());
    QString tip;
    for (std::size_t i = 0; i < std::min(sorted.size(), toldLimit); ++i) {
        const SurfaceVerdict& one = sorted[i];
        QString name = nameOf(one.isosurface, lines);
        name[0] = name[0].toUpper();
        const QString sentences = VerdictText::plain(one) + ' ' + VerdictText::exact(one);
        tip += QStringLiteral("<p><b>%1</b>: %2</p>").arg(name, sentences.toHtmlEscaped());
    }
    if (sorted.size() > toldLimit) tip += tr("<p>%1 more.</p>").arg(sorted.size() - toldLimit);
    setToolTip(tip);
    setAccessibleName(tr("Verdict on max_gradient: %1").arg(label));
    setAccessibleDescription(VerdictText::plain(worst) + ' ' + VerdictText::exact(worst));
}

void VerdictBadge::fillMenu(const std::map<std::size_t, double>& needed, const std::vector<int>& lines) {
    // A menu that is open stays as it is: what it offers was true when it was opened.
    if (menu_->isVisible()) return;
    if (needed == needed_ && lines == lines_) return;
    needed_ = needed;
    lines_ = lines;
    menu_->clear();
    setPopupMode(needed.empty() ? DelayedPopup : MenuButtonPopup);
    setMenu(needed.empty() ? nullptr : menu_);
    std::size_t left = toldLimit;
    for (const auto& [isosurface, value] : needed) {
        if (left-- == 0) break;
        menu_->addAction(tr("Use %1: %2").arg(numberText(value), nameOf(isosurface, lines)), this,
                         [this, one = std::map{std::pair(isosurface, value)}] { emit mendRequested(one); });
    }
    if (needed.size() < 2) return;
    menu_->addSeparator();
    menu_->addAction(tr("Fix All %1").arg(needed.size()), this,
                     [this, needed] { emit mendRequested(needed); });
}

void VerdictBadge::showReading() {
    if (isHidden()) return;
    fillMenu({}, {});
    setText(tr("Still reading…"));
    setIconOf({});
    setToolTip(tr("The text is still being read; its isosurfaces are judged afterwards."));
    setAccessibleName(tr("Verdict on max_gradient: the text is still being read"));
}

void VerdictBadge::setIconOf(std::optional<GradientVerdict> verdict) {
    const Look look = lookOf(palette());
    if (!icon().isNull() && verdict == verdict_ && look == look_) return;
    verdict_ = verdict;
    look_ = look;
    setIcon(verdictIcon(verdict, look));
}

void VerdictBadge::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) setIconOf(verdict_);
    QToolButton::changeEvent(event);
}

}  // namespace isoscope

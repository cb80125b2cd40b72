// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/viewport_panel.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/elided_label.h"
#include "widgets/icons.h"
#include "widgets/interface_style.h"
#include "widgets/viewport/overlay_bar.h"
#include "widgets/viewport/verdict_overlay.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

QString shortCount(std::uint64_t count) {
    static const struct {
        double unit;
        const char* suffix;
    } scales[] = {{1e9, " G"}, {1e6, " M"}, {1e3, " k"}};
    for (const auto& scale : scales)
        if (static_cast<double>(count) >= scale.unit)
            return QString::number(static_cast<double>(count) / scale.unit, 'g', 3) +
                   QLatin1String(scale.suffix);
    return QString::number(count);
}

ViewportPanel::ViewportPanel(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    tools_ = new QToolBar(tr("View tools"), this);
    setIconEdge(tools_, 18);
    tools_->setAccessibleName(tr("View tools"));
    // The style's own arrow is black on a dark window.
    if (auto* more = tools_->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        const QIcon arrow = themeIcon(QStringLiteral("arrow-right-double"));
        if (!arrow.isNull()) more->setIcon(arrow);
        more->setToolTip(tr("More tools"));
        more->setAccessibleName(tr("More tools"));
    }
    viewport_ = new Viewport;
    layout->addWidget(viewport_, 1);

    overlayBar_ = new OverlayBar(&viewport_->overlay(), viewport_);

    auto* line = new QHBoxLayout;
    line->setContentsMargins(8, 3, 8, 3);
    layout->addLayout(line);
    status_ = new QLabel;
    status_->setAccessibleDescription(tr("State of the picture"));
    status_->setToolTip(tr("How far the picture is, and the time since it began."));
    line->addWidget(status_);
    line->addSpacing(16);
    line->addStretch(1);
    cost_ = new ElidedLabel;
    cost_->setAccessibleDescription(tr("Cost of the picture"));
    cost_->setToolTip(tr(
        "How much of the picture is proven to be right, and what it cost. Exact pictures are proven pixel by "
        "pixel, by the certified root finder; the cost is told in rays and in evaluations of functions."));
    line->addWidget(cost_);
    connect(viewport_, &Viewport::progressed, this, &ViewportPanel::showProgress);
    showProgress({});
}

QString ViewportPanel::status() const { return status_->text() + QLatin1Char(' ') + cost_->text(); }

void ViewportPanel::showProgress(const RenderProgress& progress) {
    if (progress.job == 0) {
        status_->setText(tr("No picture yet"));
        cost_->clear();
        return;
    }
    const QString seconds = QString::number(progress.seconds, 'f', 2);
    if (!progress.finished) {
        status_->setText(
            tr("Pass %1 of %2, %3 s").arg(progress.pass + 1).arg(progress.passCount).arg(seconds));
    } else if (progress.pass < progress.passCount) {
        status_->setText(
            tr("Stopped after pass %1 of %2, %3 s").arg(progress.pass).arg(progress.passCount).arg(seconds));
    } else {
        const QSize size = viewport_->picture().size();
        const QString finished =
            tr("Finished in %1 s, %2 × %3").arg(seconds).arg(size.width()).arg(size.height());
        // Of another picture in the same time a screen reader would not be told.
        if (finished == status_->text() && progress.job != finishedJob_) {
            QAccessibleEvent event(status_, QAccessible::NameChanged);
            QAccessible::updateAccessibility(&event);
        }
        status_->setText(finished);
        finishedJob_ = progress.job;
    }
    const QString cost =
        tr("%1 rays, %2 evaluations")
            .arg(shortCount(progress.statistics.rays), shortCount(progress.statistics.evaluations));
    QString certain = verdictSummary(progress.statistics.verdicts);
    if (!certain.isEmpty() && progress.statistics.rays == 0) certain = tr("Nothing was there to prove");
    cost_->setText(certain.isEmpty() ? cost : certain + QStringLiteral("; ") + cost);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/reading_bar.h"

#include <cmath>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

#include "widgets/elided_label.h"
#include "widgets/icons.h"
#include "widgets/viewport/viewport_panel.h"

namespace isoscope {

ReadingBar::ReadingBar(QWidget* parent) : QFrame(parent) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    // Narrower than its text where the panel is: coming and going, the bar must not move anything.
    text_ = new ElidedLabel;
    text_->setTextFormat(Qt::PlainText);
    text_->setAccessibleDescription(tr("Progress of reading"));
    layout->addWidget(text_, 3);
    share_ = new QProgressBar;
    share_->setRange(0, 100);
    share_->setTextVisible(false);
    share_->setMinimumWidth(30);
    share_->setToolTip(tr("Where in the text is being read; loops lead back"));
    share_->setAccessibleName(tr("Place in the text"));
    layout->addWidget(share_, 1);
    auto* stop = new QPushButton(themeIcon(QStringLiteral("process-stop")), tr("Stop"));
    stop->setToolTip(tr("End the reading of this text; what was shown before stays"));
    stop->setAccessibleName(tr("Stop reading"));
    connect(stop, &QPushButton::clicked, this, &ReadingBar::stopRequested);
    layout->addWidget(stop);
    hide();
}

void ReadingBar::showProgress(double seconds, qulonglong steps, double share) {
    text_->setText(
        tr("Reading the text: %1 s, %2 steps").arg(QString::number(seconds, 'f', 1), shortCount(steps)));
    share_->setValue(static_cast<int>(std::lround(100 * share)));
    show();
}

QString ReadingBar::text() const { return text_->text(); }

}  // namespace isoscope

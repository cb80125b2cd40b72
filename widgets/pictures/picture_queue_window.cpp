// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/picture_queue_window.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "widgets/elided_label.h"
#include "widgets/icons.h"
#include "widgets/pictures/picture_queue.h"

namespace isoscope {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(PictureQueueWindow)
};

/// "12 s", "3 min", "2 h".
QString durationText(double seconds) {
    if (seconds < 90) return Texts::tr("%1 s").arg(qMax(1, qRound(seconds)));
    if (seconds < 5400) return Texts::tr("%1 min").arg(qRound(seconds / 60));
    return Texts::tr("%1 h").arg(seconds / 3600, 0, 'f', 1);
}

QString textOf(const QueuedPicture& picture) {
    switch (picture.state) {
        case QueuedPicture::State::waiting: return Texts::tr("Waits");
        case QueuedPicture::State::drawing:
            return picture.secondsLeft < 0
                       ? Texts::tr("Is rendered…")
                       : Texts::tr("About %1 left").arg(durationText(picture.secondsLeft));
        case QueuedPicture::State::written: return Texts::tr("Written");
        case QueuedPicture::State::stopped: return Texts::tr("Stopped; nothing was written");
        case QueuedPicture::State::failed: break;
    }
    return picture.problem;
}

}  // namespace

PictureQueueWindow::PictureQueueWindow(PictureQueue* queue, QWidget* parent)
    : QDialog(parent), queue_(queue) {
    setWindowTitle(tr("Pictures in the making"));
    auto* layout = new QVBoxLayout(this);
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* inside = new QWidget;
    list_ = new QVBoxLayout(inside);
    list_->setContentsMargins(0, 0, 0, 0);
    none_ = new QLabel(
        tr("No picture is on the way. File ▸ Export ▸ Image… puts them here by its button “Queue”."));
    none_->setWordWrap(true);
    list_->addWidget(none_);
    list_->addStretch(1);
    area->setWidget(inside);
    layout->addWidget(area, 1);
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    stopAll_ = new QPushButton(themeIcon(QStringLiteral("process-stop")), tr("Stop All"));
    stopAll_->setToolTip(tr("Stop every picture that is not written yet"));
    connect(stopAll_, &QPushButton::clicked, queue, &PictureQueue::stopAll);
    clear_ = new QPushButton(tr("Clear List"));
    clear_->setToolTip(tr("Take the pictures off the list that are written or stopped; files stay"));
    connect(clear_, &QPushButton::clicked, queue, &PictureQueue::forgetEnded);
    auto* close = new QPushButton(tr("Close"));
    close->setToolTip(tr("Close; pictures go on"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    buttons->addStretch(1);
    for (QPushButton* button : {stopAll_, clear_, close}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    resize(560, 300);
    connect(queue, &PictureQueue::changed, this, &PictureQueueWindow::showPicture);
    connect(queue, &PictureQueue::forgotten, this, &PictureQueueWindow::forgetEnded);
    for (const QueuedPicture& picture : queue->pictures()) showPicture(picture.number);
    showEmptiness();
}

PictureQueueWindow::Row PictureQueueWindow::makeRow(int number) {
    Row row{new QWidget, new ElidedLabel, new QLabel, new QProgressBar, new QToolButton};
    auto* layout = new QHBoxLayout(row.widget);
    layout->setContentsMargins(0, 2, 0, 2);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(row.name);
    row.state->setWordWrap(true);
    words->addWidget(row.state);
    layout->addLayout(words, 1);
    row.progress->setRange(0, 1000);
    row.progress->setFixedWidth(140);
    layout->addWidget(row.progress, 0, Qt::AlignVCenter);
    row.button->setAutoRaise(true);
    layout->addWidget(row.button, 0, Qt::AlignVCenter);
    connect(row.button, &QToolButton::clicked, this, [this, number] { act(number); });
    list_->insertWidget(list_->count() - 1, row.widget);
    return row;
}

void PictureQueueWindow::showPicture(int number) {
    const QueuedPicture picture = queue_->picture(number);
    if (picture.number == 0) return;
    if (!rows_.contains(number)) rows_[number] = makeRow(number);
    const Row& row = rows_[number];
    const QString name = QFileInfo(picture.file).fileName();
    row.name->setText(tr("%1, %2 × %3").arg(name).arg(picture.size.width()).arg(picture.size.height()));
    row.name->setToolTip(picture.file);
    row.state->setText(textOf(picture));
    row.progress->setValue(static_cast<int>(1000 * picture.share));
    row.progress->setAccessibleName(tr("Progress of %1").arg(name));
    const bool opens = picture.ended();
    row.button->setIcon(themeIcon(opens ? QStringLiteral("document-open") : QStringLiteral("process-stop")));
    const QString what = opens ? tr("Open %1 in the program for images").arg(name) : tr("Stop %1").arg(name);
    row.button->setToolTip(what);
    row.button->setAccessibleName(what);
    row.button->setEnabled(!opens || picture.state == QueuedPicture::State::written);
    showEmptiness();
}

void PictureQueueWindow::forgetEnded() {
    for (auto row = rows_.begin(); row != rows_.end();) {
        if (queue_->picture(row->first).number != 0) {
            ++row;
            continue;
        }
        row->second.widget->deleteLater();
        row->second.widget->hide();
        row = rows_.erase(row);
    }
    showEmptiness();
}

void PictureQueueWindow::showEmptiness() {
    none_->setVisible(rows_.empty());
    stopAll_->setEnabled(queue_->open() > 0);
    clear_->setEnabled(queue_->open() < queue_->pictures().size());
}

void PictureQueueWindow::act(int number) {
    const QueuedPicture picture = queue_->picture(number);
    if (!picture.ended())
        queue_->stop(number);
    else if (picture.state == QueuedPicture::State::written)
        QDesktopServices::openUrl(QUrl::fromLocalFile(picture.file));
}

QString PictureQueueWindow::stateText(int number) const {
    const auto found = rows_.find(number);
    return found == rows_.end() ? QString() : found->second.state->text();
}

QToolButton* PictureQueueWindow::button(int number) const {
    const auto found = rows_.find(number);
    return found == rows_.end() ? nullptr : found->second.button;
}

}  // namespace isoscope

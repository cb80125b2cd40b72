// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/progress_row.h"

#include <cmath>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace isoscope {

namespace {

constexpr int progressSteps = 1000;
constexpr int barWidth = 80;

}  // namespace

ProgressRow::ProgressRow(const Names& names, QWidget* parent)
    : QWidget(parent),
      row_(new QHBoxLayout(this)),
      note_(new QLabel),
      progress_(new QProgressBar),
      button_(new QPushButton) {
    row_->setContentsMargins(0, 0, 0, 0);
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    note_->setAccessibleDescription(names.note);
    row_->addWidget(note_, 1);
    progress_->setRange(0, progressSteps);
    progress_->setFixedWidth(barWidth);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(names.progress);
    progress_->setToolTip(names.progressTip);
    row_->addWidget(progress_);
    button_->setAccessibleName(names.button);
    row_->addWidget(button_);
}

void ProgressRow::add(QWidget* button) { row_->addWidget(button); }

void ProgressRow::setWorking(bool working, const Button& button) {
    progress_->setVisible(working);
    if (!working) setProgress(0);
    button_->setText(button.text);
    button_->setToolTip(button.toolTip);
}

void ProgressRow::setProgress(double done) {
    progress_->setValue(static_cast<int>(std::lround(done * progressSteps)));
}

}  // namespace isoscope

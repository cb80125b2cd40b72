// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_group.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace isoscope {

ParameterGroup::ParameterGroup(QWidget* parent)
    : QWidget(parent),
      heading_(new QToolButton(this)),
      body_(new QWidget(this)),
      rows_(new QVBoxLayout(body_)) {
    heading_->setCheckable(true);
    heading_->setChecked(true);
    heading_->setAutoRaise(true);
    heading_->setArrowType(Qt::DownArrow);
    heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    heading_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    heading_->setFocusPolicy(Qt::StrongFocus);
    QFont font = heading_->font();
    font.setBold(true);
    heading_->setFont(font);
    rows_->setContentsMargins(10, 0, 2, 6);
    rows_->setSpacing(4);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(heading_);
    layout->addWidget(body_);
    connect(heading_, &QToolButton::toggled, this, [this](bool open) {
        body_->setVisible(open);
        heading_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
}

void ParameterGroup::setTitle(const QString& title) {
    if (heading_->text() == title) return;
    heading_->setText(title);
    heading_->setToolTip(tr("Show or hide the parameters of %1").arg(title));
    heading_->setAccessibleName(title);
}

void ParameterGroup::setRows(const QList<QWidget*>& rows) {
    while (QLayoutItem* item = rows_->takeAt(0)) delete item;
    for (QWidget* row : rows) rows_->addWidget(row);
}

bool ParameterGroup::hasShownRows() const {
    for (int i = 0; i < rows_->count(); ++i)
        if (!rows_->itemAt(i)->widget()->isHidden()) return true;
    return false;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/icons.h"

namespace isoscope {

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 4, 6, 4);
    icon_ = new QLabel;
    layout->addWidget(icon_);
    text_ = new QLabel;
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setAccessibleName(tr("Notice"));
    layout->addWidget(text_, 1);
    buttons_ = new QHBoxLayout;
    layout->addLayout(buttons_);
    hide();
}

QString NoticeBar::text() const { return text_->text(); }

void NoticeBar::ask(const QString& text, std::vector<Choice> choices) {
    text_->setText(text);
    icon_->setPixmap(themeIcon(QStringLiteral("dialog-information")).pixmap(16, 16));
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (Choice& choice : choices) addButton(std::move(choice));
    show();
}

void NoticeBar::tell(const QString& text) { ask(text, {{tr("Close"), tr("Hide this line"), {}}}); }

void NoticeBar::addButton(Choice choice) {
    auto* button = new QPushButton(choice.label);
    button->setToolTip(choice.toolTip);
    button->setAccessibleName(choice.label);
    connect(button, &QPushButton::clicked, this, [this, act = std::move(choice.act)] {
        hide();
        // A copy: acting may bring up the next notice, which replaces this button.
        if (const auto then = act) then();
    });
    buttons_->addWidget(button);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/notice_bar.h"

#include <algorithm>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "widgets/verdicts/severity_icon.h"

namespace isoscope {

namespace {

/// A text in less than this, in pixels, is no line any more.
constexpr int leastTextWidth = 280;

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    layout_ = new QHBoxLayout(this);
    layout_->setContentsMargins(10, 4, 6, 4);
    auto* words = new QHBoxLayout;
    icon_ = new QLabel;
    words->addWidget(icon_);
    text_ = new QLabel;
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setObjectName(QStringLiteral("notice"));
    text_->setAccessibleDescription(tr("Notice"));
    words->addWidget(text_, 1);
    more_ = new QLabel;
    more_->setEnabled(false);
    words->addWidget(more_);
    layout_->addLayout(words, 1);
    auto* choices = new QHBoxLayout;
    choices->addStretch(1);
    buttons_ = new QHBoxLayout;
    choices->addLayout(buttons_);
    layout_->addLayout(choices);
    hide();
}

void NoticeBar::floatOver(QWidget* host) {
    host_ = host;
    const bool shown = !isHidden();
    setParent(host);
    host->installEventFilter(this);
    setVisible(shown);
}

QString NoticeBar::text() const { return notices_.empty() ? QString() : notices_.back().text; }

bool NoticeBar::asks(const QString& topic, const QString& text) const {
    return std::any_of(notices_.begin(), notices_.end(), [&](const Notice& notice) {
        return notice.topic == topic && (text.isEmpty() || notice.text == text);
    });
}

void NoticeBar::ask(const QString& text, std::vector<Choice> choices, const QString& topic) {
    std::erase_if(notices_, [&](const Notice& notice) { return notice.topic == topic; });
    notices_.push_back({text, topic, std::move(choices)});
    showLast();
}

void NoticeBar::tell(const QString& text) { ask(text, {{tr("Close"), tr("Hide this line"), {}}}); }

void NoticeBar::withdraw(const QString& topic) {
    if (std::erase_if(notices_, [&](const Notice& notice) { return notice.topic == topic; }) > 0) showLast();
}

void NoticeBar::showLast() {
    const bool focused = isAncestorOf(QApplication::focusWidget());
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        // Acting may bring up the next notice from within a button's own signal.
        item->widget()->hide();
        item->widget()->setParent(nullptr);
        item->widget()->deleteLater();
        delete item;
    }
    if (notices_.empty()) {
        text_->clear();
        if (focused) giveFocusBack();
        hide();
        return;
    }
    const Notice& notice = notices_.back();
    text_->setText(notice.text);
    showIcon();
    const int covered = static_cast<int>(notices_.size()) - 1;
    more_->setVisible(covered > 0);
    more_->setText(tr("%n more", "notices", covered));
    for (std::size_t i = 0; i < notice.choices.size(); ++i) addButton(i);
    fold(width());
    show();
    place();
    raise();
    if (focused) takeFocus();
}

/// A label keeps its picture when the theme changes.
void NoticeBar::showIcon() {
    icon_->setPixmap(severityIcon(Severity::note).pixmap(QSize(16, 16), devicePixelRatioF()));
}

void NoticeBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && icon_) showIcon();
    QFrame::changeEvent(event);
}

void NoticeBar::addButton(std::size_t index) {
    const Choice& choice = notices_.back().choices[index];
    auto* button = new QPushButton(choice.label);
    button->setToolTip(choice.toolTip);
    button->setAutoDefault(true);
    connect(button, &QPushButton::clicked, this, [this, index] { answer(index); });
    buttons_->addWidget(button);
    button->show();  // now, for it may be given the focus
}

void NoticeBar::answer(std::size_t index) {
    if (notices_.empty() || index >= notices_.back().choices.size()) return;
    const std::function<void()> act = std::move(notices_.back().choices[index].act);
    notices_.pop_back();
    showLast();
    if (act) act();
}

void NoticeBar::takeFocus() {
    QWidget* focused = QApplication::focusWidget();
    if (!isAncestorOf(focused)) before_ = focused;
    if (buttons_->count() > 0) buttons_->itemAt(0)->widget()->setFocus(Qt::OtherFocusReason);
}

void NoticeBar::giveFocusBack() {
    if (before_) before_->setFocus(Qt::OtherFocusReason);
    before_ = nullptr;
}

void NoticeBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !notices_.empty())
        answer(notices_.back().choices.size() - 1);
    else
        QFrame::keyPressEvent(event);
}

void NoticeBar::fold(int width) {
    const bool narrow = buttons_->sizeHint().width() + leastTextWidth > width;
    layout_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void NoticeBar::place() {
    if (!host_ || isHidden()) return;
    fold(host_->width());
    layout_->activate();
    setGeometry(0, 0, host_->width(), layout_->totalHeightForWidth(host_->width()));
}

bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == host_ && event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

bool NoticeBar::event(QEvent* event) {
    const bool done = QFrame::event(event);
    // Other fonts, other words: the height follows.
    if (event->type() == QEvent::LayoutRequest) place();
    return done;
}

void NoticeBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fold(width());
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cut_texts.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolButton>

#include "widgets/elided_label.h"

namespace isoscope::test {
namespace {

/// Styles round by as much.
constexpr int tolerance = 1;

void check(QStringList& cut, const QWidget* widget, const QString& text, int has, int wants) {
    if (has + tolerance >= wants) return;
    const QWidget* parent = widget->parentWidget();
    cut << QStringLiteral("%1 in %2 “%3”: %4 of %5")
               .arg(widget->metaObject()->className(), parent ? parent->metaObject()->className() : "nothing",
                    text)
               .arg(has)
               .arg(wants);
}

void checkLabel(QStringList& cut, const QLabel* label) {
    if (label->text().isEmpty() || qobject_cast<const ElidedLabel*>(label)) return;
    // What is scrolled may be as high as it likes.
    const auto* area = label->parentWidget() ? label->parentWidget()->parentWidget() : nullptr;
    if (label->wordWrap() && qobject_cast<const QAbstractScrollArea*>(area)) return;
    if (label->wordWrap())
        check(cut, label, label->text(), label->height(), label->heightForWidth(label->width()));
    else
        check(cut, label, label->text(), label->width(), label->sizeHint().width());
}

void checkTabs(QStringList& cut, const QTabBar* bar) {
    for (int i = 0; i < bar->count(); ++i)
        if (bar->isTabVisible(i))
            check(cut, bar, bar->tabText(i), bar->tabRect(i).width(),
                  bar->fontMetrics().size(Qt::TextShowMnemonic, bar->tabText(i)).width());
}

void checkChoice(QStringList& cut, const QComboBox* box) {
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.editable = box->isEditable();
    const QRect field =
        box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
    check(cut, box, box->currentText(), field.width(),
          box->fontMetrics().horizontalAdvance(box->currentText()));
}

void checkTitles(QStringList& cut, const QHeaderView* titles) {
    if (titles->orientation() != Qt::Horizontal) return;
    for (int i = 0; i < titles->count(); ++i) {
        const QString text = titles->model()->headerData(i, Qt::Horizontal).toString();
        if (!titles->isSectionHidden(i) && !text.isEmpty())
            check(cut, titles, text, titles->sectionSize(i), titles->fontMetrics().horizontalAdvance(text));
    }
}

}  // namespace

QStringList cutTexts(const QWidget* root) {
    QStringList cut;
    QList<QWidget*> all = root->findChildren<QWidget*>();
    all << const_cast<QWidget*>(root);
    for (const QWidget* widget : all) {
        if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            const auto* tool = qobject_cast<const QToolButton*>(button);
            const bool icon =
                tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull();
            if (!button->text().isEmpty() && !icon)
                check(cut, button, button->text(), button->width(), button->sizeHint().width());
        }
        if (const auto* label = qobject_cast<const QLabel*>(widget)) checkLabel(cut, label);
        if (const auto* bar = qobject_cast<const QTabBar*>(widget)) checkTabs(cut, bar);
        if (const auto* box = qobject_cast<const QComboBox*>(widget)) checkChoice(cut, box);
        if (const auto* titles = qobject_cast<const QHeaderView*>(widget)) checkTitles(cut, titles);
    }
    return cut;
}

}  // namespace isoscope::test

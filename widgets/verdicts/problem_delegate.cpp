// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/problem_delegate.h"

#include <algorithm>
#include <QApplication>
#include <QPainter>
#include <QTreeView>

#include "widgets/editor/code_words.h"

namespace isoscope {
namespace {

constexpr int padding = 3;
constexpr int narrowest = 60;  ///< narrower columns cut the text off instead of stacking single words
int iconSpace(const QStyleOptionViewItem& option) {
    return option.icon.isNull() ? 0 : option.decorationSize.width() + 2 * padding;
}

QString message(const QModelIndex& index) { return index.data(ProblemDelegate::messageRole).toString(); }
QString hint(const QModelIndex& index) { return index.data(ProblemDelegate::hintRole).toString(); }

/// The height of the row's buttons with the gap above them; 0 when it has none.
int buttonSpace(const QStyleOptionViewItem& option, const QModelIndex& index) {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const QWidget* buttons = view ? view->indexWidget(index) : nullptr;
    return buttons ? buttons->sizeHint().height() + padding : 0;
}

/// The width that `index` has for its texts.
int textWidth(const QStyleOptionViewItem& option, const QModelIndex& index) {
    const auto* tree = qobject_cast<const QTreeView*>(option.widget);
    if (!tree) return option.rect.width() - 2 * padding - iconSpace(option);
    int depth = tree->rootIsDecorated() ? 1 : 0;
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) ++depth;
    return tree->columnWidth(index.column()) - depth * tree->indentation() - 2 * padding - iconSpace(option);
}

}  // namespace

void ProblemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
    if (index.column() != 0) return QStyledItemDelegate::paint(painter, given, index);
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    const int lineHeight = option.fontMetrics.height();

    // The style draws background and frame; the icon goes to the first line.
    QStyleOptionViewItem bare = option;
    bare.text.clear();
    bare.icon = {};
    style->drawControl(QStyle::CE_ItemViewItem, &bare, painter, option.widget);
    QRect area = option.rect.adjusted(padding, padding, -padding, -padding);
    if (!option.icon.isNull()) {
        const QSize size = option.decorationSize;
        option.icon.paint(painter, QRect(area.left(), area.top() + (lineHeight - size.height()) / 2,
                                         size.width(), size.height()));
        area.setLeft(area.left() + iconSpace(option));
    }
    const bool selected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    const QColor text = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor soft = selected ? text : option.palette.color(group, QPalette::PlaceholderText);
    painter->save();
    painter->setClipRect(option.rect);
    const int width = std::max(area.width(), narrowest);
    const CodeLayout first(message(index), option.font, width), second(hint(index), option.font, width);
    painter->setPen(text);
    first.layout.draw(painter, area.topLeft());
    painter->setPen(soft);
    second.layout.draw(painter, area.topLeft() + QPoint(0, first.height));
    painter->restore();
}

QSize ProblemDelegate::sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const {
    if (index.column() != 0) return QStyledItemDelegate::sizeHint(given, index);
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int width = std::max(textWidth(option, index), narrowest);
    const int height = CodeLayout(message(index), option.font, width).height +
                       CodeLayout(hint(index), option.font, width).height;
    return {width,
            std::max(height, option.decorationSize.height()) + buttonSpace(option, index) + 2 * padding};
}

void ProblemDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& given,
                                           const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int left = option.rect.left() + padding + iconSpace(option);
    const int height = editor->sizeHint().height();
    editor->setGeometry(left, option.rect.bottom() + 1 - padding - height,
                        std::min(editor->sizeHint().width(), option.rect.right() - left), height);
}

}  // namespace isoscope

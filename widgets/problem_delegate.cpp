// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/problem_delegate.h"

#include <algorithm>
#include <QApplication>
#include <QPainter>
#include <QTreeView>

namespace isoscope {
namespace {

constexpr int padding = 3;
constexpr int narrowest = 60;  ///< narrower columns cut the text off instead of stacking single words
constexpr int wrapping = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

int iconSpace(const QStyleOptionViewItem& option) {
    return option.icon.isNull() ? 0 : option.decorationSize.width() + 2 * padding;
}

/// The space for a text as wide as its column, in which long ones take several lines.
int heightOf(const QString& text, int width, const QFontMetrics& metrics) {
    if (text.isEmpty()) return 0;
    return metrics.boundingRect(QRect(0, 0, std::max(width, narrowest), 10000), wrapping, text).height();
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
    painter->setFont(option.font);
    painter->setPen(text);
    painter->drawText(area, wrapping, option.text);
    area.setTop(area.top() + heightOf(option.text, area.width(), option.fontMetrics));
    painter->setPen(soft);
    painter->drawText(area, wrapping, index.data(hintRole).toString());
    painter->restore();
}

QSize ProblemDelegate::sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const {
    if (index.column() != 0) return QStyledItemDelegate::sizeHint(given, index);
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const int width = textWidth(option, index);
    const int height = heightOf(option.text, width, option.fontMetrics) +
                       heightOf(index.data(hintRole).toString(), width, option.fontMetrics);
    return {width, std::max(height, option.decorationSize.height()) + 2 * padding};
}

}  // namespace isoscope

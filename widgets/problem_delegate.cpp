// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/problem_delegate.h"

#include <QApplication>
#include <QPainter>

namespace isoscope {
namespace {

constexpr int padding = 3;

}  // namespace

void ProblemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
    const QString hint = index.data(hintRole).toString();
    if (hint.isEmpty()) return QStyledItemDelegate::paint(painter, given, index);
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    const QString message = option.text;
    const int lineHeight = option.fontMetrics.height();

    // The style draws background, icon and frame; the icon goes to the first line.
    QStyleOptionViewItem bare = option;
    bare.text.clear();
    bare.icon = {};
    style->drawControl(QStyle::CE_ItemViewItem, &bare, painter, option.widget);
    QRect area = option.rect.adjusted(padding, padding, -padding, -padding);
    if (!option.icon.isNull()) {
        const QSize size = option.decorationSize;
        option.icon.paint(painter, QRect(area.left(), area.top() + (lineHeight - size.height()) / 2,
                                         size.width(), size.height()));
        area.setLeft(area.left() + size.width() + 2 * padding);
    }
    const bool selected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    const QColor text = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor soft = selected ? text : option.palette.color(group, QPalette::PlaceholderText);
    painter->save();
    painter->setFont(option.font);
    const auto line = [&](int number, const QString& content, const QColor& color) {
        painter->setPen(color);
        painter->drawText(QRect(area.left(), area.top() + number * lineHeight, area.width(), lineHeight),
                          Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                          option.fontMetrics.elidedText(content, Qt::ElideRight, area.width()));
    };
    line(0, message, text);
    line(1, hint, soft);
    painter->restore();
}

QSize ProblemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    const int lines = index.data(hintRole).toString().isEmpty() ? 1 : 2;
    size.setHeight(std::max(size.height(), lines * option.fontMetrics.height() + 2 * padding));
    return size;
}

}  // namespace isoscope

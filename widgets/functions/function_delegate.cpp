// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QTextLayout>

#include "widgets/functions/function_list_model.h"

namespace isoscope {
namespace {

constexpr int padding = 4;
constexpr int formulaLines = 2;

/// The text in at most `formulaLines` lines, the last one elided.
void drawFormula(QPainter* painter, const QRect& area, const QString& text, const QFontMetrics& metrics) {
    QTextLayout layout(text, painter->font());
    layout.beginLayout();
    for (int number = 0; number < formulaLines; ++number) {
        QTextLine line = layout.createLine();
        if (!line.isValid()) break;
        line.setLineWidth(area.width());
        const bool last = number + 1 == formulaLines;
        const QString shown =
            last ? metrics.elidedText(text.mid(line.textStart()), Qt::ElideRight, area.width())
                 : text.mid(line.textStart(), line.textLength());
        painter->drawText(area.left(), area.top() + number * metrics.height() + metrics.ascent(), shown);
    }
    layout.endLayout();
}

}  // namespace

void FunctionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                             const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    const QString name = option.text;
    option.text.clear();
    option.icon = {};
    option.features &= ~QStyleOptionViewItem::HasDecoration;
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    constexpr int edge = FunctionListModel::pictureSize;
    const QRect picture(option.rect.left() + padding, option.rect.top() + padding, edge, edge);
    const QImage image = index.data(Qt::DecorationRole).value<QImage>();
    const bool selected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    const QColor text = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor soft = selected ? text : option.palette.color(group, QPalette::PlaceholderText);

    painter->save();
    if (image.isNull()) {
        painter->setPen(option.palette.color(QPalette::Mid));
        painter->drawRect(picture.adjusted(0, 0, -1, -1));
        painter->setPen(soft);
        painter->drawText(picture, Qt::AlignCenter, "...");
    } else {
        painter->drawImage(picture, image);
    }
    QRect area = option.rect.adjusted(edge + 3 * padding, padding, -padding, -padding);
    QFont bold = option.font;
    bold.setBold(true);
    const QFontMetrics boldMetrics(bold);
    painter->setFont(bold);
    painter->setPen(text);
    painter->drawText(area.left(), area.top() + boldMetrics.ascent(),
                      boldMetrics.elidedText(name, Qt::ElideRight, area.width()));
    area.setTop(area.top() + boldMetrics.height() + 2);
    painter->setFont(option.font);
    painter->setPen(soft);
    drawFormula(painter, area, index.data(FunctionListModel::formulaRole).toString(), option.fontMetrics);
    painter->restore();
}

QSize FunctionDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int texts = (1 + formulaLines) * option.fontMetrics.height() + 2;
    return {FunctionListModel::pictureSize * 3,
            std::max<int>(FunctionListModel::pictureSize, texts) + 2 * padding};
}

}  // namespace isoscope

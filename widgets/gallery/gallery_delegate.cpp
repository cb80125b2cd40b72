// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_delegate.h"

#include <QApplication>
#include <QImage>
#include <QPainter>

#include "widgets/gallery/gallery_model.h"

namespace isoscope {
namespace {

constexpr int padding = 6;
constexpr int gap = 2;
constexpr int width = GalleryModel::pictureSize + 32;

void drawPicture(QPainter* painter, const QRect& area, const QImage& image, const QPalette& palette) {
    if (!image.isNull()) return painter->drawImage(area, image);
    painter->setPen(palette.color(QPalette::Mid));
    painter->drawRect(area.adjusted(0, 0, -1, -1));
    painter->setPen(palette.color(QPalette::PlaceholderText));
    painter->drawText(area, Qt::AlignCenter, QStringLiteral("..."));
}

}  // namespace

void GalleryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                            const QModelIndex& index) const {
    QStyleOptionViewItem option = given;
    option.index = index;
    option.text.clear();
    option.icon = {};
    const QStyle* style = option.widget ? option.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &option, painter, option.widget);

    constexpr int edge = GalleryModel::pictureSize;
    const QRect inner = option.rect.adjusted(padding, padding, -padding, -padding);
    const QRect picture(inner.center().x() - edge / 2, inner.top(), edge, edge);
    const bool selected = option.state & QStyle::State_Selected;
    const auto group = option.state & QStyle::State_Active ? QPalette::Active : QPalette::Inactive;
    const QColor text = option.palette.color(group, selected ? QPalette::HighlightedText : QPalette::Text);

    painter->save();
    // Styles mark only text and icon of an entry like this, which are drawn here.
    if (selected) painter->fillRect(option.rect, option.palette.brush(group, QPalette::Highlight));
    drawPicture(painter, picture, index.data(Qt::DecorationRole).value<QImage>(), option.palette);
    QRect line(inner.left(), picture.bottom() + 1 + gap, inner.width(), option.fontMetrics.height());
    const auto drawLine = [&](const QString& words, const QColor& color) {
        painter->setPen(color);
        painter->drawText(line, Qt::AlignCenter,
                          option.fontMetrics.elidedText(words, Qt::ElideRight, line.width()));
        line.translate(0, line.height());
    };
    painter->setFont(option.font);
    drawLine(index.data(Qt::DisplayRole).toString(), text);
    drawLine(index.data(GalleryModel::sentenceRole).toString(),
             selected ? text : option.palette.color(group, QPalette::PlaceholderText));
    painter->restore();
}

QSize GalleryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {width, GalleryModel::pictureSize + gap + 2 * option.fontMetrics.height() + 2 * padding};
}

}  // namespace isoscope

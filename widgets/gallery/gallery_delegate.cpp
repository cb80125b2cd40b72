// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_delegate.h"

#include <QApplication>
#include <QImage>
#include <QPainter>

#include "widgets/gallery/gallery_model.h"
#include "widgets/interface_style.h"

namespace isoscope {
namespace {

constexpr int padding = 6;
constexpr int gap = 2;
constexpr int smallWidth = GalleryModel::pictureSize + 32, largeWidth = 212;
constexpr int largeLines = 4;  ///< of the sentence and a second one of the title

/// Where the title stands.
QRect titleOf(const QStyleOptionViewItem& option) {
    const QRect inner = option.rect.adjusted(padding, padding, -padding, -padding);
    return {inner.left(), inner.top() + GalleryModel::pictureSize + gap, inner.width(),
            option.fontMetrics.height()};
}

void drawPicture(QPainter* painter, const QRect& area, const QImage& image, const QPalette& palette) {
    if (!image.isNull()) return painter->drawImage(area, image);
    painter->setPen(palette.color(QPalette::Mid));
    painter->drawRect(area.adjusted(0, 0, -1, -1));
    painter->setPen(palette.color(QPalette::PlaceholderText));
    painter->drawText(area, Qt::AlignCenter, QStringLiteral("..."));
}

/// Words from the middle of the area's top on, line by line, the last one elided; how many lines they take.
int drawSentence(QPainter* painter, const QRect& area, const QString& text, const QFontMetrics& metrics) {
    QString rest = text;
    const int count = area.height() / metrics.height();
    int number = 0;
    for (; number < count && !rest.isEmpty(); ++number) {
        qsizetype end = rest.size();
        // A line ends at a space, or in a word that alone is too long.
        while (number + 1 < count && end > 0 && metrics.horizontalAdvance(rest.left(end)) > area.width())
            end = rest.lastIndexOf(QLatin1Char(' '), end - 1);
        if (end <= 0) end = rest.size();
        const QRect line(area.left(), area.top() + number * metrics.height(), area.width(), metrics.height());
        painter->drawText(line, Qt::AlignCenter,
                          metrics.elidedText(rest.left(end), Qt::ElideRight, area.width()));
        rest = rest.mid(end).trimmed();
    }
    return number;
}

}  // namespace

GalleryDelegate::GalleryDelegate(Size size, QObject* parent)
    : QStyledItemDelegate(parent),
      width_(size == Size::large ? largeWidth : smallWidth),
      lines_(size == Size::large ? largeLines : 1) {}

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
    QRect area = titleOf(option);
    painter->setFont(option.font);
    painter->setPen(text);
    // Where there is room for sentences a long title takes a line more.
    const int line = option.fontMetrics.height();
    area.setHeight((lines_ > 1 ? 2 : 1) * line);
    const int used = drawSentence(painter, area, index.data(Qt::DisplayRole).toString(), option.fontMetrics);
    area.translate(0, used * line);
    area.setHeight((1 + lines_ - used) * line);
    painter->setPen(selected ? text : option.palette.color(group, QPalette::PlaceholderText));
    drawSentence(painter, area, index.data(GalleryModel::sentenceRole).toString(), option.fontMetrics);
    painter->restore();
}

QSize GalleryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {interfaceLength(width_),
            GalleryModel::pictureSize + gap + (1 + lines_) * option.fontMetrics.height() + 2 * padding};
}

void GalleryDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                           const QModelIndex&) const {
    const QRect title = titleOf(option);
    editor->setGeometry(title.adjusted(0, -padding / 2, 0, padding / 2));
}

}  // namespace isoscope

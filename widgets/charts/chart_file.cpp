// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/chart_file.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include "core/text/csv_table.h"
#include "core/text/number_format.h"
#include "core/text/whole_file.h"
#include "widgets/charts/chart_painter.h"

namespace isoscope {

namespace {

void paintSheet(QPainter& painter, const ChartSheet& sheet) {
    painter.setFont(sheet.font);
    QRectF place(QPointF(), QSizeF(sheet.chartSize));
    for (const Chart& chart : sheet.charts) {
        ChartPainter::paint(painter, place, chart, sheet.palette);
        place.translate(place.width(), 0);
    }
}

QSize sizeOf(const ChartSheet& sheet) {
    return {sheet.chartSize.width() * static_cast<int>(sheet.charts.size()), sheet.chartSize.height()};
}

bool saveBytes(const QByteArray& bytes, const QString& path) {
    return writeWhole(QFile::encodeName(path).toStdString(), {bytes.constData(), std::size_t(bytes.size())})
        .empty();
}

bool saveSvg(const ChartSheet& sheet, QIODevice& file) {
    QSvgGenerator generator;
    generator.setOutputDevice(&file);
    generator.setSize(sizeOf(sheet));
    generator.setViewBox(QRect(QPoint(), sizeOf(sheet)));
    // One pixel of the sheet is one unit of the file, and texts keep their size among them.
    generator.setResolution(96);
    // Written as it stands, unlike the texts that are drawn.
    generator.setTitle(sheet.charts.first().title.toHtmlEscaped());
    QPainter painter;
    if (!painter.begin(&generator)) return false;
    paintSheet(painter, sheet);
    return painter.end();
}

bool savePng(const ChartSheet& sheet, QIODevice& file) {
    constexpr int scale = 2;
    QImage image(sizeOf(sheet) * scale, QImage::Format_RGB32);
    if (image.isNull()) return false;
    image.setDevicePixelRatio(scale);
    image.fill(sheet.palette.color(QPalette::Base));
    QPainter painter(&image);
    paintSheet(painter, sheet);
    painter.end();
    return image.save(&file, "PNG");
}

}  // namespace

bool saveCharts(const ChartSheet& sheet, const QString& path) {
    const bool svg = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
    if (sheet.charts.isEmpty() || (!svg && !path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)))
        return false;
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    return (svg ? saveSvg(sheet, file) : savePng(sheet, file)) && saveBytes(file.data(), path);
}

QString chartTable(const Chart& chart) {
    std::string text = csvLine({"series", "x", "y"});
    for (const ChartSeries& series : chart.series)
        for (const QPointF& point : series.points)
            text += csvLine({series.name.toStdString(), exactNumber(point.x()), exactNumber(point.y())});
    return QString::fromStdString(text);
}

bool savePicture(const QImage& picture, const QString& path) {
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    return picture.save(&file, "PNG") && saveBytes(file.data(), path);
}

bool saveText(const QString& text, const QString& path) { return saveBytes(text.toUtf8(), path); }

}  // namespace isoscope

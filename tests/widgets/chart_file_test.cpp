// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/image_pixels.h"
#include "tests/support/small_disk.h"
#include "widgets/charts/chart_file.h"

#include <cmath>
#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>

#include "core/text/csv_table.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// One of everything that charts have.
Chart everything() {
    Chart chart;
    chart.title = QStringLiteral("All <shapes> & marks");
    chart.x = {QStringLiteral("accuracy"), 1e-6, 1, true, 0};
    chart.y = {QStringLiteral("|∇f|"), 0, 10, false, 0};
    using Shape = ChartSeries::Shape;
    chart.series << ChartSeries{
        QStringLiteral("bars"), Qt::darkGray, Shape::bars, {{1e-5, 3}, {1e-4, 5}, {1e-3, 2}}, 1, false};
    chart.series << ChartSeries{QStringLiteral("line"),
                                Qt::red,
                                Shape::line,
                                {{1e-6, 9}, {1e-3, std::nan("")}, {1e-2, 8}, {1, 9}},
                                2,
                                false};
    chart.series << ChartSeries{QStringLiteral("points"),         Qt::blue, Shape::points,
                                {{1e-2, 6}, {1e-1, 7}, {1e9, 4}}, 6,        false};
    chart.series << ChartSeries{QStringLiteral("both"), Qt::green, Shape::linePoints,
                                {{1e-2, 1}, {1, 2}},    2,         true};
    chart.series << ChartSeries{QStringLiteral("parts"),
                                Qt::magenta,
                                Shape::segments,
                                {{1e-6, 4}, {1e-5, 4}, {1e-2, 4}, {1e-1, 4}},
                                4,
                                false};
    chart.marks << ChartMark{1e-3, QStringLiteral("now 0.001"), Qt::black};
    return chart;
}

ChartSheet sheetOf(int charts) {
    ChartSheet sheet;
    for (int i = 0; i < charts; ++i) sheet.charts << everything();
    sheet.palette = QApplication::palette();
    sheet.font = QApplication::font();
    return sheet;
}

}  // namespace

class ChartFileTest : public QObject {
    Q_OBJECT

  private slots:
    void theDrawingLooksLikeThePicture() {
        QTemporaryDir folder;
        const QString svg = folder.filePath(QStringLiteral("a.svg")),
                      png = folder.filePath(QStringLiteral("a.PNG"));
        QVERIFY(saveCharts(sheetOf(2), svg) && saveCharts(sheetOf(2), png));
        const QImage picture(png);
        QCOMPARE(picture.size(), QSize(4 * 640, 2 * 420));
        QSvgRenderer renderer(svg);
        QVERIFY(renderer.isValid());
        QCOMPARE(renderer.viewBox().size(), QSize(2 * 640, 420));
        QImage drawn(picture.size(), QImage::Format_RGB32);
        drawn.fill(Qt::white);
        QPainter painter(&drawn);
        renderer.render(&painter);
        painter.end();
        for (const QColor& color : {QColor(Qt::darkGray), QColor(Qt::red), QColor(Qt::blue),
                                    QColor(Qt::green), QColor(Qt::magenta)}) {
            const int a = countNear(picture, color, 39), b = countNear(drawn, color, 39);
            QVERIFY2(a > 200 && std::abs(a - b) < 0.15 * a,
                     qPrintable(QStringLiteral("%1: %2 and %3").arg(color.name()).arg(a).arg(b)));
        }
        if (qEnvironmentVariableIsSet("ISOSCOPE_KEEP")) drawn.save(qEnvironmentVariable("ISOSCOPE_KEEP"));
    }

    void textsAreTexts() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.svg"));
        QVERIFY(saveCharts(sheetOf(1), path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        for (const char* part :
             {"All &lt;shapes&gt; &amp; marks", "accuracy", "|∇f|", "now 0.001", "0.1", "points"})
            QVERIFY2(text.contains(QString::fromUtf8(part)), part);
        QVERIFY(!text.contains(QStringLiteral("nan")));
    }

    void whatCannotBeWrittenIsSaid() {
        QTemporaryDir folder;
        QVERIFY(!saveCharts(sheetOf(1), folder.filePath(QStringLiteral("no/such.svg"))));
        QVERIFY(!saveCharts(sheetOf(1), folder.filePath(QStringLiteral("a.bmp"))));
        QVERIFY(!saveCharts(sheetOf(0), folder.filePath(QStringLiteral("a.svg"))));
        QVERIFY(!saveText(QStringLiteral("x"), folder.filePath(QStringLiteral("no/such.csv"))));
    }

    /// Sections and sheets were written straight into the file that was there before.
    void aFullDiskLeavesWhatWasThere() {
        const SmallDisk disk;
        if (!disk.mounted()) QSKIP("a file system can be mounted by root only");
        const QString path = disk.path(QStringLiteral("picture.png"));
        QImage picture(60, 40, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(savePicture(picture, path));
        QCOMPARE(QImage(path).pixelColor(5, 5), QColor(Qt::red));
        disk.fill();
        picture.fill(Qt::blue);
        QVERIFY(!savePicture(picture, path));
        QCOMPARE(QImage(path).pixelColor(5, 5), QColor(Qt::red));
        disk.empty();
        QVERIFY(savePicture(picture, path));
        QCOMPARE(QImage(path).pixelColor(5, 5), QColor(Qt::blue));
    }

    void theTableHasAllPoints() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.csv"));
        QVERIFY(saveText(chartTable(everything()), path));
        const auto table = CsvTable::read(path.toStdString());
        QVERIFY(table);
        QCOMPARE(table->rowCount(), std::size_t(16));
        QCOMPARE(table->field(0, "series"), std::string("bars"));
        QCOMPARE(table->number(1, "x", 0), 1e-4);
        QCOMPARE(table->number(1, "y", 0), 5.0);
    }

    void aChartWithoutPointsSaysWhatIsMissing() {
        QTemporaryDir folder;
        ChartSheet sheet = sheetOf(0);
        Chart empty;
        empty.empty = QStringLiteral("Press Measure.");
        sheet.charts << empty;
        const QString path = folder.filePath(QStringLiteral("a.svg"));
        QVERIFY(saveCharts(sheet, path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("Press Measure."));
    }
};

QTEST_MAIN(ChartFileTest)
#include "chart_file_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/place_marks.h"

#include <QLineF>
#include <QPainter>
#include <QTest>

using namespace isoscope;

/// Marks of places with their labels, as painted.
class PlaceMarksTest : public QObject {
    Q_OBJECT

  private slots:
    void labelsStayInside_data() {
        QTest::addColumn<QPointF>("at");
        QTest::newRow("middle") << QPointF(100, 60);
        QTest::newRow("top left") << QPointF(8, 8);
        QTest::newRow("top right") << QPointF(192, 8);
        QTest::newRow("bottom") << QPointF(100, 112);
        QTest::newRow("bottom right") << QPointF(192, 112);
    }

    /// A label that is wider than the room at either side of its mark was cut off.
    void labelsStayInside() {
        QFETCH(QPointF, at);
        constexpr int border = 30, width = 200, height = 120;
        for (const QString& label : {QStringLiteral("12"), QStringLiteral("steepest: 3e+35, 1e+35"),
                                     QStringLiteral("steepest: 3e+35, 1e+35 away, and on, and on")}) {
            QImage picture(width + 2 * border, height + 2 * border, QImage::Format_RGB32);
            picture.fill(Qt::green);
            QPainter painter(&picture);
            painter.translate(border, border);
            paintPlaceMark(painter, QRect(0, 0, width, height), at, Qt::red, label);
            painter.end();
            // The label's box is dark; of the mark a ring may reach over the edge.
            int dark = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) {
                    const QPointF place(x - border, y - border);
                    if (QLineF(place, at).length() < 10 || qGreen(picture.pixel(x, y)) > 100) continue;
                    ++dark;
                    QVERIFY2(QRectF(1, 1, width - 2, height - 2).contains(place), qPrintable(label));
                }
            QVERIFY(dark > 100);
        }
    }
};

QTEST_MAIN(PlaceMarksTest)
#include "place_marks_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <dlfcn.h>
#include <cmath>
#include <limits>
#include <QMessageLogContext>
#include <QSet>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/image_pixels.h"
#include "widgets/section/section_view.h"
#include "widgets/theme.h"
#include "widgets/viewport/heat_overlay.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// x*x + y*y - 0.25 in the box -1..1: the threshold is a circle of radius 0.5.
SectionField circle() {
    SectionField field;
    field.columns = field.rows = 129;
    field.container = ContainerBox{};
    for (int row = 0; row < field.rows; ++row)
        for (int column = 0; column < field.columns; ++column) {
            const double x = column / 64.0 - 1, y = row / 64.0 - 1;
            field.values.push_back(static_cast<float>(x * x + y * y - 0.25));
            field.contained.push_back(1);
        }
    return field;
}

QStringList messages;
void collect(QtMsgType, const QMessageLogContext&, const QString& text) { messages << text; }

}  // namespace

class SectionViewTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { applyTheme(Theme::light); }

    void executableExportsGlewInit() {
        // Without it VTK initialises GLEW again, and logs an error, in every frame.
        QVERIFY(dlsym(RTLD_DEFAULT, "glewInit") != nullptr);
        Dl_info info{};
        QVERIFY(dladdr(dlsym(RTLD_DEFAULT, "glewInit"), &info) != 0);
        QVERIFY2(!QByteArray(info.dli_fname).contains("libGLEW"), info.dli_fname);
    }

    void drawsFieldWithoutMessages() {
        messages.clear();
        const auto previous = qInstallMessageHandler(collect);
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        qInstallMessageHandler(previous);
        messages.erase(std::remove_if(messages.begin(), messages.end(),
                                      [](const QString& m) { return m.contains("propagateSizeHints"); }),
                       messages.end());
        QCOMPARE(messages, QStringList());
        QCOMPARE(view.frame().size(), QSize(400, 320));
        QVERIFY2(distinctColors(view.frame()) > 100,
                 qPrintable(QString::number(distinctColors(view.frame()))));
    }

    void insideIsBlueOutsideOrange() {
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(!view.frame().isNull());
        QSignalSpy hovered(&view, &SectionView::hovered);
        // Find the middle of the plane by asking the view itself.
        QPoint centre(-1, -1), corner(-1, -1);
        for (int y = 0; y < 320; y += 4)
            for (int x = 0; x < 320; x += 4) {
                hovered.clear();
                QTest::mouseMove(&view, QPoint(x, y));
                if (hovered.isEmpty()) continue;
                const double h = hovered[0][0].toDouble(), v = hovered[0][1].toDouble();
                if (std::hypot(h, v) < 0.03) centre = {x, y};
                if (h > 0.8 && v > 0.8 && corner.x() < 0) corner = {x, y};
            }
        QVERIFY(centre.x() > 0 && corner.x() > 0);
        const QColor inside = view.frame().pixelColor(centre), outside = view.frame().pixelColor(corner);
        QVERIFY2(inside.blue() > inside.red() + 20, qPrintable(inside.name()));
        QVERIFY2(outside.red() > outside.blue() + 20, qPrintable(outside.name()));
        // Up in the plane is up on the screen.
        QVERIFY(corner.y() < centre.y());
    }

    /// The first container, if it was just as wide as the view of nothing, filled the panel without room for
    /// scales.
    void firstFieldLeavesRoomForScales() {
        SectionView view;
        view.resize(400, 320);
        view.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        view.show(circle());
        QTRY_VERIFY(view.settled());
        QSignalSpy hovered(&view, &SectionView::hovered);
        int rows = 0;
        for (int y = 0; y < 320; y += 2) {
            hovered.clear();
            QTest::mouseMove(&view, QPoint(160, y));
            rows += hovered.isEmpty() ? 0 : 2;
        }
        QVERIFY2(rows > 200 && rows < 310, qPrintable(QString::number(rows)));
    }

    void thresholdLineIsDrawn() {
        SectionView with, without;
        SectionField field = circle();
        for (SectionView* view : {&with, &without}) {
            view->resize(400, 320);
            view->show(field);
            view->QWidget::show();
            for (float& value : field.values) value = std::abs(value) + 0.01f;  // the second has no crossing
        }
        QTRY_VERIFY(with.settled() && without.settled());
        const int line = countNear(with.frame(), QColor(16, 18, 22), 24);
        const int none = countNear(without.frame(), QColor(16, 18, 22), 24);
        QVERIFY2(line > none + 200, qPrintable(QString("%1 against %2").arg(line).arg(none)));
    }

    void undefinedIsHatched() {
        SectionView view;
        view.resize(400, 320);
        SectionField field = circle();
        for (float& value : field.values) value = std::numeric_limits<float>::quiet_NaN();
        field.undefined = true;
        view.show(field);
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const QColor middle = view.frame().pixelColor(160, 150);
        QVERIFY2(std::abs(middle.red() - middle.blue()) < 12, qPrintable(middle.name()));
        // Two greys alternate along a row through the middle.
        QSet<int> greys;
        for (int x = 120; x < 200; ++x) greys.insert(view.frame().pixelColor(x, 150).red() / 8);
        QVERIFY(greys.size() >= 3);
    }

    void wheelZooms() {
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const QImage before = view.frame();
        QWheelEvent wheel({150, 150}, view.mapToGlobal(QPointF(150, 150)), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &wheel);
        QTRY_VERIFY(view.settled() && view.frame() != before);
        view.resetView();
        QTRY_VERIFY(view.settled() && view.frame() == before);
    }

    void followsTheme() {
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const int light = view.frame().pixelColor(390, 3).lightness();
        applyTheme(Theme::dark);
        QTRY_VERIFY(view.settled() && view.frame().pixelColor(390, 3).lightness() + 100 < light);
        applyTheme(Theme::light);
    }

    void emptyFieldShowsBackgroundOnly() {
        SectionView view;
        view.resize(400, 320);
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        QCOMPARE(distinctColors(view.grab().toImage()), 1);
        // OpenGL was not started for it.
        QVERIFY(!view.started());
        view.show(circle());
        QTRY_VERIFY(view.started() && view.settled());
        view.show({});
        QTRY_VERIFY(view.settled() && distinctColors(view.grab().toImage()) == 1);
    }

    void slopesAreShownInTheColoursOfTheOverlay() {
        SectionField field = circle();
        field.quantity = SectionQuantity::gradient;
        field.slopes.assign(field.values.size(), 0.5f);
        field.maxGradient = 1;
        field.steepest = 0.5;
        SectionView view;
        view.resize(400, 320);
        view.show(field);
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const auto count = [&](const QColor& color) {
            int pixels = 0;
            for (int y = 0; y < 320; ++y)
                for (int x = 0; x < 300; ++x) {
                    const QColor at = view.frame().pixelColor(x, y);
                    pixels += std::abs(at.red() - color.red()) < 4 &&
                              std::abs(at.green() - color.green()) < 4 &&
                              std::abs(at.blue() - color.blue()) < 4;
                }
            return pixels;
        };
        QVERIFY(count(heatColor(0.5)) > 5000);
        field.slopes.assign(field.values.size(), 2);
        field.steepest = 2;
        view.show(field);
        QTRY_VERIFY(view.settled() && count(heatColor(2)) > 5000);
        QVERIFY(count(heatColor(0.5)) < 100);
    }

    void theBandOfTheColoursIsChosen() {
        SectionField field = circle();
        field.quantity = SectionQuantity::gradient;
        field.slopes.assign(field.values.size(), 0.5f);
        field.maxGradient = 1;
        field.steepest = 0.5;
        SectionView view;
        view.resize(400, 320);
        view.show(field);
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const auto has = [&](double share) {
            const QColor color = heatColor(share), at = view.frame().pixelColor(150, 160);
            return std::abs(at.red() - color.red()) < 4 && std::abs(at.green() - color.green()) < 4 &&
                   std::abs(at.blue() - color.blue()) < 4;
        };
        QTRY_VERIFY(has(0.5));
        view.setBand(0.25);
        QTRY_VERIFY(view.settled() && has(2));
        view.setBand(0);
        QTRY_VERIFY(view.settled() && has(0.5));
        view.setBand(-1);  // no such band
        QTRY_VERIFY(view.settled() && has(0.5));
    }

    void linesAreAddedAndTakenAway() {
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const QImage plain = view.frame();
        view.setLinesShown(true);
        QTRY_VERIFY(view.settled() && view.frame() != plain);
        view.setLinesShown(false);
        QTRY_VERIFY(view.settled() && view.frame() == plain);
    }

    void theCrosshairFollowsTheMouse() {
        SectionView view;
        view.resize(400, 320);
        view.show(circle());
        view.QWidget::show();
        QTRY_VERIFY(view.settled());
        const QImage plain = view.grab().toImage();
        QTest::mouseMove(&view, {160, 150});
        const QImage crossed = view.grab().toImage();
        QVERIFY(crossed.pixelColor(160, 40) != plain.pixelColor(160, 40));
        QVERIFY(crossed.pixelColor(100, 150) != plain.pixelColor(100, 150));
        QCOMPARE(crossed.pixelColor(100, 40), plain.pixelColor(100, 40));
        // It says what is there again when the plane moves below it.
        QSignalSpy hovered(&view, &SectionView::hovered);
        view.tellHover();
        QCOMPARE(hovered.count(), 1);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view, &leave);
        QCOMPARE(view.grab().toImage(), plain);
        view.tellHover();
        QCOMPARE(hovered.count(), 1);
    }
};

QTEST_MAIN(SectionViewTest)
#include "section_view_test.moc"

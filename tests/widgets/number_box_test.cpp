// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_box.h"

#include <QLineEdit>
#include <QTest>

using namespace isoscope;

/// The spin box of numbers of any size.
class NumberBoxTest : public QObject {
    Q_OBJECT

    static void type(NumberBox& box, const QString& text) {
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }

  private slots:
    void stepsAreThoseOfTheResolution() {
        NumberBox box;
        box.setResolution(0.05);
        box.setValue(0.33);
        box.stepBy(1);
        QCOMPARE(box.text(), QStringLiteral("0.38"));
        box.setValue(0.333);
        box.stepBy(-3);
        QCOMPARE(box.text(), QStringLiteral("0.18"));  // rounded to the place of the resolution
        QTest::keyClick(&box, Qt::Key_Up);
        QCOMPARE(box.text(), QStringLiteral("0.23"));
        QTest::keyClick(&box, Qt::Key_PageDown);
        QCOMPARE(box.text(), QStringLiteral("-0.27"));
        box.setIntegral(true);
        box.stepBy(1);
        QCOMPARE(box.text(), QStringLiteral("1"));
    }

    void numbersOfAnySizeAreKept() {
        NumberBox box;
        for (const QString& text : {QStringLiteral("1e-12"), QStringLiteral("123456789.25"),
                                    QStringLiteral("-0.000125"), QStringLiteral("1e+200")}) {
            type(box, text);
            QCOMPARE(box.value(), text.toDouble());
        }
        type(box, QStringLiteral("1e999"));  // beyond what a double holds
        QCOMPARE(box.value(), 1e200);
    }

    void nonsenseIsNotTyped() {
        NumberBox box;
        box.setValue(2.5);
        type(box, QStringLiteral("abc"));
        QCOMPARE(box.value(), 2.5);
        type(box, QStringLiteral("1,5"));  // a comma parts arguments in the language
        QCOMPARE(box.value(), 15.0);
        type(box, QStringLiteral("-"));
        QCOMPARE(box.value(), 15.0);
        box.setIntegral(true);
        type(box, QStringLiteral("3.7"));
        QCOMPARE(box.value(), 37.0);
        box.setRange(0, 10);
        type(box, QStringLiteral("11"));
        QCOMPARE(box.value(), 10.0);
    }

    void theWheelCountsWithTheFocusAlone() {
        QWidget window;
        NumberBox box(&window), other(&window);
        other.move(0, 60);
        box.setResolution(0.1);
        box.setValue(1);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const auto turn = [&box] {
            const QPointF at(5, 5);
            QWheelEvent event(at, box.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&box, &event);
        };
        other.setFocus();
        turn();
        QCOMPARE(box.text(), QStringLiteral("1"));
        box.setFocus();
        turn();
        QCOMPARE(box.text(), QStringLiteral("1.1"));
    }

    void decimalsAreThoseAskedFor() {
        NumberBox box;
        box.setPlaces(3);
        box.setValue(0.5);
        QCOMPARE(box.text(), QStringLiteral("0.500"));
        box.setPlaces(-1);
        box.setValue(0.25);
        QCOMPARE(box.text(), QStringLiteral("0.25"));
    }
};

QTEST_MAIN(NumberBoxTest)
#include "number_box_test.moc"

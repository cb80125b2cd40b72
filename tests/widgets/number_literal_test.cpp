// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_literal.h"

#include <QTest>

using namespace isoscope;

class NumberLiteralTest : public QObject {
    Q_OBJECT

  private slots:
    void findsTheNumberAtTheCaret_data() {
        QTest::addColumn<QByteArray>("text");  // | marks the position
        QTest::addColumn<QByteArray>("number");
        QTest::newRow("inside") << QByteArray("threshold 0.|35 x") << QByteArray("0.35");
        QTest::newRow("at its begin") << QByteArray("threshold |0.35") << QByteArray("0.35");
        QTest::newRow("at its end") << QByteArray("threshold 0.35|") << QByteArray("0.35");
        QTest::newRow("point first") << QByteArray("(.|5)") << QByteArray(".5");
        QTest::newRow("exponent") << QByteArray("1.5e-|3 2") << QByteArray("1.5e-3");
        QTest::newRow("sign after bracket") << QByteArray("f(-|2)") << QByteArray("-2");
        QTest::newRow("sign after comma") << QByteArray("<1,-|2,3>") << QByteArray("-2");
        QTest::newRow("sign after operator") << QByteArray("x* -|2") << QByteArray("-2");
        QTest::newRow("sign at line begin") << QByteArray("\n-|2") << QByteArray("-2");
        QTest::newRow("on the sign") << QByteArray("(|-2)") << QByteArray("-2");
        QTest::newRow("sign behind a keyword") << QByteArray("threshold -|2") << QByteArray("-2");
        QTest::newRow("minus behind a name") << QByteArray("Radius -|2") << QByteArray("2");
        QTest::newRow("minus behind a value") << QByteArray("pi -|2") << QByteArray("2");
        QTest::newRow("minus is an operator") << QByteArray("x-|2") << QByteArray("2");
        QTest::newRow("minus behind bracket") << QByteArray("(x) - |2") << QByteArray("2");
        QTest::newRow("minus behind number") << QByteArray("3-|2") << QByteArray("2");
        QTest::newRow("two minuses") << QByteArray("3--|2") << QByteArray("-2");
        QTest::newRow("digit of a name") << QByteArray("P|0") << QByteArray();
        QTest::newRow("name ends in digits") << QByteArray("atan2|(1)") << QByteArray();
        QTest::newRow("nothing") << QByteArray("x |+ y") << QByteArray();
        QTest::newRow("member access") << QByteArray("v.|x") << QByteArray();
        QTest::newRow("behind wide characters")
            << QByteArray("// \xe6\xbc\xa2 \xf0\x9f\x98\x80\n4|2") << QByteArray("42");
        QTest::newRow("letter of another script") << QByteArray(
                                                         "\xc3\xa4"
                                                         "1|")
                                                  << QByteArray();
        QTest::newRow("too large") << QByteArray("1e9|99") << QByteArray();
    }
    void findsTheNumberAtTheCaret() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, number);
        const int position = static_cast<int>(text.indexOf('|'));
        text.remove(position, 1);
        const auto found = numberAt(std::string_view(text.constData(), text.size()), position);
        QCOMPARE(found.has_value(), !number.isEmpty());
        if (!found) return;
        QCOMPARE(text.mid(found->begin, found->end - found->begin), number);
        QCOMPARE(found->value, number.toDouble());
    }

    void stepsByTheLastPlace_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("step");
        QTest::newRow("whole") << QByteArray("5") << 1.0;
        QTest::newRow("two places") << QByteArray("0.35") << 0.01;
        QTest::newRow("trailing zero counts") << QByteArray("0.50") << 0.01;
        QTest::newRow("exponent") << QByteArray("1e-6") << 1e-6;
        QTest::newRow("both") << QByteArray("1.5e-3") << 1e-4;
        QTest::newRow("positive exponent") << QByteArray("2.5e+3") << 100.0;
    }
    void stepsByTheLastPlace() {
        QFETCH(QByteArray, text);
        QFETCH(double, step);
        const auto found = numberAt(std::string_view(text.constData(), text.size()), 0);
        QVERIFY(found);
        QVERIFY(qFuzzyCompare(found->step(), step));
    }

    void acceptsAnyPosition() {
        QVERIFY(!numberAt("12", -1));
        QVERIFY(!numberAt("12", 3));
        QVERIFY(!numberAt("", 0));
    }
};

QTEST_APPLESS_MAIN(NumberLiteralTest)
#include "number_literal_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/form_sign.h"

#include <cmath>
#include <QTest>

using namespace isoscope;

class FormSignTest : public QObject {
    Q_OBJECT

  private slots:
    void aSignHoldsAllAlong() {
        QCOMPARE(formSign(3, 1, 0.5, {1, false}), 1);
        QCOMPARE(formSign(3, 1, 0.5, {1, true}), -1);
        QCOMPARE(formSign(-1, 1, 0.5, {1, false}), -1);
        QCOMPARE(formSign(2, 1, 0.5, {1, false}), 0);
        // What rounding may decide is open.
        QCOMPARE(formSign(2, 1, 0, {1, false}), 0);
    }

    /// A case without a value was taken for one on the outside.
    void undefinedAndUnknownFormsHaveNoSign() {
        for (const double error : {-double(INFINITY), double(INFINITY), double(NAN)})
            for (const double center : {-3.0, 0.0, 3.0}) QCOMPARE(formSign(center, 0, error, {0, false}), 0);
    }
};

QTEST_APPLESS_MAIN(FormSignTest)
#include "form_sign_test.moc"

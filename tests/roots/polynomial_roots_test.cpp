// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/polynomial_roots.h"

#include <cmath>
#include <QRandomGenerator>
#include <QTest>

#include "tests/roots/hard_polynomials.h"

using namespace isoscope;

class PolynomialRootsTest : public QObject {
    Q_OBJECT

  private slots:
    void hardCases() {
        const test::CsvTable table(test::dataFile("hard/polynomials.csv"));
        QVERIFY(table.rowCount() > 200);
        int failures = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const test::HardPolynomial hard(table, row);
            const std::string mistake =
                hard.mistakeIn(polynomialRoots(hard.coefficients, hard.low, hard.high));
            if (mistake.empty()) continue;
            ++failures;
            qWarning("%s: %s", table.field(row, "case_id").c_str(), mistake.c_str());
        }
        QCOMPARE(failures, 0);
    }

    void closedFormsAgreeWhereTheyApply_VL_SOLVER() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        for (int round = 0; round < 2000; ++round) {
            const int degree = 1 + random.bounded(4);
            std::vector<double> coefficients(degree + 1);
            for (double& c : coefficients) c = random.generateDouble() * 2 - 1;
            const auto wanted = polynomialRoots(coefficients, -100, 100);
            const auto method = random.bounded(2) ? PolynomialMethod::vieta : PolynomialMethod::ferrari;
            const auto got = polynomialRoots(coefficients, -100, 100, method);
            QCOMPARE(got.size(), wanted.size());
            for (std::size_t k = 0; k < got.size(); ++k)
                QVERIFY(std::abs(got[k] - wanted[k]) <= 1e-9 * std::max(1.0, std::abs(wanted[k])));
        }
    }

    /// Newton's steps alone would come near a pair of roots by halves.
    void closedFormsTellCloseRootsApart() {
        const double apart = 0x1p-24;
        const double coefficients[] = {1, -(1 + apart), -1, 1 + apart};
        const auto roots = polynomialRoots(coefficients, -2, 2, PolynomialMethod::vieta);
        const std::vector<double> wanted{-1, 1, 1 + apart};
        QCOMPARE(roots.size(), wanted.size());
        for (std::size_t k = 0; k < wanted.size(); ++k)
            QVERIFY(std::abs(roots[k] - wanted[k]) < 1e-3 * apart);
    }

    void degenerateInput() {
        const double nothing[] = {0, 0, 0}, constant[] = {0, 3}, notFinite[] = {1, NAN}, line[] = {0, 2, -1};
        QVERIFY(polynomialRoots(nothing, -1, 1).empty());
        QVERIFY(polynomialRoots(constant, -1, 1).empty());
        QVERIFY(polynomialRoots(notFinite, -1, 1).empty());
        QVERIFY(polynomialRoots(line, 1, -1).empty());
        QVERIFY(polynomialRoots({}, -1, 1).empty());
        QCOMPARE(polynomialRoots(line, -1, 1), std::vector<double>{0.5});
    }
};

QTEST_APPLESS_MAIN(PolynomialRootsTest)
#include "polynomial_roots_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/real_roots.h"

#include <cmath>
#include <QRandomGenerator>
#include <QTest>

#include "core/roots/polynomial/polynomial_roots.h"
#include "tests/roots/hard_polynomials.h"

using namespace isoscope;

namespace {

std::vector<double> found(const std::vector<double>& coefficients, double low, double high) {
    RootSequence roots;
    realRoots(coefficients, low, high, roots);
    return {roots.begin(), roots.end()};
}

/// The coefficients of the product of (t - root), highest power first.
std::vector<double> withRoots(const std::vector<double>& roots) {
    std::vector<double> product{1};
    for (const double root : roots) {
        product.push_back(0);
        for (std::size_t k = product.size() - 1; k > 0; --k) product[k] -= root * product[k - 1];
    }
    return product;
}

}  // namespace

class RealRootsTest : public QObject {
    Q_OBJECT

  private slots:
    void hardCases() {
        const test::CsvTable table(test::dataFile("hard/polynomials.csv"));
        QVERIFY(table.rowCount() > 200);
        const std::size_t before = realRootsFallbacks();
        int failures = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const test::HardPolynomial hard(table, row);
            const std::string mistake = hard.mistakeIn(found(hard.coefficients, hard.low, hard.high));
            if (mistake.empty()) continue;
            ++failures;
            qWarning("%s: %s", table.field(row, "case_id").c_str(), mistake.c_str());
        }
        qInfo("%zu polynomials, %zu left to wide arithmetic", table.rowCount(),
              realRootsFallbacks() - before);
        QCOMPARE(failures, 0);
    }

    void agreesWithTheWideArithmetic() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const auto uniform = [&](double low, double high) {
            return low + (high - low) * random.generateDouble();
        };
        for (int round = 0; round < 3000; ++round) {
            const auto degree = static_cast<std::size_t>(1 + random.bounded(12));
            std::vector<double> coefficients(degree + 1);
            for (double& c : coefficients) c = uniform(-1, 1) * std::exp2(uniform(-8, 8));
            const double low = uniform(-30, 5), high = low + std::exp2(uniform(-3, 12));
            const auto wanted = polynomialRoots(coefficients, low, high);
            const auto got = found(coefficients, low, high);
            QCOMPARE(got.size(), wanted.size());
            for (std::size_t k = 0; k < got.size(); ++k)
                QVERIFY(std::abs(got[k] - wanted[k]) <= 1e-9 * std::max(1.0, std::abs(wanted[k])));
        }
    }

    /// Rays through nodes and cusps of a surface, along its axes, used to stop at places where it has no
    /// wall.
    void touchingRootsAreLeftOut() {
        using Roots = std::vector<double>;
        QCOMPARE(found(withRoots({0, 0, 0, 0, -1}), -9, 9), (Roots{-1}));
        QCOMPARE(found(withRoots({2, 2, 5}), -9, 9), (Roots{5}));
        QCOMPARE(found(withRoots({2, 2, 2, 5}), -9, 9), (Roots{2, 5}));
        QCOMPARE(found(withRoots({0, 0, 3, 3}), -9, 9), Roots());
        QCOMPARE(found(withRoots({0, 0, 1, 3, 3, 4, 4, 4}), -9, 9), (Roots{1, 4}));
        QCOMPARE(polynomialRoots(withRoots({0, 0, 3, 3}), -9, 9), (Roots{0, 3}));
    }

    void ordinaryPolynomialsNeedNoWideArithmetic() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const std::size_t before = realRootsFallbacks();
        for (int round = 0; round < 2000; ++round) {
            std::vector<double> roots;
            for (int k = 0; k < 4; ++k) roots.push_back(k + 0.1 + 0.8 * random.generateDouble());
            const std::vector<double> got = found(withRoots(roots), -1, 5);
            QCOMPARE(got.size(), roots.size());
            for (std::size_t k = 0; k < got.size(); ++k) QVERIFY(std::abs(got[k] - roots[k]) < 1e-9);
        }
        QVERIFY(realRootsFallbacks() - before < 40);
    }

    void rootsAtTheEndsAndAtZero() {
        QCOMPARE(found({1, -6, 11, -6}, 1, 3), (std::vector<double>{1, 2, 3}));
        QCOMPARE(found({1, 0, -1, 0}, -2, 2), (std::vector<double>{-1, 0, 1}));
        QCOMPARE(found({1, 0, 0, 0}, -2, 2), std::vector<double>{0});
    }

    void quadratics() {
        QCOMPARE(found({1, -3, 2}, 0, 5), (std::vector<double>{1, 2}));
        QCOMPARE(found({1, -2, 1}, 0, 5), std::vector<double>{1});
        QVERIFY(found({1, -2, 1.0000001}, 0, 5).empty());
        // No cancellation: 1e-8 is right to the last digits.
        const std::vector<double> wide = found({1, -1e8, 1}, 0, 1e9);
        QCOMPARE(wide.size(), std::size_t{2});
        QVERIFY(std::abs(wide[0] - 1e-8) < 1e-22);
        QCOMPARE(found({0, 0, 2, -1}, 0, 1), std::vector<double>{0.5});
    }

    void farRoots() {
        const std::vector<double> got = found(withRoots({0.001, 3, 2e6}), 0, 1e7);
        QCOMPARE(got.size(), std::size_t{3});
        QVERIFY(std::abs(got[0] - 0.001) < 1e-9 && std::abs(got[1] - 3) < 1e-8 &&
                std::abs(got[2] - 2e6) < 1e-4);
    }

    void degreesUpToTheLimitAreSolved() {
        const auto powerLessOne = [](std::size_t degree) {
            std::vector<double> coefficients(degree + 1);
            coefficients.front() = 1;
            coefficients.back() = -1;
            return coefficients;
        };
        QCOMPARE(found(powerLessOne(realRootsDegreeLimit - 1), -2, 2), std::vector<double>{1});
        QCOMPARE(found(powerLessOne(realRootsDegreeLimit), -2, 2), (std::vector<double>{-1, 1}));
        QVERIFY(found(powerLessOne(realRootsDegreeLimit + 1), -2, 2).empty());
    }

    void degenerateInput() {
        QVERIFY(found({0, 0, 0}, -1, 1).empty());
        QVERIFY(found({0, 3}, -1, 1).empty());
        QVERIFY(found({1, NAN, 0, 1}, -1, 1).empty());
        QVERIFY(found({1, 0, 0, 1}, 1, -1).empty());
        QVERIFY(found({1, 0, 0, 1}, 0, INFINITY).empty());
        QVERIFY(found({}, -1, 1).empty());
    }
};

QTEST_APPLESS_MAIN(RealRootsTest)
#include "real_roots_test.moc"

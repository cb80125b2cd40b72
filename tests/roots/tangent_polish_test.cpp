// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/tangent_polish.h"

#include <QTest>
#include <cmath>

#include "tests/support/tape_of.h"

using namespace isoscope;
using test::tapeOf;

namespace {

/// Brackets on lines from (x, 0, -3) along z.
class Brackets {
  public:
    explicit Brackets(double accuracy) { settings_.accuracy = accuracy; }

    void add(double x, double low, double length) {
        const std::size_t i = columns.size();
        columns.reserve(i + 1);
        using March = MarchKernel;
        for (std::size_t c = 0; c < March::columnCount; ++c) columns[c][i] = 0;
        for (const auto& [column, value] :
             std::initializer_list<std::pair<March::Column, double>>{{March::line, static_cast<double>(i)},
                                                                     {March::start, low},
                                                                     {March::length, length},
                                                                     {March::far, 10},
                                                                     {March::sign, 1},
                                                                     {March::resolution, 1e-12},
                                                                     {March::tolerance, settings_.accuracy},
                                                                     {March::originX, x},
                                                                     {March::originZ, -3},
                                                                     {March::directionZ, 1}})
            columns[column][i] = value;
        columns.setSize(i + 1);
    }
    FirstRoots polish(std::shared_ptr<const Tape> tape, double sufficient = 0) {
        FirstRoots roots;
        roots.clear(columns.size());
        TaylorEvaluator tangents(std::move(tape), {});
        TangentPolish(tangents, settings_).run(found, sufficient, nullptr, roots);
        return roots;
    }

    MarchKernel::Results found;
    MarchKernel::Columns& columns = found.brackets;

  private:
    RootSettings settings_;
};

std::shared_ptr<const Tape> sphere() {
    return tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1; });
}

}  // namespace

class TangentPolishTest : public QObject {
    Q_OBJECT

  private slots:
    void rootsOfSpheresAreToldWithTheirNormals() {
        Brackets brackets(1e-3);
        for (int k = 0; k < 100; ++k) {
            const double x = 0.005 * k;
            // The root is somewhere near the middle.
            brackets.add(x, 3 - std::sqrt(1 - x * x) - 5e-4 - 1e-6 * (k - 50), 1e-3);
        }
        const FirstRoots roots = brackets.polish(sphere());
        QVERIFY(brackets.columns.empty());
        for (int k = 0; k < 100; ++k) {
            const double x = 0.005 * k, z = -std::sqrt(1 - x * x);
            QVERIFY(std::abs(roots.crossings[FirstRoots::t][k] - 3 - z) <= TangentPolish::leftover * 1e-3);
            QVERIFY(std::abs(roots.crossings[FirstRoots::normalX][k] - x) <= TangentPolish::turn);
            QVERIFY(std::abs(roots.crossings[FirstRoots::normalZ][k] - z) <= TangentPolish::turn);
        }
    }

    /// Where the normal could turn, roots are known all the same.
    void widerBracketsBecomeCrossings() {
        Brackets brackets(1e-3);
        brackets.add(0.5, 2, 0.3);
        brackets.add(0.3, 2, 0.1);
        brackets.polish(sphere());
        QVERIFY(brackets.columns.empty());
        const MarchKernel::Crossings& crossings = brackets.found.crossings;
        QCOMPARE(crossings.size(), 2U);
        for (std::size_t k = 0; k < 2; ++k) {
            const double x = k == 0 ? 0.5 : 0.3, t = 3 - std::sqrt(1 - x * x);
            QCOMPARE(crossings[MarchKernel::foundLine][k], static_cast<double>(k));
            QVERIFY(crossings[MarchKernel::low][k] <= t && t <= crossings[MarchKernel::high][k]);
            QVERIFY(crossings[MarchKernel::high][k] - crossings[MarchKernel::low][k] <= 1e-3);
        }
    }

    /// Where the function bends too much for the accuracy, at kinks, and before what counts.
    void whatIsNotCertainStays() {
        Brackets wide(1e-6);
        wide.add(0.5, 2, 0.3);
        wide.add(0.3, 3 - std::sqrt(0.91) - 1e-5, 2e-5);
        wide.add(0.3, 2, 0.1);
        const FirstRoots found = wide.polish(sphere());
        QCOMPARE(wide.columns.size(), 2U);
        QCOMPARE(wide.columns[MarchKernel::line][0], 0.0);
        QCOMPARE(wide.columns[MarchKernel::length][1], 0.1);
        QCOMPARE(found.crossings[FirstRoots::t][0], FirstRoots::none);
        QVERIFY(std::abs(found.crossings[FirstRoots::t][1] - 3 + std::sqrt(0.91)) < 1e-9);

        Brackets kink(1e-3);
        kink.add(0, 2.999, 3e-3);
        kink.polish(tapeOf([](auto, auto, auto z) { return abs(z) * 3 - z * 2 - 1e-4; }));
        QCOMPARE(kink.columns.size(), 1U);

        Brackets early(1e-3);
        early.add(0.3, 3 - std::sqrt(0.91) - 1e-4, 2e-4);
        early.polish(sphere(), 2.5);
        QCOMPARE(early.columns.size(), 1U);
    }
};

QTEST_APPLESS_MAIN(TangentPolishTest)
#include "tangent_polish_test.moc"

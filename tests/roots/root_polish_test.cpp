// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/root_polish.h"

#include <cmath>
#include <QTest>

#include "tests/support/tape_of.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Polishes the roots of f along many lines beside the x axis, y = 0.001 k, known within +-`half` around
/// `middle`; `steepness` and `leftover` are what a search would tell.
template <class Make>
std::vector<Root> polish(Make make, double middle, double half, double steepness, double leftover,
                         std::uint64_t* evaluations = nullptr, const RootSettings& settings = {}) {
    PointEvaluator points(tapeOf(make), {});
    std::vector<LineQuery> queries;
    std::vector<RootList> roots;
    std::vector<RoughRoot> rough;
    for (std::size_t k = 0; k < 100; ++k) {
        queries.push_back({{0, 0.001 * static_cast<double>(k), 0}, {1, 0, 0}, 0, 10});
        roots.push_back({{middle, RootKind::crossing}});
        rough.push_back({k, 0, middle - half, middle + half, steepness, leftover});
    }
    RootPolish(points, settings).run(rough, queries, roots);
    if (evaluations) *evaluations = points.evaluations();
    std::vector<Root> result;
    for (const RootList& list : roots) result.push_back(list.at(0));
    return result;
}

double y(std::size_t k) { return 0.001 * static_cast<double>(k); }

}  // namespace

class RootPolishTest : public QObject {
    Q_OBJECT

  private slots:
    void smoothRootsTakeFewValues() {
        const auto circle = [](auto x, auto y, auto) { return sq(x) + sq(y) - 4; };
        std::uint64_t evaluations = 0;
        const std::vector<Root> roots = polish(circle, 1.998, 0.01, 4, 1, &evaluations);
        for (std::size_t k = 0; k < roots.size(); ++k)
            QVERIFY(std::abs(roots[k].t - std::sqrt(4 - y(k) * y(k))) < 1e-7);
        QVERIFY2(evaluations <= 300, qPrintable(QString::number(evaluations)));
    }

    /// Products of such values are 0.
    void tinyValuesAreNarrowedDown() {
        const auto circle = [](auto x, auto y, auto) { return 1e-160 * abs(sq(x) + sq(y) - 4) * (x - 1.5); };
        const std::vector<Root> roots = polish(circle, 1.51, 0.1, 0, 1);
        for (const Root& root : roots)
            QVERIFY2(std::abs(root.t - 1.5) < 1e-5, qPrintable(QString::number(root.t)));
    }

    void whatIsNearlyStraightTakesOneValue() {
        const auto circle = [](auto x, auto y, auto) { return sq(x) + sq(y) - 4; };
        std::uint64_t evaluations = 0;
        const std::vector<Root> roots = polish(circle, 1.99875, 0.0013, 3.9975, 1e-5, &evaluations);
        for (std::size_t k = 0; k < roots.size(); ++k)
            QVERIFY(std::abs(roots[k].t - std::sqrt(4 - y(k) * y(k))) < 1e-5);
        QCOMPARE(evaluations, std::uint64_t(100));
    }

    void aWrongSlopeDoesNoHarm() {
        const auto circle = [](auto x, auto y, auto) { return sq(x) + sq(y) - 4; };
        for (const double steepness : {0.0, -4.0, 1e-3, 1e9, std::nan(""), double(INFINITY)}) {
            const std::vector<Root> roots = polish(circle, 1.998, 0.01, steepness, 1);
            for (std::size_t k = 0; k < roots.size(); ++k) {
                QVERIFY(std::abs(roots[k].t - std::sqrt(4 - y(k) * y(k))) < 2e-6);
                QCOMPARE(roots[k].kind, RootKind::crossing);
            }
        }
    }

    void thresholdAndPolarityCount() {
        const auto inverted = [](auto x, auto y, auto) { return 7 - sq(x) - sq(y); };
        RootSettings settings;
        settings.threshold = 3;
        settings.positivePolarity = true;
        std::uint64_t evaluations = 0;
        const std::vector<Root> roots = polish(inverted, 1.998, 0.01, 4, 1, &evaluations, settings);
        for (std::size_t k = 0; k < roots.size(); ++k)
            QVERIFY(std::abs(roots[k].t - std::sqrt(4 - y(k) * y(k))) < 1e-7);
        QVERIFY2(evaluations <= 300, qPrintable(QString::number(evaluations)));
    }

    /// Infinite up to right before the root, which is by a small part of the interval before the last of
    /// eight halvings.
    void whatIsInfiniteOnOneSideIsHalved() {
        constexpr double middle = 2, half = 0.5, root = middle - half + 255.0 / 256 - 1e-7;
        const auto steep = [](auto x, auto, auto) { return exp(1e6 * (root - x)) - 1; };
        std::uint64_t evaluations = 0;
        for (const Root& found : polish(steep, middle, half, 0, 1, &evaluations)) {
            QCOMPARE(found.kind, RootKind::crossing);
            QVERIFY(std::abs(found.t - root) <= 2 * half / 256);
        }
        // One at the middle, two at the ends, eight halvings.
        QCOMPARE(evaluations, std::uint64_t(1100));
    }

    void kinksAreMetToo() {
        // Slope 1 before x = 2 + y, 20 behind.
        const auto kink = [](auto x, auto y, auto) { return max(x - 2 - y, 20 * (x - 2 - y)); };
        const std::vector<Root> roots = polish(kink, 2.05, 0.06, 10, 1);
        for (std::size_t k = 0; k < roots.size(); ++k) QVERIFY(std::abs(roots[k].t - 2 - y(k)) < 0.02 * 0.12);
    }

    void jumpsBecomeJumps() {
        const auto steps = [](auto x, auto y, auto) { return floor(x + y) - 1.5; };
        for (const Root& root : polish(steps, 1.95, 0.06, 10, 1)) {
            QCOMPARE(root.kind, RootKind::jump);
            QVERIFY(root.t >= 1.89 && root.t <= 2.01);
        }
    }
};

QTEST_APPLESS_MAIN(RootPolishTest)
#include "root_polish_test.moc"

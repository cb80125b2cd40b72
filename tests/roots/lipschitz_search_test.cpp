// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_search.h"

#include <cmath>
#include <limits>
#include <QTest>

#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "tests/roots/lambda_field.h"

using namespace isoscope;
using isoscope::test::LambdaField;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

struct Outcome {
    RootList roots;
    std::vector<double> visited;
    GradientMemory memory;
    bool exhausted = false;
};

/// The search of one line by itself; f takes the x of the point.
Outcome searchLine(const std::function<double(double)>& f, const LineQuery& query,
                   const RootSettings& settings) {
    Outcome outcome;
    LipschitzRootFinder finder(std::make_unique<LambdaField>([&](const glm::dvec3& point) {
                                   outcome.visited.push_back(point.x);
                                   return f(point.x);
                               }),
                               settings);
    finder.find(std::span(&query, 1), {}, std::span(&outcome.roots, 1));
    outcome.memory = {finder.report().maxGradient, finder.report().steepest};
    outcome.exhausted = finder.report().exhausted != 0;
    return outcome;
}

/// The search along the x axis from x = 0, t = x, between `near` and `far`.
Outcome searchAlongX(const std::function<double(double)>& f, double near, double far,
                     const RootSettings& settings) {
    return searchLine(f, {{0, 0, 0}, {1, 0, 0}, near, far}, settings);
}

RootSettings settingsWith(double accuracy, double maxGradient, bool open = false, int maxTrace = 1) {
    RootSettings settings;
    settings.accuracy = accuracy;
    settings.maxGradient = maxGradient;
    settings.open = open;
    settings.maxTrace = maxTrace;
    return settings;
}

}  // namespace

class LipschitzSearchTest : public QObject {
    Q_OBJECT

  private slots:
    void hitIsTheRightEndOfTheLastInterval() {
        // Halving [1, 3] down to below 0.5: the interval around 2.3 is [2.25, 2.5].
        const Outcome outcome = searchAlongX([](double x) { return 2.3 - x; }, 1, 3, settingsWith(0.5, 1));
        QCOMPARE(outcome.roots, (RootList{{2.5, RootKind::crossing}}));
    }

    void hitLiesUpToTheAccuracyBeyondTheRoot() {
        const Outcome outcome = searchAlongX([](double x) { return 2.3 - x; }, 1, 3, settingsWith(1e-3, 1));
        QCOMPARE(outcome.roots.size(), std::size_t(1));
        QVERIFY(outcome.roots[0].t >= 2.3 && outcome.roots[0].t < 2.3 + 1e-3);
    }

    void entryFromOutsideIntoTheSolidIsTheWall() {
        const Outcome outcome = searchAlongX([](double x) { return x - 2; }, 1, 3, settingsWith(1e-3, 1.1));
        QCOMPARE(outcome.roots, (RootList{{1, RootKind::entryWall}}));
        QCOMPARE(outcome.visited.size(), std::size_t(1));
    }

    void entryWallCountsAgainstMaxTrace() {
        const Outcome outcome =
            searchAlongX([](double x) { return x - 2; }, 1, 3, settingsWith(1e-3, 1.1, false, 2));
        QCOMPARE(outcome.roots.size(), std::size_t(2));
        QCOMPARE(outcome.roots[0].kind, RootKind::entryWall);
        QCOMPARE(outcome.roots[1].kind, RootKind::crossing);
        QVERIFY(outcome.roots[1].t > 2 && outcome.roots[1].t < 2.001);
    }

    void exitFromTheSolidIsNoHitForRaysFromOutside() {
        const Outcome outcome =
            searchAlongX([](double) { return -1.0; }, 1, 3, settingsWith(1e-3, 1, false, 10));
        QCOMPARE(outcome.roots, (RootList{{1, RootKind::entryWall}}));
    }

    void exitFromTheSolidIsAHitForRaysFromInside() {
        const Outcome outcome = searchAlongX([](double) { return -1.0; }, 0, 3, settingsWith(1e-3, 1));
        QCOMPARE(outcome.roots, (RootList{{3, RootKind::exitWall}}));
    }

    void exitWallDoesNotCountAgainstMaxTrace() {
        const Outcome outcome = searchAlongX([](double x) { return 1 - x; }, 0, 3, settingsWith(1e-3, 1.1));
        QCOMPARE(outcome.roots.size(), std::size_t(2));
        QCOMPARE(outcome.roots[0].kind, RootKind::crossing);
        QCOMPARE(outcome.roots[1], (Root{3, RootKind::exitWall}));
    }

    void startNoFartherThanTheAccuracyCountsAsInside() {
        const auto solid = [](double) { return -1.0; };
        QCOMPARE(searchAlongX(solid, 0.1, 3, settingsWith(0.1, 1)).roots,
                 (RootList{{3, RootKind::exitWall}}));
        QCOMPARE(searchAlongX(solid, 0.15, 3, settingsWith(0.1, 1)).roots,
                 (RootList{{0.15, RootKind::entryWall}}));
    }

    void startOnTheSurfaceMovesByFiveAccuracies() {
        // g(0) = 0.03 < 4 M A: the crossing at 0.03 belongs to the start and is not met.
        const Outcome outcome =
            searchAlongX([](double x) { return 0.03 - x; }, 0, 3, settingsWith(0.01, 1.1));
        QCOMPARE(outcome.roots, (RootList{{3, RootKind::exitWall}}));
        QCOMPARE(outcome.visited[1], 0.05);
    }

    void startBeyondFourMATakesTheCrossing() {
        const Outcome outcome =
            searchAlongX([](double x) { return 0.045 - x; }, 0, 3, settingsWith(0.01, 1.1));
        QCOMPARE(outcome.roots.size(), std::size_t(2));
        QVERIFY(outcome.roots[0].t >= 0.045 && outcome.roots[0].t < 0.055);
    }

    void startInsideTheSolidFindsTheWayOut() {
        const Outcome outcome = searchAlongX([](double x) { return x - 1; }, 0, 3, settingsWith(1e-3, 1.1));
        QCOMPARE(outcome.roots.size(), std::size_t(1));
        QCOMPARE(outcome.roots[0].kind, RootKind::crossing);
        QVERIFY(outcome.roots[0].t > 1 && outcome.roots[0].t < 1.001);
    }

    void chordBelowTheAccuracyShowsNothing() {
        const auto solid = [](double) { return -1.0; };
        QVERIFY(searchAlongX(solid, 1, 1.09, settingsWith(0.1, 1)).roots.empty());
        QCOMPARE(searchAlongX(solid, 1, 1.11, settingsWith(0.1, 1)).roots.size(), std::size_t(1));
    }

    void chordShortenedBelowTheAccuracyShowsNothing() {
        // Measured on POV-Ray: accuracy 0.1, from 0.55 or less before the exit the wall is not seen.
        const auto solid = [](double) { return -1.0; };
        QVERIFY(searchAlongX(solid, 0, 0.55, settingsWith(0.1, 1.1)).roots.empty());
        QCOMPARE(searchAlongX(solid, 0, 0.65, settingsWith(0.1, 1.1)).roots,
                 (RootList{{0.65, RootKind::exitWall}}));
    }

    void openSurfaceHasNoWallsAndShowsBackFaces() {
        const Outcome outcome =
            searchAlongX([](double x) { return x - 2; }, 1, 3, settingsWith(1e-3, 1.1, true, 10));
        QCOMPARE(outcome.roots.size(), std::size_t(1));
        QCOMPARE(outcome.roots[0].kind, RootKind::crossing);
        QVERIFY(outcome.roots[0].t > 2 && outcome.roots[0].t < 2.001);
        QVERIFY(searchAlongX([](double) { return -1.0; }, 0, 3, settingsWith(1e-3, 1, true)).roots.empty());
    }

    void openSurfaceIsNotMetByItsOwnStart() {
        const auto f = [](double x) { return 0.03 - x; };
        QVERIFY(searchAlongX(f, 0, 3, settingsWith(0.01, 1.1, true)).roots.empty());
        // The same distance to a start outside the container is no start on the surface.
        QCOMPARE(searchAlongX(f, 0.015, 3, settingsWith(0.01, 1.1, true)).roots.size(), std::size_t(1));
    }

    void maxTraceLimitsTheCrossings() {
        const auto wave = [](double x) { return std::sin(x); };
        for (int maxTrace = 1; maxTrace <= 10; ++maxTrace) {
            const Outcome outcome = searchAlongX(wave, 1, 60, settingsWith(1e-4, 1, false, maxTrace));
            QCOMPARE(outcome.roots.size(), std::size_t(maxTrace));
            for (int k = 0; k < maxTrace; ++k)
                QVERIFY(std::abs(outcome.roots[std::size_t(k)].t - (k + 1) * M_PI) < 1e-4);
        }
        QCOMPARE(searchAlongX(wave, 1, 60, settingsWith(1e-4, 1, false, 99)).roots.size(), std::size_t(10));
    }

    void searchGoesOnFiveAccuraciesBehindAHit() {
        // A second root 0.03 behind the first is jumped over with accuracy 0.01; the sign is then wrong for
        // what follows, as in POV-Ray.
        const auto f = [](double x) { return (x - 1) * (x - 1.03); };
        const Outcome outcome = searchAlongX(f, 0.5, 1.5, settingsWith(0.01, 50, false, 10));
        QCOMPARE(outcome.roots.size(), std::size_t(2));
        QVERIFY(outcome.roots[1].t >= outcome.roots[0].t + 0.05);
    }

    void boundThatIsTooSmallLosesTheRoot() {
        // Slope 1, but M = 0.5: h1 + h2 = 0.5 + 0.5 is enough to dismiss [0.5, 1.5] around the notch at 1.
        const auto notch = [](double x) { return std::abs(x - 1) - 0.01; };
        QVERIFY(searchAlongX(notch, 0.5, 1.5, settingsWith(1e-3, 0.5)).roots.empty());
        QCOMPARE(searchAlongX(notch, 0.5, 1.5, settingsWith(1e-3, 1)).roots.size(), std::size_t(1));
    }

    void remembersTheSteepestSlope() {
        const Outcome outcome = searchAlongX([](double x) { return 6 - 3 * x; }, 1, 4, settingsWith(1e-3, 3));
        QVERIFY(std::abs(outcome.memory.steepest - 3) < 1e-9);
        QCOMPARE(outcome.memory.bound, 3.0);
    }

    void slopeIsPerUnitOfLength() {
        const Outcome outcome = searchLine([](double x) { return 6 - 3 * x; }, {{0, 0, 0}, {2, 0, 0}, 0.5, 2},
                                           settingsWith(1e-3, 3));
        QVERIFY(std::abs(outcome.memory.steepest - 3) < 1e-9);
    }

    void evaluateGrowsAndShrinksTheBound() {
        RootSettings settings = settingsWith(1e-3, 1);
        settings.evaluate = {1, 1.5, 0.8};
        // One slope everywhere: 2 * 1.5 > 1, so M becomes 2 * 1.5^2 and stays.
        const auto f = [](double x) { return 4 - 2 * x; };
        QVERIFY(std::abs(searchAlongX(f, 1, 3, settings).memory.bound - 4.5) < 1e-9);
        // The second search of the ray begins by shrinking M to 3.6; the slope is no reason to grow again.
        settings.maxTrace = 2;
        QVERIFY(std::abs(searchAlongX(f, 1, 3, settings).memory.bound - 3.6) < 1e-9);
    }

    void evaluateBeginsWithMaxGradient() {
        // As measured: P0 = 1 with max_gradient 10 finds the notch of slope 10 on the first ray, P0 = 10 with
        // max_gradient 1.1 does not.
        const auto notch = [](double x) { return std::abs(x - 3.37) * 10 - 0.2; };
        RootSettings settings = settingsWith(1e-4, 10);
        settings.evaluate = {1, 1.0001, 0.9999};
        QCOMPARE(searchAlongX(notch, 2, 4, settings).roots.size(), std::size_t(1));
        settings.maxGradient = 1.1;
        settings.evaluate = {10, 1.0001, 0.999};
        QVERIFY(searchAlongX(notch, 2, 4, settings).roots.empty());
    }

    void polarityTurnsInsideOut() {
        RootSettings settings = settingsWith(1e-3, 1.1);
        settings.positivePolarity = true;
        const Outcome outcome = searchAlongX([](double x) { return 2 - x; }, 1, 3, settings);
        QCOMPARE(outcome.roots, (RootList{{1, RootKind::entryWall}}));
    }

    void thresholdMovesTheSurface() {
        RootSettings settings = settingsWith(1e-3, 1.1);
        settings.threshold = -0.5;
        const Outcome outcome = searchAlongX([](double x) { return 2 - x; }, 1, 3, settings);
        QCOMPARE(outcome.roots.size(), std::size_t(1));
        QVERIFY(std::abs(outcome.roots[0].t - 2.5) < 1e-3);
    }

    void uselessSettingsGetTheirDefaults() {
        RootSettings settings = settingsWith(0, -1);
        settings.maxTrace = 0;
        QCOMPARE(settings.usable().accuracy, 0.001);
        QCOMPARE(settings.usable().maxGradient, 1.1);
        QCOMPARE(settings.usable().maxTrace, 1);
        settings.accuracy = settings.maxGradient = notANumber;
        QCOMPARE(settings.usable().accuracy, 0.001);
        QCOMPARE(settings.usable().maxGradient, 1.1);
        settings.evaluate = {2, notANumber, 7};
        QCOMPARE(*settings.usable().evaluate, (std::array{2.0, 1.0, 1.0}));
        settings.evaluate = {-1, 2, 0};
        QCOMPARE(*settings.usable().evaluate, (std::array{1.1, 2.0, 1.0}));
    }

    void nanAtEitherEndHidesTheInterval() {
        // As measured: f is NaN for x < 0 of sqrt(x) - 0.5; neither direction shows the root at 0.25.
        const auto f = [](double x) { return x < 2 ? notANumber : std::sqrt(x - 2) - 0.5; };
        QVERIFY(searchAlongX(f, 1, 3, settingsWith(1e-3, 10)).roots.empty());
        const auto back = [&](double x) { return f(4 - x); };
        QVERIFY(searchAlongX(back, 1, 3, settingsWith(1e-3, 10)).roots.empty());
    }

    void nanInTheMiddleHidesBothHalves() {
        const auto f = [](double x) { return std::abs(x - 2) < 0.01 ? notANumber : 1.5 - x; };
        QVERIFY(searchAlongX(f, 1, 3, settingsWith(1e-3, 1.1)).roots.empty());
        QCOMPARE(searchAlongX(f, 1, 3.2, settingsWith(1e-3, 1.1)).roots.size(), std::size_t(1));
    }

    void infiniteValuesEndTheSearch() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double below : {-infinity, -1.0, notANumber})
            for (const double above : {infinity, 1.0, notANumber}) {
                const auto step = [&](double x) { return x < 2.2 ? above : below; };
                const Outcome outcome = searchAlongX(step, 1, 3, settingsWith(1e-3, 1.1, false, 10));
                QVERIFY(outcome.visited.size() < 10000);
                for (const Root& root : outcome.roots) QVERIFY(std::isfinite(root.t));
                QVERIFY(std::isfinite(outcome.memory.steepest));
            }
    }

    void accuracyBelowTheNumbersStillEnds() {
        const Outcome outcome =
            searchAlongX([](double x) { return 2.3 - x; }, 1, 3, settingsWith(1e-300, 1, false, 10));
        QCOMPARE(outcome.roots[0].t, 2.3);
        QVERIFY(outcome.visited.size() < 500);
        const auto zero = [](double x) { return x - 1e-200; };
        QVERIFY(searchAlongX(zero, 0, 1, settingsWith(1e-300, 1, true, 10)).visited.size() < 5000);
    }

    void budgetEndsHopelessSearches() {
        const Outcome outcome = searchAlongX([](double) { return 1.0; }, 1, 3, settingsWith(1e-12, 1e9));
        QVERIFY(outcome.exhausted);
        QVERIFY(outcome.roots.empty());
        QVERIFY(outcome.visited.size() <= LipschitzSearch::evaluationLimit + 1);
        QVERIFY(!searchAlongX([](double) { return 1.0; }, 1, 3, settingsWith(1e-3, 1e9)).exhausted);
    }

    void emptyAndBrokenLinesShowNothing() {
        const auto solid = [](double) { return -1.0; };
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const auto& [near, far] :
             {std::pair(2.0, 1.0), std::pair(notANumber, 1.0), std::pair(0.0, notANumber),
              std::pair(0.0, infinity), std::pair(notANumber, notANumber)})
            QVERIFY(searchAlongX(solid, near, far, settingsWith(1e-3, 1)).roots.empty());
        for (const double direction : {0.0, notANumber})
            QVERIFY(searchLine(solid, {{0, 0, 0}, {direction, 0, 0}, 0, 1}, RootSettings()).visited.empty());
    }
};

QTEST_APPLESS_MAIN(LipschitzSearchTest)
#include "lipschitz_search_test.moc"

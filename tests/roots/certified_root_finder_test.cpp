// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/certified_root_finder.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/function/graph_builder.h"
#include "core/roots/polynomial/wide_number.h"
#include "tests/roots/line_table.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(271828);

RootSettings openSettings(double accuracy = 0.001, int maxTrace = 1) {
    RootSettings settings;
    settings.accuracy = accuracy;
    settings.open = true;
    settings.maxTrace = maxTrace;
    return settings;
}

/// From -3 to 3 along x, at the given y and z.
LineQuery along(double y = 0, double z = 0) { return {{-3, y, z}, {1, 0, 0}, 0, 6}; }

struct Answer {
    RootList roots;
    Verdict verdict;
    std::uint64_t evaluations;
};

Answer ask(const std::shared_ptr<const Tape>& tape, const LineQuery& line, const RootSettings& settings,
           double sufficient = INFINITY) {
    CertifiedRootFinder finder(tape, {}, settings);
    RootRequest request;
    request.sufficient = sufficient;
    Answer answer;
    finder.find({&line, 1}, request, {&answer.roots, 1});
    answer.verdict = finder.verdicts()[0];
    answer.evaluations = finder.report().evaluations;
    return answer;
}

const auto sphere = [](auto x, auto y, auto z) { return sqrt(sq(x) + sq(y) + sq(z)) - 1; };

}  // namespace

class CertifiedRootFinderTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void findsTheSphereFarBelowTheAccuracy() {
        const Answer answer = ask(tapeOf(sphere), along(0.3, 0.4), openSettings(0.001, 10));
        QCOMPARE(answer.roots.size(), std::size_t(2));
        QVERIFY(std::abs(answer.roots[0].t - (3 - std::sqrt(0.75))) < 1e-9);
        QVERIFY(std::abs(answer.roots[1].t - (3 + std::sqrt(0.75))) < 1e-9);
        QCOMPARE(answer.roots[0].kind, RootKind::crossing);
        QCOMPARE(answer.verdict, Verdict::certifiedHit);
        QVERIFY(answer.evaluations < 60);
    }

    void stopsAtTheFirstRootBeyondWhatIsSufficient() {
        QCOMPARE(ask(tapeOf(sphere), along(), openSettings(), 0).roots.size(), std::size_t(1));
        QCOMPARE(ask(tapeOf(sphere), along(), openSettings()).roots.size(), std::size_t(1));
        // What comes before does not count, and is not looked for.
        const RootList roots = ask(tapeOf(sphere), along(), openSettings(), 2.5).roots;
        QCOMPARE(roots.size(), std::size_t(1));
        QVERIFY(std::abs(roots[0].t - 4) < 1e-9);
    }

    /// As shadow rays do. No sign is certain on the surface itself.
    void linesThatBeginOnTheSurfaceNeedFewEnclosures() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-1, 1);
        std::uint64_t evaluations = 0;
        int leaving = 0;
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec3 start =
                glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
            const glm::dvec3 way =
                glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
            const double cosine = glm::dot(start, way);
            if (std::abs(cosine) < 0.01) continue;
            const Answer answer = ask(tapeOf(sphere), {start, way, 0, 6}, openSettings(), 1e-3);
            evaluations += answer.evaluations;
            leaving += cosine > 0;
            QCOMPARE(answer.roots.size(), std::size_t(cosine < 0));
            if (cosine < 0) QVERIFY(std::abs(answer.roots[0].t + 2 * cosine) < 1e-7);
        }
        qInfo("%g evaluations a line", static_cast<double>(evaluations) / 1000);
        QVERIFY(leaving > 300);
        QVERIFY(evaluations < 15 * 1000);
    }

    /// Inside, then without a value, then outside: no surface, though the next jump has the outside on both
    /// sides that have a value.
    void placesWithoutAValueAreNoSideOfAJump() {
        const auto tape = tapeOf([](auto x, auto y, auto) {
            return select(x + 1.01, x.number(-1), select(x - 0.37, sqrt(-1 - sq(y)), x.number(1)));
        });
        for (const double sufficient : {0.0, double(INFINITY)}) {
            const Answer answer = ask(tape, along(), openSettings(), sufficient);
            QVERIFY(answer.roots.empty());
            QVERIFY(answer.verdict != Verdict::certifiedHit);
        }
    }

    void aMissIsCertified() {
        const Answer answer = ask(tapeOf(sphere), along(1.01), openSettings());
        QVERIFY(answer.roots.empty());
        QCOMPARE(answer.verdict, Verdict::certifiedMiss);
    }

    void findsSheetsMuchThinnerThanTheAccuracy() {
        const auto tape = tapeOf([](auto x, auto, auto) { return abs(x) - 1e-5; });
        const Answer answer = ask(tape, along(), openSettings(0.001, 10));
        QCOMPARE(answer.roots.size(), std::size_t(2));
        QVERIFY(std::abs(answer.roots[1].t - answer.roots[0].t - 2e-5) < 1e-12);
    }

    void anEvenContactIsAGapWithoutARoot() {
        const auto tape = tapeOf([](auto x, auto y, auto z) { return sq(sq(x) + sq(y) + sq(z) - 1); });
        const Answer answer = ask(tape, along(), openSettings());
        QVERIFY(answer.roots.empty());
        QCOMPARE(answer.verdict, Verdict::gap);
    }

    void tellsJumpsFromCrossings() {
        const Answer jump =
            ask(tapeOf([](auto x, auto, auto) { return floor(x) + 0.5; }), along(), openSettings());
        QCOMPARE(jump.roots.size(), std::size_t(1));
        QCOMPARE(jump.roots[0].kind, RootKind::jump);
        QVERIFY(std::abs(jump.roots[0].t - 3) < 1e-9);
        // A slope without limit is still a crossing.
        const auto steep = tapeOf([](auto x, auto, auto) { return select(x, -sqrt(abs(x)), sqrt(abs(x))); });
        const Answer crossing = ask(steep, along(), openSettings());
        QCOMPARE(crossing.roots.size(), std::size_t(1));
        QCOMPARE(crossing.roots[0].kind, RootKind::crossing);
    }

    void aPoleIsNoSurface() {
        const auto tape = tapeOf([](auto x, auto y, auto) { return y - 0.2 / x; });
        const Answer answer = ask(tape, along(0.5), openSettings(0.001, 10));
        QCOMPARE(answer.roots.size(), std::size_t(1));
        QVERIFY(std::abs(answer.roots[0].t - 3.4) < 1e-9);
    }

    void theEdgeOfTheDomainIsNoSurface() {
        const auto tape = tapeOf([](auto x, auto, auto) { return sqrt(x) - 1; });
        const Answer answer = ask(tape, along(), openSettings(0.001, 10));
        QCOMPARE(answer.roots.size(), std::size_t(1));
        QVERIFY(std::abs(answer.roots[0].t - 4) < 1e-9);
    }

    void plateausEndWithinTheBudget() {
        const auto tape = tapeOf([](auto x, auto, auto) { return max(x.number(0), x); });
        const Answer answer = ask(tape, along(), openSettings(1e-6));
        qInfo("%llu evaluations", static_cast<unsigned long long>(answer.evaluations));
        // The function is exactly 0 there, which is known of long pieces as of short ones.
        QVERIFY(answer.evaluations < 300);
        QCOMPARE(answer.verdict, Verdict::gap);
    }

    /// A bug once: where a function comes down to its threshold and stays there, as noise of the first
    /// generator does, a surface was drawn, though nothing is inside. What is inside behind a plateau begins
    /// where it ends, and what is outside where it begins.
    void plateausAtTheThresholdAreOutside() {
        const auto walled = [](auto x) { return max(abs(x) - 1, 0); };
        const Answer touched =
            ask(tapeOf([&](auto x, auto, auto) { return walled(x); }), along(), openSettings(0.001, 10));
        QVERIFY(touched.roots.empty());
        QCOMPARE(touched.verdict, Verdict::gap);
        // 2 down to x = -1, 0 up to 0.5, then falling, and rising to a plateau that begins at 2.
        const auto step =
            tapeOf([&](auto x, auto, auto) { return max(-1 - x, 0) + min(max(0.5 - x, x - 2), 0); });
        const Answer passed = ask(step, along(), openSettings(0.001, 10));
        QCOMPARE(passed.roots.size(), std::size_t(2));
        QVERIFY(std::abs(passed.roots[0].t + along().origin.x - 0.5) < 1e-6);
        QVERIFY(std::abs(passed.roots[1].t + along().origin.x - 2) < 1e-6);
        // A ball in a field that is 0 all around it: it was met somewhere on the way to it.
        const auto ball = tapeOf([](auto x, auto y, auto) { return -max(0.5 - sqrt(sq(x) + sq(y)), 0); });
        RootSettings closed;
        closed.maxTrace = 10;
        const Answer met = ask(ball, along(), closed);
        QCOMPARE(met.roots.size(), std::size_t(2));
        QVERIFY(std::abs(met.roots[0].t - 2.5) < 1e-6 && std::abs(met.roots[1].t - 3.5) < 1e-6);
    }

    void fastWavesStayWithinTheBudget() {
        const auto tape = tapeOf([](auto x, auto, auto) { return sin(x * 1e6) + 1; });
        const Answer answer = ask(tape, along(), openSettings());
        QVERIFY(answer.evaluations < 6000);
        QVERIFY(answer.verdict == Verdict::gap || answer.verdict == Verdict::budgetExceeded);
    }

    void surfaceInTheWallIsMetOnEntry() {
        // f is exactly 0 where the line enters and negative behind: found by golden rays that enter along an
        // axis.
        const auto tape = tapeOf([](auto x, auto, auto) { return 1 - x; });
        LineQuery query = along();
        query.near = 1 - query.origin.x;
        for (const bool open : {false, true}) {
            RootSettings settings;
            settings.open = open;
            const Answer answer = ask(tape, query, settings);
            QVERIFY(!answer.roots.empty());
            QCOMPARE(answer.roots[0], (Root{query.near, RootKind::crossing}));
        }
    }

    /// A bug once: where enclosures do not tell the sign behind the wall for longer than the accuracy, the
    /// surface in the wall was passed over.
    void surfaceInTheWallIsMetWhereTheSignIsUncertain() {
        const auto tape = tapeOf([](auto x, auto y, auto) { return (1 - x) * (1 + floor(-sq(y))); });
        LineQuery query = along();
        query.near = 1 - query.origin.x;
        RootSettings settings;
        settings.open = false;
        const Answer answer = ask(tape, query, settings);
        QCOMPARE(answer.roots.size(), std::size_t(2));
        QVERIFY(answer.roots[0].t - query.near < 1e-12);
        QCOMPARE(answer.roots[0].kind, RootKind::crossing);
        QCOMPARE(answer.roots[1].kind, RootKind::exitWall);
    }

    /// The value at the wall is that of the other side of the jump; the surface was lost, and certified so.
    void surfaceAtAJumpInTheWallIsMetOnEntry() {
        const auto tape = tapeOf([](auto x, auto, auto) {
            return select(abs(mod(x * 1.5, x.number(2)) - 1) - 0.5, x.number(-0.3), x.number(0.2));
        });
        for (const bool open : {false, true}) {
            RootSettings settings;
            settings.open = open;
            // In from x = 1, where 1.5 x - 1 is 0.5.
            const Answer answer = ask(tape, {{2, 0.1, 0.2}, {-1, 0, 0}, 1, 3}, settings, 0);
            QCOMPARE(answer.roots.size(), std::size_t(1));
            QVERIFY(answer.roots[0].kind == RootKind::crossing && answer.roots[0].t == 1);
            QVERIFY(answer.verdict == Verdict::certifiedHit);
        }
    }

    /// A line as short as the resolution, without bounds in the wall where it enters: what lies right behind
    /// its end is none of it.
    void aShortLineEndsWhereItEnds() {
        constexpr double resolution = 0.003, wall = resolution / 64;
        const auto tape = tapeOf([](auto x, auto, auto) {
            return select(x - (1 + wall / 2), 1 / (x - 1), 1 + resolution + wall / 2 - x);
        });
        const Answer answer = ask(tape, {{0, 0, 0}, {1, 0, 0}, 1, 1 + resolution}, openSettings(1));
        QVERIFY(answer.roots.empty());
        QCOMPARE(answer.verdict, Verdict::certifiedMiss);
    }

    /// The stretch that holds it is halved down to neighbouring doubles, by some 34 values.
    void aPoleIsLookedForOnce() {
        const auto tape = tapeOf([](auto x, auto, auto) { return 1 / x; });
        const Answer answer = ask(tape, along(), openSettings());
        QVERIFY(answer.roots.empty());
        QVERIFY2(answer.evaluations < 130, qPrintable(QString::number(answer.evaluations)));
    }

    /// Each side of the jump is clear of the surface where it holds: one enclosure of the whole piece and one
    /// of each side, and one of the next piece.
    void aJumpOutsideTheSolidTakesAnEnclosureOfEachSide() {
        const auto tape = tapeOf([](auto x, auto, auto) { return select(x - 1.1, 1.2 - x, x - 1.05); });
        const Answer answer = ask(tape, {{0.6, 0, 0}, {1, 0, 0}, 0, 2}, openSettings());
        QVERIFY(answer.roots.empty());
        QCOMPARE(answer.verdict, Verdict::certifiedMiss);
        QCOMPARE(answer.evaluations, std::uint64_t(4));
    }

    void aJumpThroughTheThresholdTakesFewEnclosures() {
        const auto tape = tapeOf([](auto x, auto, auto) { return 2.5 - floor(x); });
        const Answer answer = ask(tape, {{0.6, 0, 0}, {1, 0, 0}, 0, 4}, openSettings(), 0);
        QCOMPARE(answer.roots.size(), std::size_t(1));
        QCOMPARE(answer.roots[0].kind, RootKind::jump);
        QVERIFY2(answer.evaluations < 30, qPrintable(QString::number(answer.evaluations)));
    }

    /// To the last bit: by more digits than the search has.
    void theRootOfAJumpIsBehindIt() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-1, 1);
        const auto tape = tapeOf([](auto x, auto y, auto z) { return 0.5 - floor(x + 2 * y + 4 * z); });
        CertifiedRootFinder finder(tape, {}, openSettings());
        int jumps = 0;
        for (int k = 0; k < 1000; ++k) {
            const LineQuery line{{anywhere(random), anywhere(random), anywhere(random)},
                                 {anywhere(random), anywhere(random), anywhere(random)},
                                 0,
                                 5};
            const auto isBelowOne = [&](Wide t) {
                Wide sum = 0;
                for (int c = 0; c < 3; ++c) sum += (1 << c) * (line.origin[c] + t * line.direction[c]);
                return sum < 1;
            };
            RootList roots;
            finder.find({&line, 1}, {0, false, {}}, {&roots, 1});
            QCOMPARE(!roots.empty(), isBelowOne(0) != isBelowOne(line.far));
            if (roots.empty()) continue;
            ++jumps;
            QCOMPARE(roots[0].kind, RootKind::jump);
            QVERIFY(isBelowOne(roots[0].t) != isBelowOne(0));
            QVERIFY(isBelowOne(roots[0].t - 1e-6) == isBelowOne(0));
        }
        QVERIFY(jumps > 300);
    }

    void settingsAreThoseThatPovrayWouldUse() {
        RootSettings settings;
        settings.accuracy = -1;
        settings.maxGradient = std::nan("");
        settings.maxTrace = 50;
        settings.evaluate = {0, 0.5, 2};
        const RootSettings used = settings.usable();
        QVERIFY(used.accuracy == RootSettings().accuracy && used.maxGradient == RootSettings().maxGradient);
        QCOMPARE(used.maxTrace, 10);
        QCOMPARE(*used.evaluate, (std::array<double, 3>{RootSettings().maxGradient, 1, 1}));
        settings.maxTrace = -3;
        QCOMPARE(settings.usable().maxTrace, 1);
        settings.maxTrace = 7;
        QCOMPARE(settings.usable().maxTrace, 7);
    }

    /// A bundle of lines of all directions is so wide that the rest of them, a part of its width, was passed
    /// over.
    void linesOfAllDirectionsAreSearchedToTheirEnds() {
        std::mt19937_64 random(seed);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const auto plane = tapeOf([](auto, auto, auto z) { return z * 0.19 - 1.23; });
        CertifiedRootFinder finder(plane, {}, openSettings());
        int crossed = 0;
        for (int round = 0; round < 100; ++round) {
            std::vector<LineQuery> lines;
            for (int i = 0; i < 64; ++i) {
                const glm::dvec3 direction(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
                lines.push_back({{uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)},
                                 glm::normalize(direction),
                                 0,
                                 uniform(1, 5)});
            }
            const test::LineTable table(lines);
            FirstRoots roots;
            finder.findFirst(table.columns(), {0, false, {}}, roots);
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const LineQuery& line = lines[i];
                if (!(line.origin.z + line.far * line.direction.z > 1.23 / 0.19 + 1e-3)) continue;
                ++crossed;
                const bool isOther =
                    std::ranges::any_of(roots.others, [&](const auto& other) { return other.line == i; });
                QVERIFY(isOther || std::isfinite(roots.crossings[FirstRoots::t][i]));
                QCOMPARE(finder.verdicts()[i], Verdict::certifiedHit);
            }
        }
        QVERIFY(crossed > 3);
    }

    void closedContainersHaveWalls() {
        RootSettings settings;
        settings.maxTrace = 10;
        const auto tape = tapeOf([](auto x, auto, auto) { return abs(x) - 10; });
        const LineQuery inside{{-3, 0, 0}, {1, 0, 0}, 1, 5};
        const RootList walls = ask(tape, inside, settings).roots;
        QCOMPARE(walls, (RootList{{1, RootKind::entryWall}, {5, RootKind::exitWall}}));
        settings.open = true;
        QVERIFY(ask(tape, inside, settings).roots.empty());
    }

    void positivePolarityTurnsTheInsideOut() {
        RootSettings settings = openSettings();
        settings.positivePolarity = true;
        CertifiedRootFinder finder(tapeOf(sphere), {}, settings);
        const glm::dvec3 point{1, 0, 0};
        glm::dvec3 normal;
        finder.normals({&point, 1}, {&normal, 1});
        QCOMPARE(normal, glm::dvec3(-1, 0, 0));
        QCOMPARE(ask(tapeOf(sphere), along(), settings).roots.size(), std::size_t(1));
    }

    void aVanishingGradientFallsBackToDifferences() {
        const auto tape = tapeOf([](auto x, auto, auto) { return x * x * x; });
        CertifiedRootFinder finder(tape, {}, openSettings());
        const glm::dvec3 point{0, 0, 0};
        glm::dvec3 normal;
        finder.normals({&point, 1}, {&normal, 1});
        QVERIFY(normal.x > 0 && normal.y == 0 && normal.z == 0);
    }

    void oddInputEndsAtOnce() {
        const auto tape = tapeOf(sphere);
        const double nan = NAN;
        for (const LineQuery& line :
             {LineQuery{{0, 0, 0}, {0, 0, 0}, 0, 1}, LineQuery{{0, 0, 0}, {1, 0, 0}, 2, 1},
              LineQuery{{nan, 0, 0}, {1, 0, 0}, 0, 1}, LineQuery{{0, 0, 0}, {1, 0, 0}, 0, INFINITY},
              LineQuery{{0, 0, 0}, {1, nan, 0}, 0, 1}, LineQuery{{1e300, 0, 0}, {1e300, 0, 0}, 0, 1e10}}) {
            const Answer answer = ask(tape, line, openSettings());
            for (const Root& root : answer.roots) QVERIFY(std::isfinite(root.t));
        }
    }

    void aLinesAnswerDependsOnNothingElse() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> coordinate(-1.3, 1.3);
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            return min(sqrt(sq(x) + sq(y) + sq(z)) - 1, sin(x * 5) * cos(y * 4) + z);
        });
        std::vector<LineQuery> lines;
        for (int k = 0; k < 300; ++k) lines.push_back(along(coordinate(random), coordinate(random)));
        CertifiedRootFinder finder(tape, {}, openSettings(0.001, 10));
        std::vector<RootList> roots(lines.size());
        finder.find(lines, {}, roots);
        const std::vector<Verdict> verdicts(finder.verdicts().begin(), finder.verdicts().end());
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Answer alone = ask(tape, lines[k], openSettings(0.001, 10));
            QCOMPARE(roots[k], alone.roots);
            QCOMPARE(verdicts[k], alone.verdict);
        }
    }

    void missesNoCrossingOfTheGyroid() {
        std::mt19937_64 random(seed + 1);
        std::uniform_real_distribution<double> coordinate(-6, 6);
        const auto tape = tapeOf(
            [](auto x, auto y, auto z) { return sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x); });
        PointEvaluator points(tape, {});
        for (int round = 0; round < 300; ++round) {
            const LineQuery line{{coordinate(random), coordinate(random), coordinate(random)},
                                 {coordinate(random), coordinate(random), coordinate(random)},
                                 0,
                                 1};
            const RootList roots = ask(tape, line, openSettings(0.001, 10), 0).roots;
            // Dense samples up to the root have the sign of the start.
            const double end = roots.empty() ? line.far : roots[0].t;
            const auto value = [&](double t) {
                const glm::dvec3 p = line.origin + t * line.direction;
                return points.evaluate(p.x, p.y, p.z);
            };
            const double sign = value(0);
            for (int k = 1; k < 1000; ++k) QVERIFY(value(end * (k / 1000.0)) * sign > 0);
        }
    }
};

QTEST_APPLESS_MAIN(CertifiedRootFinderTest)
#include "certified_root_finder_test.moc"

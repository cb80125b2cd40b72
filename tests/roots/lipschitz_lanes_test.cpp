// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_lanes.h"

#include <hwy/targets.h>

#include <cmath>
#include <limits>
#include <QTest>
#include <random>

#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "tests/roots/lambda_field.h"

using namespace isoscope;
using isoscope::test::LambdaField;

namespace {

/// With a NaN region, a pole and a jump.
double broken(const glm::dvec3& p) {
    if (p.x > 0.7 && p.y > 0.2) return std::numeric_limits<double>::quiet_NaN();
    if (p.z > 0.8) return 1 / (p.x - 0.1);
    return std::sin(5 * p.x) + std::cos(4 * p.y) * p.z + (p.y < -0.5 ? 0.3 : 0);
}

struct Answer {
    std::vector<RootList> roots;
    double steepest = 0;
    std::uint64_t evaluations = 0;
};

Answer answerFor(const std::vector<LineQuery>& queries, const RootSettings& settings) {
    Answer answer;
    answer.roots.resize(queries.size());
    LipschitzRootFinder finder(std::make_unique<LambdaField>(broken), settings);
    finder.find(queries, {}, answer.roots);
    answer.steepest = finder.report().steepest;
    answer.evaluations = finder.report().evaluations;
    return answer;
}

std::vector<LineQuery> randomQueries(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> place(-1, 1);
    std::vector<LineQuery> queries(count);
    for (LineQuery& query : queries) {
        query.origin = {place(random), place(random), place(random)};
        query.direction = {place(random), place(random), place(random)};
        query.near = std::max(0.0, place(random));
        query.far = query.near + 2 + place(random);
    }
    return queries;
}

}  // namespace

class LipschitzLanesTest : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { hwy::SetSupportedTargetsForTest(0); }

    void theSameOnEveryInstructionSet() {
        const unsigned seed = 411;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::size_t found = 0;
        for (int round = 0; round < 20; ++round) {
            const std::vector<LineQuery> queries = randomQueries(random, 130);
            RootSettings settings;
            settings.maxGradient = 1 + round;
            settings.maxTrace = 1 + round % 10;
            settings.open = round % 2 == 0;
            settings.positivePolarity = round % 3 == 0;
            hwy::SetSupportedTargetsForTest(0);
            const Answer best = answerFor(queries, settings);
            for (const RootList& list : best.roots) found += list.size();
            for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
                hwy::SetSupportedTargetsForTest(targets & -targets);
                const Answer answer = answerFor(queries, settings);
                QCOMPARE(answer.roots, best.roots);
                QCOMPARE(answer.steepest, best.steepest);
                QCOMPARE(answer.evaluations, best.evaluations);
            }
        }
        QVERIFY(found > 2000);
    }

    void evaluationsAreThoseOfLinesAlone() {
        const unsigned seed = 77;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const std::vector<LineQuery> queries = randomQueries(random, 300);
        RootSettings settings;
        settings.maxGradient = 7;
        settings.maxTrace = 3;
        const Answer together = answerFor(queries, settings);
        std::uint64_t alone = 0;
        double steepest = 0;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const Answer one = answerFor({queries[k]}, settings);
            QCOMPARE(one.roots[0], together.roots[k]);
            alone += one.evaluations;
            steepest = std::max(steepest, one.steepest);
        }
        QCOMPARE(together.evaluations, alone);
        QCOMPARE(together.steepest, steepest);
    }

    void slopesBehindACrossingAreNotNoted() {
        // The crossing at 1.25 ends the search; the steep part behind it is not POV-Ray's business.
        const auto f = [](const glm::dvec3& p) { return p.x < 1.5 ? 1.25 - p.x : 100 * (p.x - 1.5) - 0.25; };
        RootSettings settings;
        settings.maxGradient = 200;
        LipschitzRootFinder finder(std::make_unique<LambdaField>(f), settings);
        const std::vector<LineQuery> queries{{{0, 0, 0}, {1, 0, 0}, 1, 3}};
        std::vector<RootList> roots(1);
        finder.find(queries, {}, roots);
        QCOMPARE(roots[0].size(), std::size_t(1));
        // From x = 1 to x = 3 the value rises by 149.5, more steeply than anywhere on the way to the root.
        QVERIFY(std::abs(finder.report().steepest - 149.5 / 2) < 1e-9);
    }
};

QTEST_APPLESS_MAIN(LipschitzLanesTest)
#include "lipschitz_lanes_test.moc"

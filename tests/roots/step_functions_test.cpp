// SPDX-License-Identifier: GPL-3.0-or-later
// Random functions with jumps along random lines: what the certified root finder says of them holds at
// points close together.
#include "core/roots/certified/certified_root_finder.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "tests/roots/line_table.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/random_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(173205);
constexpr double accuracy = 1e-3;
constexpr int functions = 400;
constexpr std::size_t linesEach = 64;
constexpr int samples = 600;

RandomFunctionSettings stepOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    settings.operations = {Operation::floor,    Operation::truncate, Operation::remainder, Operation::minimum,
                           Operation::maximum,  Operation::absolute, Operation::select3,   Operation::add,
                           Operation::subtract, Operation::multiply, Operation::square};
    return settings;
}

RootSettings openSettings() {
    RootSettings settings;
    settings.accuracy = accuracy;
    settings.threshold = 0.123;
    settings.open = true;
    return settings;
}

Expression toInt(Expression a) { return apply(Operation::truncate, a); }
Expression toDiv(Expression a, Expression b) { return apply(Operation::integerDivide, a, b); }

/// The first place of a line where the sign is no longer what it was; infinite where there is none. Where
/// rounding decides, no sign counts.
struct Signs {
    double from = 0, to = INFINITY;  ///< the change is between
    bool changes() const { return std::isfinite(to); }
};

Signs firstChange(PointEvaluator& points, const LineQuery& line) {
    const auto sign = [&](double t) {
        const auto at = [&](double s) {
            const glm::dvec3 p = line.origin + s * line.direction;
            const double value = points.evaluate(p.x, p.y, p.z) - 0.123;
            return value > 1e-9 ? 1 : value < -1e-9 ? -1 : 0;
        };
        const int middle = at(t);
        return at(t - 1e-9) == middle && at(t + 1e-9) == middle ? middle : 0;
    };
    int known = 0;
    double place = 0;
    for (int k = 1; k < samples; ++k) {
        const double t = line.near + (line.far - line.near) * (k + 0.137) / (samples + 1);
        const int now = sign(t);
        if (now == 0) continue;
        if (known == -now) return {place, t};
        known = now;
        place = t;
    }
    return {};
}

}  // namespace

Q_DECLARE_METATYPE(std::shared_ptr<const isoscope::Tape>)

class StepFunctionsTest : public QObject {
    Q_OBJECT

  private slots:
    void certifiedVerdictsHoldBetweenJumps() {
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = stepOperations();
        const RootSettings roots = openSettings();
        int certified = 0, hits = 0, lost = 0;
        for (int k = 0; k < functions; ++k) {
            settings.nodes = 3 + static_cast<int>(random() % 12);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            const auto tape = Tape::compile(function);
            CertifiedRootFinder finder(tape, {}, roots);
            PointEvaluator points(tape, {});
            std::vector<LineQuery> queries;
            for (std::size_t i = 0; i < linesEach; ++i) {
                LineQuery line{{uniform(random, -3, 3), uniform(random, -3, 3), uniform(random, -3, 3)},
                               {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)},
                               0,
                               uniform(random, 1, 5)};
                line.direction = glm::normalize(line.direction);
                queries.push_back(line);
            }
            const LineTable lines(queries);
            FirstRoots found;
            RootRequest request;
            request.sufficient = 0;
            finder.findFirst(lines.columns(), request, found);
            std::vector<double> first(found.crossings[FirstRoots::t],
                                      found.crossings[FirstRoots::t] + queries.size());
            for (const FirstRoots::Other& other : found.others) first[other.line] = other.root.t;
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const Signs signs = firstChange(points, queries[i]);
                const Verdict verdict = finder.verdicts()[i];
                const bool sure = verdict == Verdict::certifiedHit || verdict == Verdict::certifiedMiss;
                certified += sure;
                hits += verdict == Verdict::certifiedHit;
                if (!signs.changes()) continue;
                const bool missed = !(first[i] <= signs.to + accuracy);
                lost += missed;
                QVERIFY2(!(sure && missed),
                         qPrintable(
                             QString::asprintf("function %d, line %zu: sign changes between %.17g and %.17g, "
                                               "root %.17g\n",
                                               k, i, signs.from, signs.to, first[i]) +
                             QString::fromStdString(describe(function))));
            }
        }
        const int all = functions * static_cast<int>(linesEach);
        qInfo("%d lines: %.4f certified, %d hits, %d changes of sign passed", all, double(certified) / all,
              hits, lost);
        QVERIFY(certified > 0.9 * all);
        QVERIFY(hits > all / 20);
    }

    /// Of jumps of which one is known to lie in a stretch and the other one exactly, within it, the first is
    /// not known: the second was taken for it, and the root between both was passed.
    void theFirstOfJumpsThatOverlapIsFound() {
        const auto tape = tapeOf([](auto, auto, auto z) { return toInt(mod(z.number(306.645658), z)); });
        const double start = 2.2598499865677155, slope = 0.9760719114404689;
        const LineQuery line{{0, 0, start}, {0, std::sqrt(1 - slope * slope), slope}, 0, 3.4616655748543401};
        CertifiedRootFinder finder(tape, {}, openSettings());
        RootRequest request;
        request.sufficient = 0;
        const LineTable lines(std::vector<LineQuery>{line});
        FirstRoots found;
        finder.findFirst(lines.columns(), request, found);
        QCOMPARE(found.others.size(), std::size_t(1));
        // From 1 to 0, before it becomes 2.
        const double place = ((306.645658 - 1) / 135 - start) / slope;
        QVERIFY(std::abs(found.others[0].root.t - place) < 1e-9);
        QCOMPARE(finder.verdicts()[0], Verdict::certifiedHit);
    }

    /// Checks and stripes as people write them. Where a step is a whole number, mod, int and div of it were
    /// taken for a jump at that very place, and no line was proven.
    void stepsOfStepsAreProven_data() {
        QTest::addColumn<std::shared_ptr<const Tape>>("tape");
        const auto add = [](const char* name, const auto& formula) {
            QTest::newRow(name) << tapeOf(formula);
        };
        add("mod of floor", [](auto x, auto, auto) { return mod(floor(4 * x), x.number(2)) - 0.5; });
        add("mod of int", [](auto x, auto, auto) { return mod(toInt(4 * x + 9), x.number(3)) - 0.5; });
        add("int of half of int",
            [](auto x, auto, auto) { return toInt(4 * x) / 2 - toInt(toInt(4 * x) / 2) - 0.2; });
        add("div of int", [](auto x, auto, auto) { return toDiv(toInt(4 * x + 9), x.number(2)) - 4.5; });
        add("checks", [](auto x, auto y, auto z) {
            return sq(x) + sq(y) + sq(z) - 0.9 +
                   0.3 * mod(floor(4 * x) + floor(4 * y) + floor(4 * z), x.number(2));
        });
    }
    void stepsOfStepsAreProven() {
        QFETCH(std::shared_ptr<const Tape>, tape);
        std::mt19937_64 random(seed + 1);
        CertifiedRootFinder finder(tape, {}, openSettings());
        std::vector<LineQuery> queries;
        for (int i = 0; i < 500; ++i)
            queries.push_back({{uniform(random, -1, 1), uniform(random, -1, 1), -1.03},
                               glm::normalize(glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), 1)),
                               0,
                               2});
        std::vector<RootList> roots(queries.size());
        finder.find(queries, {}, roots);
        for (const Verdict verdict : finder.verdicts())
            QVERIFY2(verdict <= Verdict::certifiedMiss, name(verdict));
        QVERIFY(finder.report().evaluations < 60 * queries.size());
        PointEvaluator points(tape, {});
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const Signs signs = firstChange(points, queries[i]);
            if (signs.changes()) QVERIFY(!roots[i].empty() && roots[i].front().t <= signs.to + accuracy);
        }
    }
};

QTEST_APPLESS_MAIN(StepFunctionsTest)
#include "step_functions_test.moc"

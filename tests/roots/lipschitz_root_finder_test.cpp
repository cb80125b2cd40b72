// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/lipschitz_root_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <QTest>
#include <random>

#include "tests/roots/lambda_field.h"
#include "tests/roots/line_table.h"
#include "tests/roots/plain_lipschitz.h"

using namespace isoscope;
using isoscope::test::LambdaField;
using isoscope::test::PlainLipschitz;
using isoscope::test::PointFunction;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double sphere(const glm::dvec3& p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; }
double gyroid(const glm::dvec3& p) {
    return std::sin(3 * p.x) * std::cos(3 * p.y) + std::sin(3 * p.y) * std::cos(3 * p.z) +
           std::sin(3 * p.z) * std::cos(3 * p.x);
}
double pole(const glm::dvec3& p) { return 1 / p.x - 2 * p.y; }
double holed(const glm::dvec3& p) { return p.x < 0.3 ? notANumber : sphere(p); }

const RootRequest firstOnly{0, false, {}};

LipschitzRootFinder makeFinder(const PointFunction& f, const RootSettings& settings) {
    return {std::make_unique<LambdaField>(f), settings};
}

/// A line through the box -1.2 to 1.2, from outside or from inside.
LineQuery randomLine(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1.2, 1.2);
    LineQuery query;
    const glm::dvec3 target(place(random), place(random), place(random));
    const bool outside = random() % 3 != 0;
    query.origin = glm::dvec3(place(random), place(random), place(random)) * (outside ? 4.0 : 1.0);
    query.direction = (target - query.origin) * std::exp(place(random));
    double near = 0, far = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-1.2 - query.origin[axis]) / query.direction[axis];
        const double b = (1.2 - query.origin[axis]) / query.direction[axis];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    query.near = near;
    query.far = far;
    return query;
}

RootSettings randomSettings(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    RootSettings settings;
    settings.accuracy = std::pow(10, -1 - 3 * unit(random));
    settings.maxGradient = 0.3 + 5 * unit(random);
    settings.threshold = unit(random) - 0.5;
    settings.open = random() % 2 == 0;
    settings.maxTrace = 1 + static_cast<int>(random() % 10);
    settings.positivePolarity = random() % 4 == 0;
    if (random() % 4 == 0)
        settings.evaluate = {0.5 + unit(random), 1 + unit(random), 0.5 + 0.5 * unit(random)};
    return settings.usable();
}

}  // namespace

class LipschitzRootFinderTest : public QObject {
    Q_OBJECT

  private slots:
    void equalsThePlainRecursionForRandomLinesAndSettings() {
        const unsigned seed = 20240611;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::size_t found = 0;
        const std::array<PointFunction, 4> functions{sphere, gyroid, pole, holed};
        for (int round = 0; round < 200; ++round) {
            const PointFunction& f = functions[random() % functions.size()];
            const RootSettings settings = randomSettings(random);
            std::vector<LineQuery> queries;
            for (int k = 0; k < 150; ++k) queries.push_back(randomLine(random));
            std::vector<RootList> roots(queries.size());
            LipschitzRootFinder finder = makeFinder(f, settings);
            finder.find(queries, {}, roots);
            double bound = settings.maxGradient;
            for (std::size_t k = 0; k < queries.size(); ++k) {
                const RootList plain = PlainLipschitz(f, queries[k], settings, bound).roots();
                QCOMPARE(roots[k], plain);
                found += plain.size();
            }
            if (settings.evaluate) QCOMPARE(finder.report().maxGradient, bound);
        }
        QVERIFY(found > 10000);
    }

    void firstIsTheFirstOfAll() {
        std::mt19937 random(5);
        for (int round = 0; round < 50; ++round) {
            RootSettings settings = randomSettings(random);
            settings.evaluate.reset();
            std::vector<LineQuery> queries;
            for (int k = 0; k < 100; ++k) queries.push_back(randomLine(random));
            std::vector<RootList> all(queries.size()), first(queries.size());
            LipschitzRootFinder finder = makeFinder(gyroid, settings);
            finder.find(queries, {}, all);
            finder.find(queries, firstOnly, first);
            for (std::size_t k = 0; k < queries.size(); ++k) {
                QCOMPARE(first[k].empty(), all[k].empty());
                if (!all[k].empty()) QCOMPARE(first[k].front(), all[k].front());
            }
        }
    }

    void linesShareEvaluations() {
        std::mt19937 random(11);
        std::vector<LineQuery> queries;
        for (int k = 0; k < 640; ++k) queries.push_back(randomLine(random));
        std::vector<RootList> roots(queries.size());
        auto field = std::make_unique<LambdaField>(gyroid);
        const LambdaField& counter = *field;
        LipschitzRootFinder finder(std::move(field), RootSettings{});
        finder.find(queries, {}, roots);
        QCOMPARE(finder.report().evaluations, counter.points);
        QCOMPARE(finder.report().searches, std::uint64_t(640));
        QVERIFY(counter.points > 40 * counter.calls);
    }

    void evaluateGoesOnWithTheBoundOfTheLastCall() {
        RootSettings settings;
        settings.evaluate = {0.5, 1.3, 0.9};
        std::mt19937 random(3);
        std::vector<LineQuery> queries;
        for (int k = 0; k < 100; ++k) queries.push_back(randomLine(random));
        LipschitzRootFinder whole = makeFinder(sphere, settings);
        LipschitzRootFinder piecewise = makeFinder(sphere, settings);
        std::vector<RootList> once(queries.size()), twice(queries.size());
        whole.find(queries, {}, once);
        const std::span<const LineQuery> lines(queries);
        const std::span<RootList> lists(twice);
        piecewise.find(lines.first(37), {}, lists.first(37));
        piecewise.find(lines.subspan(37), {}, lists.subspan(37));
        QCOMPARE(twice, once);
        QCOMPARE(piecewise.report().maxGradient, whole.report().maxGradient);
        QVERIFY(whole.report().maxGradient > 1);
    }

    void hugeAndTinyFunctionsGiveNumbers() {
        std::mt19937 random(17);
        std::vector<LineQuery> queries;
        for (int k = 0; k < 200; ++k) queries.push_back(randomLine(random));
        std::vector<RootList> roots(queries.size());
        for (const double scale : {1e300, 1e-300, 1e308 * 10, notANumber}) {
            const PointFunction f = [&](const glm::dvec3& p) { return sphere(p) * scale; };
            LipschitzRootFinder finder = makeFinder(f, RootSettings{});
            finder.find(queries, {}, roots);
            for (const RootList& list : roots)
                for (const Root& root : list) QVERIFY(std::isfinite(root.t));
            QVERIFY(std::isfinite(finder.report().steepest));
        }
    }

    void budgetIsReported() {
        RootSettings settings;
        settings.accuracy = 1e-12;
        settings.maxGradient = 1e12;
        const PointFunction f = [](const glm::dvec3&) { return 1.0; };
        LipschitzRootFinder finder = makeFinder(f, settings);
        std::vector<LineQuery> queries{{{0, 0, -3}, {0, 0, 1}, 2, 4}};
        std::vector<RootList> roots(1);
        finder.find(queries, {}, roots);
        QVERIFY(roots[0].empty());
        QCOMPARE(finder.report().exhausted, std::uint64_t(1));
    }

    void stopEndsAtOnce() {
        std::stop_source source;
        std::uint64_t count = 0;
        const PointFunction f = [&](const glm::dvec3&) {
            if (++count == 1000) source.request_stop();
            return 1.0;
        };
        RootSettings settings;
        settings.accuracy = 1e-9;
        settings.maxGradient = 1e9;
        LipschitzRootFinder finder = makeFinder(f, settings);
        std::vector<LineQuery> queries(100, LineQuery{{0, 0, -3}, {0, 0, 1}, 2, 4});
        std::vector<RootList> roots(100, RootList(3));
        finder.find(queries, RootRequest{1e9, false, source.get_token()}, roots);
        // The values that were under way, one a lane, and no more.
        QVERIFY2(count <= 1000 + 64, qPrintable(QString::number(count)));
        for (const RootList& list : roots) QVERIFY(list.empty());
    }

    void aRestartedFinderIsAsNew() {
        std::mt19937 random(8);
        std::vector<LineQuery> queries;
        for (int k = 0; k < 100; ++k) queries.push_back(randomLine(random));
        for (const bool evaluate : {false, true}) {
            RootSettings settings;
            settings.maxGradient = 0.8;
            if (evaluate) settings.evaluate = {0.5, 1.3, 0.9};
            LipschitzRootFinder finder = makeFinder(gyroid, settings);
            std::vector<RootList> first(queries.size()), second(queries.size());
            finder.find(queries, {0, true, {}}, first);
            const RootFinderReport seen = finder.report();
            finder.restart();
            QCOMPARE(finder.report().searches, std::uint64_t(0));
            QCOMPARE(finder.report().evaluations, std::uint64_t(0));
            finder.find(queries, {0, true, {}}, second);
            QCOMPARE(second, first);
            QCOMPARE(finder.report().maxGradient, seen.maxGradient);
            QCOMPARE(finder.report().steepest, seen.steepest);
            QCOMPARE(finder.report().evaluations, seen.evaluations);
        }
    }

    void firstRootsAreThoseOfTheLists() {
        std::mt19937 random(9);
        std::vector<LineQuery> queries;
        for (int k = 0; k < 100; ++k) queries.push_back(randomLine(random));
        const test::LineTable table(queries);
        RootSettings settings;
        settings.maxGradient = 8;
        const RootRequest request{0.5, true, {}};
        std::vector<RootList> lists(queries.size());
        makeFinder(gyroid, settings).find(queries, request, lists);
        LipschitzRootFinder finder = makeFinder(gyroid, settings);
        FirstRoots roots;
        finder.findFirst(table.columns(), request, roots);
        QVERIFY(finder.verdicts().empty());
        QCOMPARE(std::count(roots.crossings[FirstRoots::t], roots.crossings[FirstRoots::t] + queries.size(),
                            FirstRoots::none),
                 std::ptrdiff_t(queries.size()));
        std::size_t next = 0, walls = 0;
        for (std::size_t line = 0; line < queries.size(); ++line) {
            const auto first = std::find_if(lists[line].begin(), lists[line].end(),
                                            [&](const Root& root) { return root.t >= request.sufficient; });
            if (first == lists[line].end()) continue;
            QVERIFY(next < roots.others.size());
            const FirstRoots::Other& other = roots.others[next++];
            QCOMPARE(other.line, line);
            QCOMPARE(other.root, *first);
            glm::dvec3 normal = FirstRoots::Other().normal;
            const glm::dvec3 place = queries[line].origin + first->t * queries[line].direction;
            const bool isWall = first->kind == RootKind::entryWall || first->kind == RootKind::exitWall;
            if (!isWall) finder.normals({&place, 1}, {&normal, 1});
            walls += isWall;
            QCOMPARE(other.normal, normal);
        }
        QCOMPARE(next, roots.others.size());
        QVERIFY(walls > 0 && walls < next);
        std::stop_source stop;
        stop.request_stop();
        finder.findFirst(table.columns(), {0, false, stop.get_token()}, roots);
        QVERIFY(roots.others.empty());
    }

    void normalsAreForwardDifferences() {
        RootSettings settings;
        settings.accuracy = 0.25;
        std::vector<glm::dvec3> points(70, {1, -2, 0.5}), normals(70);
        makeFinder(sphere, settings).normals(points, normals);
        for (const glm::dvec3& normal : normals) {
            // (a + h)^2 - a^2 = 2 a h + h^2
            QCOMPARE(normal.x, 2 * 0.25 + 0.0625);
            QCOMPARE(normal.y, -4 * 0.25 + 0.0625);
            QCOMPARE(normal.z, 1 * 0.25 + 0.0625);
        }
        settings.positivePolarity = true;
        makeFinder(sphere, settings).normals(points, normals);
        QCOMPARE(normals[69].x, -(2 * 0.25 + 0.0625));
    }
};

QTEST_APPLESS_MAIN(LipschitzRootFinderTest)
#include "lipschitz_root_finder_test.moc"

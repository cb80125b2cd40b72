// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/isosurface.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <QTest>
#include <random>

#include "core/evaluate/prepared_function.h"
#include "core/function/graph_builder.h"
#include "core/shapes/combined/placed_shape.h"

using namespace isoscope;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class Formula>
Function functionOf(Formula formula) {
    FunctionGraph graph;
    const NodeId x = graph.variable(0), y = graph.variable(1), z = graph.variable(2);
    const Expression result = formula(Expression(graph, x), Expression(graph, y), Expression(graph, z));
    return finish(std::move(graph), {result.node()}, 3);
}

const auto unitSphere = [](Expression x, Expression y, Expression z) { return sq(x) + sq(y) + sq(z) - 1; };
const auto waves = [](Expression x, Expression y, Expression z) {
    return cos(x * 4) + cos(y * 4) + cos(z * 4);
};

template <class Formula>
IsosurfaceSettings settingsOf(Formula formula, double maxGradient = 8) {
    IsosurfaceSettings settings;
    settings.function = functionOf(formula);
    settings.container = ContainerBox{{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}};
    settings.maxGradient = maxGradient;
    return settings;
}

std::vector<Ray> randomRays(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
    std::vector<Ray> rays;
    for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec3 origin = 2.0 * point();
        rays.push_back({origin, 0.8 * point() - origin});
    }
    return rays;
}

/// Rays that begin where others meet the shape, in all directions.
std::vector<Ray> raysFrom(const Shape& shape, unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 1);
    std::vector<Ray> rays;
    TraceContext context(nullptr, RootFinder::certified);
    for (const Ray& ray : randomRays(seed, count)) {
        NearestHit met;
        shape.nearest({&ray, 1}, context, {&met, 1});
        if (met.found) rays.push_back({met.hit.point, {place(random), place(random), place(random)}});
    }
    return rays;
}

HitList hitsOf(const Shape& shape, const Ray& ray) {
    TraceContext context;
    HitList hits;
    shape.intersect(ray, {}, context, hits);
    return hits;
}

}  // namespace

class IsosurfaceTest : public QObject {
    Q_OBJECT

  private slots:
    void nearestIsTheFirstOfIntersect() {
        for (const bool open : {false, true}) {
            IsosurfaceSettings settings = settingsOf(waves);
            settings.open = open;
            settings.maxTrace = 10;
            const Isosurface surface(settings);
            const std::vector<Ray> rays = randomRays(1, 500);
            TraceContext context;
            std::vector<NearestHit> nearest(rays.size());
            surface.nearest(rays, context, nearest);
            std::vector<HitList> all(rays.size());
            surface.allHits(rays, context, all);
            std::size_t found = 0;
            for (std::size_t k = 0; k < rays.size(); ++k) {
                const HitList hits = hitsOf(surface, rays[k]);
                QCOMPARE(nearest[k].found, !hits.empty());
                QCOMPARE(all[k].size(), hits.size());
                if (hits.empty()) continue;
                ++found;
                QCOMPARE(nearest[k].hit.t, hits[0].t);
                QCOMPARE(nearest[k].hit.normal, hits[0].normal);
                QCOMPARE(nearest[k].hit.kind, hits[0].kind);
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    QCOMPARE(all[k][i].t, hits[i].t);
                    QVERIFY(i == 0 || hits[i - 1].t <= hits[i].t);
                    QVERIFY(glm::distance(hits[i].point, rays[k].at(hits[i].t)) < 1e-15);
                    QVERIFY(!open || hits[i].kind == HitKind::crossing);
                }
            }
            QVERIFY(found > 100);
        }
    }

    /// They are searched from the far end first, the lists from the near end on.
    void secondaryRaysMeetWhatListsTell() {
        for (const bool open : {false, true}) {
            IsosurfaceSettings settings = settingsOf(waves);
            settings.open = open;
            settings.maxTrace = 20;
            const Isosurface surface(settings);
            std::vector<Ray> rays = raysFrom(surface, 7, 2000);
            const std::vector<Ray> others = randomRays(8, 300);
            rays.insert(rays.end(), others.begin(), others.end());
            TraceContext context(nullptr, RootFinder::certified);
            std::vector<HitList> all(rays.size());
            surface.allHits(rays, context, all);
            context.nearLimit = 1e-3;
            std::vector<NearestHit> nearest(rays.size()), between(rays.size());
            for (std::size_t k = 0; k < rays.size(); ++k) between[k] = {true, {0.7, {}, {}, 3, {}}};
            surface.nearest(rays, context, nearest);
            context.shadowRay = true;
            surface.nearest(rays, context, between);
            std::size_t found = 0, dark = 0;
            for (std::size_t k = 0; k < rays.size(); ++k) {
                const auto first =
                    std::find_if(all[k].begin(), all[k].end(), [](const Hit& hit) { return hit.t >= 1e-3; });
                // A root this close to where counting begins or ends may fall on either side.
                if (std::any_of(all[k].begin(), all[k].end(), [](const Hit& hit) {
                        return std::abs(hit.t - 1e-3) < 1e-6 || std::abs(hit.t - 0.7) < 1e-6;
                    }))
                    continue;
                QCOMPARE(nearest[k].found, first != all[k].end());
                const bool blocked = first != all[k].end() && first->t < 0.7;
                QCOMPARE(between[k].hit.t < 0.7, blocked);
                dark += blocked;
                if (!nearest[k].found) continue;
                ++found;
                QVERIFY(std::abs(nearest[k].hit.t - first->t) < 1e-6);
                QCOMPARE(nearest[k].hit.kind, first->kind);
                QVERIFY(glm::distance(nearest[k].hit.normal, first->normal) < 1e-3);
            }
            QVERIFY(found > 300 && dark > 100 && found < rays.size() - 300);
        }
    }

    void wallsHaveTheNormalOfTheContainer() {
        IsosurfaceSettings settings =
            settingsOf([](Expression x, Expression, Expression) { return x - 5; }, 1);
        const HitList entry = hitsOf(Isosurface(settings), {{0.3, -3, 0.2}, {0, 1, 0}});
        QCOMPARE(entry.size(), std::size_t(1));
        QCOMPARE(entry[0].kind, HitKind::container);
        QCOMPARE(entry[0].t, 1.8);
        QCOMPARE(entry[0].normal, glm::dvec3(0, -1, 0));
        const HitList exit = hitsOf(Isosurface(settings), {{0.3, 0, 0.2}, {0, 0, -1}});
        QCOMPARE(exit[0].normal, glm::dvec3(0, 0, -1));
        settings.container = ContainerSphere{{0, 1, 0}, -2};
        const HitList ball = hitsOf(Isosurface(settings), {{0, -5, 0}, {0, 2, 0}});
        QCOMPARE(ball[0].t, 2.0);
        QCOMPARE(ball[0].normal, glm::dvec3(0, -1, 0));
    }

    void normalPointsOutOfTheSolid() {
        IsosurfaceSettings settings = settingsOf(unitSphere, 4.2);
        settings.accuracy = 1e-6;
        const Hit hit = hitsOf(Isosurface(settings), {{0.3, 0.4, -3}, {0, 0, 1}}).at(0);
        QVERIFY(glm::distance(hit.normal, hit.point) < 1e-5);
        settings.positivePolarity = true;
        const HitList hits = hitsOf(Isosurface(settings), {{0, 0, 0}, {0, 0, 1}});
        QCOMPARE(hits[0].kind, HitKind::crossing);
        QVERIFY(glm::distance(hits[0].normal, -hits[0].point) < 1e-5);
    }

    void insideIsContainerAndSign() {
        IsosurfaceSettings settings = settingsOf(unitSphere);
        settings.container = ContainerBox{{1.2, 1.2, 1.2}, {0, -1.2, -1.2}};
        settings.open = true;
        const Isosurface surface(settings);
        TraceContext context;
        QVERIFY(surface.contains({0.5, 0, 0}, context));
        QVERIFY(!surface.contains({1.1, 0, 0}, context));
        QVERIFY(!surface.contains({-0.5, 0, 0}, context));
        QVERIFY(surface.contains({0, 0, 0}, context));
        QVERIFY(surface.contains({1, 0, 0}, context));
        QVERIFY(!surface.contains({notANumber, 0, 0}, context));
        QCOMPARE(surface.bounds().low, glm::dvec3(0, -1.2, -1.2));
    }

    void insideIsTrueWhereTheFunctionIsNoNumber() {
        const Isosurface surface(settingsOf([](Expression x, Expression, Expression) { return sqrt(x); }));
        TraceContext context;
        QVERIFY(surface.contains({-0.5, 0, 0}, context));
        QVERIFY(!surface.contains({0.5, 0, 0}, context));
    }

    void parametersComeFromTheContext() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0), radius = graph.parameter(0);
        const NodeId result = graph.binary(Operation::subtract, x, radius);
        IsosurfaceSettings settings = settingsOf(unitSphere, 1);
        settings.function = finish(std::move(graph), {result}, 3);
        const Isosurface surface(settings);
        for (const double value : {-0.5, 0.25}) {
            TraceContext context(std::make_shared<std::vector<double>>(1, value), RootFinder::lipschitz);
            HitList hits;
            surface.intersect({{3, 0, 0}, {-1, 0, 0}}, {}, context, hits);
            QVERIFY(std::abs(hits.at(0).point.x - value) < 0.001);
        }
    }

    void workIsCounted() {
        const Isosurface surface(settingsOf(unitSphere, 4.2));
        TraceContext context;
        QVERIFY(!surface.gradientReport(context));
        const std::vector<Ray> rays{{{0, 0, -3}, {0, 0, 1}}, {{0, 5, -3}, {0, 0, 1}}};
        std::vector<NearestHit> nearest(2);
        surface.nearest(rays, context, nearest);
        QCOMPARE(context.rays, std::uint64_t(2));
        QVERIFY(context.evaluations > 10);
        const std::optional<RootFinderReport> report = surface.gradientReport(context);
        QVERIFY(report);
        QCOMPARE(report->searches, std::uint64_t(1));
        QCOMPARE(report->maxGradient, 4.2);
        QVERIFY(report->steepest > 1.9 && report->steepest < 2.4);
        QCOMPARE(report->exhausted, std::uint64_t(0));
    }

    void shadowRaysSaveTheNormals() {
        const Isosurface surface(settingsOf(unitSphere, 4.2));
        const std::vector<Ray> rays{{{0, 0, -3}, {0, 0, 1}}};
        std::vector<NearestHit> seen(1), shadow(1);
        TraceContext context, dark;
        dark.shadowRay = true;
        surface.nearest(rays, context, seen);
        surface.nearest(rays, dark, shadow);
        QVERIFY(shadow[0].found);
        QCOMPARE(shadow[0].hit.t, seen[0].hit.t);
        QCOMPARE(dark.evaluations + 4, context.evaluations);
    }

    void nearLimitSkipsEarlierHits() {
        IsosurfaceSettings settings = settingsOf(unitSphere, 4.2);
        const std::vector<Ray> rays{{{0, 0, -3}, {0, 0, 1}}};
        TraceContext context;
        context.nearLimit = 2.5;
        std::vector<NearestHit> nearest(1);
        const Isosurface once(settings);
        once.nearest(rays, context, nearest);
        QVERIFY(!nearest[0].found);
        settings.maxTrace = 2;
        const Isosurface twice(settings);
        twice.nearest(rays, context, nearest);
        QVERIFY(std::abs(nearest[0].hit.t - 4) < 0.001);
    }

    void knownHitsAreReplacedByNearerOnesOnly() {
        const Isosurface surface(settingsOf(unitSphere, 4.2));
        const std::vector<Ray> rays(3, {{0, 0, -3}, {0, 0, 1}});
        std::vector<NearestHit> nearest(3);
        nearest[0] = {true, {1, {}, {}, 7, HitKind::crossing}};
        nearest[1] = {true, {1.9, {}, {}, 7, HitKind::crossing}};
        nearest[2] = {true, {2.5, {}, {}, 7, HitKind::crossing}};
        TraceContext context;
        surface.nearest(rays, context, nearest);
        QCOMPARE(nearest[0].hit.t, 1.0);
        QCOMPARE(nearest[1].hit.t, 1.9);
        QVERIFY(std::abs(nearest[2].hit.t - 2) < 0.001);
        QCOMPARE(surface.gradientReport(context)->searches, std::uint64_t(2));
    }

    void accuracyIsMeasuredAlongTheOuterRay() {
        // Measured on POV-Ray: scaled by 10, the search stops at the same t, not at the same object
        // coordinate.
        IsosurfaceSettings settings = settingsOf([](Expression x, Expression, Expression) { return x; }, 1);
        settings.container = ContainerBox{};
        settings.accuracy = 0.4;
        settings.open = true;
        const auto surface = std::make_shared<Isosurface>(settings);
        QCOMPARE(hitsOf(*surface, {{3.03, 0, 0}, {-1, 0, 0}}).at(0).point.x, -0.25);
        const PlacedShape large(surface, Transform::scaling({10, 10, 10}));
        QVERIFY(std::abs(hitsOf(large, {{30.3, 0, 0}, {-1, 0, 0}}).at(0).point.x + 0.3125) < 1e-12);
    }

    void noInputGivesNumbersThatAreNone() {
        std::mt19937 random(8);
        const auto fraction = [](Expression x, Expression y, Expression z) {
            return sqrt(x) / y + exp(z * 900);
        };
        const std::array<IsosurfaceSettings, 3> surfaces{settingsOf(fraction), settingsOf(waves),
                                                         settingsOf(unitSphere)};
        std::vector<Ray> rays = randomRays(4, 200);
        for (std::size_t k = 0; k < rays.size(); k += 5)
            rays[k].direction[int(k % 3)] = k % 2 == 0 ? notANumber : std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k < rays.size(); k += 7) rays[k].origin *= 1e300;
        for (IsosurfaceSettings settings : surfaces)
            for (const double threshold :
                 {0.0, notANumber, 1e308, -std::numeric_limits<double>::infinity()}) {
                settings.threshold = threshold;
                settings.maxTrace = 10;
                settings.open = random() % 2 == 0;
                const Isosurface surface(settings);
                for (const Ray& ray : rays)
                    for (const Hit& hit : hitsOf(surface, ray)) {
                        QVERIFY(std::isfinite(hit.t));
                        QVERIFY(std::abs(glm::length(hit.normal) - 1) < 1e-12);
                    }
            }
    }

    /// What root finders share is made for the first picture, and for others only where the function changes.
    void picturesWithTheSameValuesShareTheFunction() {
        FunctionGraph graph;
        const NodeId x = graph.variable(0), radius = graph.parameter(1);
        IsosurfaceSettings settings = settingsOf(unitSphere);
        const NodeId root = (Expression(graph, x) - Expression(graph, radius)).node();
        settings.function = finish(std::move(graph), {root}, 3);
        const Isosurface surface(settings);
        const auto prepared = surface.prepared(std::array{5.0, 0.5});
        QVERIFY(prepared->keptGlobal() == nullptr);
        const auto wall = [&](double other, double value) {
            TraceContext context(std::make_shared<std::vector<double>>(std::vector{other, value}),
                                 RootFinder::certified);
            HitList hits;
            surface.intersect({{-3, 0, 0}, {1, 0, 0}}, {}, context, hits);
            return hits.empty() ? notANumber : hits.back().point.x;
        };
        QVERIFY(std::abs(wall(5, 0.5) - 0.5) < 1e-6);
        const GlobalSimplification* const made = prepared->keptGlobal();
        QVERIFY(made != nullptr);
        QVERIFY(std::abs(wall(5, 0.5) - 0.5) < 1e-6);
        QVERIFY(std::abs(wall(6, 0.5) - 0.5) < 1e-6);
        QCOMPARE(surface.prepared(std::array{7.0, 0.5}), prepared);
        QCOMPARE(prepared->keptGlobal(), made);
        QVERIFY(std::abs(wall(6, 0.25) - 0.25) < 1e-6);
        QVERIFY(surface.prepared(std::array{6.0, 0.25}) != prepared);
    }

    void stopRequestEndsASearch() {
        IsosurfaceSettings settings = settingsOf(unitSphere, 1e12);
        settings.accuracy = 1e-12;
        const Isosurface surface(settings);
        const std::vector<Ray> rays = randomRays(2, 100);
        std::stop_source source;
        source.request_stop();
        TraceContext context;
        context.stop = source.get_token();
        std::vector<NearestHit> nearest(rays.size());
        surface.nearest(rays, context, nearest);
        QCOMPARE(context.evaluations, std::uint64_t(0));
        for (const NearestHit& hit : nearest) QVERIFY(!hit.found);
    }
};

QTEST_APPLESS_MAIN(IsosurfaceTest)
#include "isosurface_test.moc"

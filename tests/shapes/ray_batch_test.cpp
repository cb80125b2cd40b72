// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/ray_batch.h"

#include <QTest>
#include <glm/geometric.hpp>
#include <random>

#include "core/function/graph_builder.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/isosurface/isosurface.h"
#include "core/shapes/rays/hit_batch.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(4711);

ShapePointer isosurface() {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const NodeId root = Expression(sq(x) + sq(y) + sq(z) - 0.8).node();
    IsosurfaceSettings settings;
    settings.function = finish(std::move(graph), {root}, 3);
    settings.maxGradient = 4;
    return std::make_shared<Isosurface>(settings);
}

std::vector<ShapePointer> shapes() {
    const Transform moved = Transform::rotation({10, 20, 30})
                                .then(Transform::scaling({1, 2, 0.5}))
                                .then(Transform::translation({0.1, 0, 0}));
    const auto ball = std::make_shared<Sphere>(glm::dvec3(0.2, 0, 0), 0.7);
    return {ball, isosurface(), std::make_shared<PlacedShape>(isosurface(), moved, 3),
            std::make_shared<PlacedShape>(isosurface(), Transform(), 5),
            std::make_shared<Csg>(CsgOperation::intersection, std::vector<ShapePointer>{ball, isosurface()})};
}

/// Those that are met in vectors, and one of them moved.
std::vector<ShapePointer> solids() {
    const Transform moved = Transform::rotation({40, -20, 70})
                                .then(Transform::scaling({0.5, -2, 1}))
                                .then(Transform::translation({0.1, -0.2, 0.3}));
    const glm::dvec3 base(0, -1, 0), cap(0, 1, 0), aside(0.5, 0.7, -0.4);
    const auto tip = std::make_shared<Cone>(base, 0.8, aside, 0, false);
    return {std::make_shared<Sphere>(glm::dvec3(0.2, 0, 0), 0.7),
            std::make_shared<Plane>(glm::dvec3(1, 2, 3), 0.25),
            std::make_shared<Plane>(glm::dvec3(0, 1, 0), -1),
            std::make_shared<Box>(glm::dvec3(-1), glm::dvec3(1, 0.5, 2)),
            std::make_shared<Box>(glm::dvec3(-1, 0, -1), glm::dvec3(1, 0, 1)),
            std::make_shared<Box>(glm::dvec3(std::nan("")), glm::dvec3(1)),
            std::make_shared<Cone>(base, 1, cap, 1, false),
            std::make_shared<Cone>(base, 1, cap, 1, true),
            std::make_shared<Cone>(base, 0.3, aside, 0.9, false),
            std::make_shared<Cone>(base, 1, base, 1, false),
            tip,
            std::make_shared<PlacedShape>(tip, moved, 4)};
}

std::vector<ShapePointer> joined() {
    const Transform moved = Transform::rotation({10, 50, -20})
                                .then(Transform::scaling({0.9, 0.6, 1.2}))
                                .then(Transform::translation({0.2, 0.1, 0}));
    const auto box = std::make_shared<Box>(glm::dvec3(-1), glm::dvec3(1, 0.5, 1));
    const auto ball = std::make_shared<Sphere>(glm::dvec3(0.2, 0, 0), 0.9);
    const auto pole = std::make_shared<Cone>(glm::dvec3(0, -1, 0), 0.4, glm::dvec3(0, 0.5, 0), 0.4, false);
    const auto hat = std::make_shared<Cone>(glm::dvec3(0, -0.5, 0), 0.8, glm::dvec3(0.2, 1, 0), 0, false);
    const auto plane = std::make_shared<Plane>(glm::dvec3(1, 1, 0), 0.3);
    const auto join = [](CsgOperation operation, std::vector<ShapePointer> parts) {
        return std::make_shared<Csg>(operation, std::move(parts));
    };
    const auto placed = [&](ShapePointer shape, MaterialId material) {
        return std::make_shared<PlacedShape>(std::move(shape), moved, material);
    };
    constexpr auto intersection = CsgOperation::intersection, difference = CsgOperation::difference;
    const auto drilled = join(difference, {box, pole, placed(ball, 3)});
    return {join(intersection, {box, ball}),
            join(intersection, {box, placed(hat, 2), plane}),
            join(difference, {ball, box}),
            drilled,
            placed(join(intersection, {join(difference, {placed(box, 6), plane}), ball}), 5),
            join(intersection, {drilled, hat}),
            join(CsgOperation::union_, {drilled, placed(hat, 1), ball}),
            join(CsgOperation::union_, {placed(join(CsgOperation::union_, {pole, plane}), 8), box})};
}

/// Wherever they are met rounding decides, and POV-Ray's rules.
std::vector<ShapePointer> joinedAlongBorders() {
    const auto box = std::make_shared<Box>(glm::dvec3(-1), glm::dvec3(1, 0.5, 1));
    const auto half = std::make_shared<Box>(glm::dvec3(-1), glm::dvec3(0, 0.5, 1));
    const auto ball = std::make_shared<InverseShape>(std::make_shared<Sphere>(glm::dvec3(0), 0.9));
    const auto join = [](CsgOperation operation, std::vector<ShapePointer> parts) {
        return std::make_shared<Csg>(operation, std::move(parts));
    };
    return {join(CsgOperation::intersection, {ball, box, box}), join(CsgOperation::difference, {box, half}),
            join(CsgOperation::intersection, {box, half})};
}

/// All towards the middle, so that most of them meet something.
std::vector<Ray> raysInwards(std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    const auto point = [&] { return glm::dvec3(anywhere(random), anywhere(random), anywhere(random)); };
    std::vector<Ray> rays(20011);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::dvec3 from = (i % 4 == 0 ? 1.0 : 4.0) * point(), to = point();
        rays[i] = {from, (0.2 + anywhere(random) * anywhere(random)) * (to - from)};
        // Along axes and through corners.
        if (i % 7 == 0) rays[i] = {glm::round(2.0 * from) / 2.0, glm::round(2.0 * (to - from))};
    }
    return rays;
}

/// What both ways answer, to the bit; how many rays have met something.
int compareWays(const Shape& shape, int number, std::span<const Ray> rays) {
    RayBatch batch;
    batch.assign(rays);
    TraceContext context;
    context.nearLimit = number % 2 == 0 ? 0 : 0.3;
    std::vector<NearestHit> list(rays.size());
    HitBatch hits;
    hits.reset(rays.size());
    for (std::size_t i = 0; i < rays.size(); i += 3) {
        hits.set(i, 0.9, {0, 1, 0}, HitKind::jump, 9);
        list[i] = {true, {0.9, rays[i].at(0.9), {0, 1, 0}, 9, HitKind::jump}};
    }
    shape.nearest(rays, context, list);
    shape.nearestInBatch(batch, context, hits);
    int met = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit& expected = list[i].hit;
        const bool same =
            hits.found(i) == list[i].found &&
            (!list[i].found || (hits[HitBatch::t][i] == expected.t && hits.normal(i) == expected.normal &&
                                hits.kind(i) == expected.kind && hits.material(i) == expected.material));
        if (!same)
            qWarning("seed %llu, shape %d, ray %zu: t %.17g instead of %.17g",
                     static_cast<unsigned long long>(seed), number, i, hits[HitBatch::t][i],
                     list[i].found ? expected.t : -1);
        if (!same) return -1;
        met += list[i].found;
    }
    return met;
}

/// Some on the surfaces and along them, some backwards, some hardly rays.
std::vector<Ray> oddRays(std::mt19937& random) {
    const double some[] = {0, -0.0, 1, -1, 0.5, 2, 1e-30, 1e30, 1e7, 1e200, std::nan(""), INFINITY};
    std::uniform_real_distribution<double> anywhere(-2, 2);
    const auto number = [&] {
        const std::size_t kind = random() % 64;
        if (kind < std::size(some)) return some[kind];
        return kind < 24 ? some[kind % 6] : anywhere(random);
    };
    std::vector<Ray> rays(5003);
    for (Ray& ray : rays) ray = {{number(), number(), number()}, {number(), number(), number()}};
    return rays;
}

std::vector<Ray> someRays() {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::vector<Ray> rays;
    for (int k = 0; k < 300; ++k)
        rays.push_back(
            {{anywhere(random), anywhere(random), -4}, {0.2 * anywhere(random), 0.2 * anywhere(random), 1}});
    return rays;
}

}  // namespace

class RayBatchTest : public QObject {
    Q_OBJECT

  private slots:
    void batchesAreAnsweredLikeListsOfRays_data() {
        QTest::addColumn<int>("finder");
        QTest::newRow("certified") << static_cast<int>(RootFinder::certified);
        QTest::newRow("lipschitz") << static_cast<int>(RootFinder::lipschitz);
    }
    void batchesAreAnsweredLikeListsOfRays() {
        QFETCH(int, finder);
        const std::vector<Ray> rays = someRays();
        RayBatch batch;
        batch.assign(rays);
        int met = 0;
        for (const ShapePointer& shape : shapes()) {
            TraceContext context(nullptr, static_cast<RootFinder>(finder)),
                other = TraceContext(nullptr, context.rootFinder);
            std::vector<NearestHit> list(rays.size());
            HitBatch hits;
            hits.reset(rays.size());
            // Something is known of a third of the rays.
            for (std::size_t i = 0; i < rays.size(); i += 3) {
                hits.set(i, 3.5, {0, 1, 0}, HitKind::jump, 9);
                list[i] = {true, {3.5, rays[i].at(3.5), {0, 1, 0}, 9, HitKind::jump}};
            }
            shape->nearest(rays, context, list);
            shape->nearestInBatch(batch, other, hits);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                QCOMPARE(hits.found(i), list[i].found);
                if (!list[i].found) continue;
                ++met;
                QCOMPARE(hits[HitBatch::t][i], list[i].hit.t);
                QCOMPARE(hits.kind(i), list[i].hit.kind);
                QCOMPARE(hits.material(i), list[i].hit.material);
                QVERIFY(glm::length(hits.normal(i) - list[i].hit.normal) < 1e-14);
            }
        }
        QVERIFY2(met > 500, qPrintable(QString("seed %1: %2").arg(seed).arg(met)));
    }

    /// To the bit, by every set of vector instructions.
    void vectorsAnswerLikeLists_data() {
        QTest::addColumn<qint64>("target");
        for (const auto& [target, name] : test::instructionSets()) QTest::newRow(name) << qint64(target);
    }
    void vectorsAnswerLikeLists() {
        QFETCH(qint64, target);
        const test::ForcedInstructionSet forced(target);
        std::mt19937 random(seed);
        const std::vector<Ray> odd = oddRays(random), inwards = raysInwards(random);
        int number = 0, met = 0;
        for (const std::vector<ShapePointer>& shapes : {solids(), joined(), joinedAlongBorders()})
            for (const ShapePointer& shape : shapes)
                for (const std::vector<Ray>& rays : {odd, inwards}) {
                    const int found = compareWays(*shape, number++ / 2, rays);
                    QVERIFY(found >= 0);
                    met += found;
                }
        QVERIFY2(met > 20000, qPrintable(QString::number(met)));
    }

    /// What rounding would decide is asked about one by one, and that is little.
    void fewRaysAreDoubtful() {
        std::mt19937 random(seed);
        std::vector<Ray> rays = raysInwards(random);
        RayBatch batch;
        batch.assign(rays);
        for (const ShapePointer& shape : joined()) {
            const auto* csg = dynamic_cast<const Csg*>(shape.get());
            if (csg == nullptr || csg->operation() == CsgOperation::union_) continue;
            const auto convex = ConvexIntersection::of(csg->parts());
            QVERIFY(convex.has_value());
            TraceContext context;
            HitBatch hits;
            hits.reset(rays.size());
            std::vector<std::uint32_t> doubtful;
            convex->nearest(batch, context, hits, doubtful);
            // One ray in seven is meant to be.
            QVERIFY2(doubtful.size() < rays.size() / 5, qPrintable(QString::number(doubtful.size())));
        }
    }
};

QTEST_APPLESS_MAIN(RayBatchTest)
#include "ray_batch_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/ray_batch.h"

#include <QTest>
#include <glm/geometric.hpp>
#include <random>

#include "core/function/graph_builder.h"
#include "core/shapes/csg.h"
#include "core/shapes/hit_batch.h"
#include "core/shapes/isosurface.h"
#include "core/shapes/placed_shape.h"
#include "core/shapes/sphere.h"

using namespace isoscope;

namespace {

constexpr unsigned seed = 4711;

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
};

QTEST_APPLESS_MAIN(RayBatchTest)
#include "ray_batch_test.moc"

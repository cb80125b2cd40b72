// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <QTest>

#include "core/shapes/patches/surface_grid.h"
#include "core/shapes/solids/blob.h"

using namespace isoscope;

namespace {

SurfaceGrid sphere(int columns, int rows) {
    SurfaceGrid grid;
    grid.columns = columns;
    grid.rows = rows;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = 2 * std::numbers::pi * column / columns, v = std::numbers::pi * row / rows;
            grid.points.emplace_back(std::sin(v) * std::cos(u), std::cos(v), std::sin(v) * std::sin(u));
        }
    return grid;
}

}  // namespace

class SurfaceGridTest : public QObject {
    Q_OBJECT

  private slots:
    /// Neither the seam nor the poles show: every normal is that of the sphere.
    void seamsAndPolesAreSmooth() {
        SurfaceGrid grid = sphere(40, 20);
        grid.smoothen();
        QCOMPARE(grid.normals.size(), grid.points.size());
        for (std::size_t i = 0; i < grid.points.size(); ++i)
            QVERIFY(std::abs(glm::dot(glm::normalize(grid.normals[i]), glm::normalize(grid.points[i]))) >
                    0.999);
    }

    void closedMeshKnowsItsInside() {
        const auto mesh = sphere(40, 20).mesh(glm::dvec3(0.31, 0.83, 0.46));
        QVERIFY(mesh);
        TraceContext context;
        QVERIFY(mesh->contains({0.1, 0.2, -0.3}, context));
        QVERIFY(!mesh->contains({0.9, 0.9, 0}, context));
        // Triangles without area at the poles are left out: two rows of 40 have one each, not two.
        QCOMPARE(mesh->faceCount(), std::size_t(2 * 40 * 20 - 2 * 40));
    }

    void placesThatAreNotFiniteAreLeftOut() {
        SurfaceGrid grid = sphere(4, 4);
        for (glm::dvec3& point : grid.points) point.x = NAN;
        grid.smoothen();
        QVERIFY(!grid.mesh());
        grid = sphere(8, 4);
        grid.points[grid.number(3, 2)] = glm::dvec3(INFINITY);
        grid.smoothen();
        QVERIFY(grid.mesh());
        QCOMPARE(grid.mesh()->faceCount(), sphere(8, 4).mesh()->faceCount() - 6);
    }

    /// A plane's field depends on the distance alone: strength (1 - (d / radius)^2)^2.
    void blobWithPlane() {
        BlobComponent plane;
        plane.plane = true;
        plane.from = plane.to = {0, 1, 0};
        plane.distance = 2;
        plane.radius = 1;
        plane.strength = 1;
        const Blob blob({plane}, 0.25);
        // (1 - d^2)^2 = 1/4 where d^2 = 1/2.
        const double reach = std::sqrt(0.5);
        TraceContext context;
        QVERIFY(blob.contains({1e3, 2 + 0.99 * reach, -1e3}, context));
        QVERIFY(!blob.contains({0, 2 + 1.01 * reach, 0}, context));
        HitList hits;
        blob.intersect({{5, 10, 0}, {0, -1, 0}}, {0, 100}, context, hits);
        QCOMPARE(hits.size(), std::size_t(2));
        QVERIFY(std::abs(hits[0].point.y - (2 + reach)) < 1e-9);
        QVERIFY(std::abs(hits[1].point.y - (2 - reach)) < 1e-9);
        QVERIFY(glm::distance(hits[0].normal, glm::dvec3(0, 1, 0)) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(SurfaceGridTest)
#include "surface_grid_test.moc"

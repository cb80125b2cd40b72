// SPDX-License-Identifier: GPL-3.0-or-later
// Places of `uv_mapping`, as POV-Ray 3.7 has them: points and places were read from its pictures.
#include <QTest>

#include "core/shapes/patches/bicubic_patch.h"
#include "core/shapes/patches/mesh.h"
#include "core/shapes/solids/blob.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/lathe.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/surface_of_revolution.h"
#include "core/shapes/solids/torus.h"

using namespace isoscope;

namespace {

struct Known {
    glm::dvec3 point;
    double u, v;
};

void check(const Shape& shape, std::initializer_list<Known> known) {
    for (const Known& each : known) {
        const std::optional<glm::dvec2> place = shape.surfacePlace(each.point);
        QVERIFY(place);
        const bool same = std::abs(place->x - each.u) < 6e-4 && std::abs(place->y - each.v) < 6e-4;
        QVERIFY2(same, qPrintable(QString("%1 %2 %3: %4 %5, not %6 %7")
                                      .arg(each.point.x)
                                      .arg(each.point.y)
                                      .arg(each.point.z)
                                      .arg(place->x)
                                      .arg(place->y)
                                      .arg(each.u)
                                      .arg(each.v)));
    }
}

}  // namespace

class SurfacePlaceTest : public QObject {
    Q_OBJECT

  private slots:
    void ofSpheres() {
        check(Sphere({0, 0, 0}, 1.3), {{{-0.3488, 0.4652, -1.1628}, 0.7036, 0.6165},
                                       {{0.0239, 0.0499, -1.2988}, 0.7529, 0.5122},
                                       {{0.1552, 0.6120, -1.1364}, 0.7716, 0.6560}});
    }

    void ofBoxes() {
        check(Box({-1, -1, -1}, {1, 1.5, 1}), {{{-0.3, 0.4, -1}, 0.9125, 0.52},
                                               {{0.1962, 0.5574, -1}, 0.8505, 0.5410},
                                               {{1, 0.398, -0.195}, 0.6494, 0.5197},
                                               {{-1, 0.398, 0.201}, 0.1501, 0.5197},
                                               {{0.0641, 1.5, -0.4339}, 0.3830, 0.9056},
                                               {{0.3142, -1, 0.3161}, 0.4143, 0.2193},
                                               {{0.199, 0.398, 1}, 0.3999, 0.5197}});
    }

    void ofTori() {
        check(Torus(1, 0.5), {{{-0.3443, 0.4591, -1.1477}, 0.7964, 0.6851},
                              {{-0.0410, 0.2259, 0.5524}, 0.2382, 0.9254},
                              {{0.5145, 0.1331, 0.0609}, 0.4813, 0.9571}});
    }

    void ofLathes() {
        const std::vector<glm::dvec2> points{{1, -1}, {1.2, 0}, {0.7, 0.5}, {0.3, 1}};
        check(Lathe(curveThrough(SplineKind::linear, points)),
              {{{-0.2493, 0.3325, -0.8310}, 0.7036, 0.5549}, {{0.0560, 0.0070, -1.1916}, 0.7575, 0.3380}});
        const std::vector<glm::dvec2> curve{{1, -1}, {1.2, -0.3}, {0.7, 0.5}, {0.3, 1}};
        check(Lathe(curveThrough(SplineKind::bezier, curve)),
              {{{-0.2213, 0.2950, -0.7374}, 0.7036, 0.6066}, {{0.1339, -0.0969, -0.9320}, 0.7727, 0.4190}});
    }

    void ofSurfacesOfRevolution() {
        const std::vector<glm::dvec2> points{{1, -1}, {1.2, -0.5}, {0.7, 0}, {0.5, 0.5}, {0.3, 1}};
        check(SurfaceOfRevolution(points, false), {{{-0.1684, 0.2246, -0.5615}, 0.7036, 0.7246},
                                                   {{-0.2465, 0.5, -0.1329}, 0.5786, 0.4398},
                                                   {{0.0556, -0.5, 0.1111}, 0.1762, 0.1035}});
        // v counts segments, however high they are.
        const std::vector<glm::dvec2> uneven{{0.9, -1},  {0.9, -0.8}, {0.4, 0},
                                             {0.6, 0.5}, {0.3, 0.8},  {0.1, 0.9}};
        check(SurfaceOfRevolution(uneven, false), {{{-0.1313, 0.1750, -0.4376}, 0.7036, 0.4500},
                                                   {{-0.3323, 0.6143, -0.4188}, 0.6432, 0.7938},
                                                   {{0.2687, -0.2767, -0.4825}, 0.8309, 0.2181}});
    }

    void ofMeshes() {
        const std::vector<glm::dvec3> points{{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}};
        Mesh::Face face{{0, 1, 2}};
        face.places = {0, 1, 2};
        const Mesh mesh(points, {}, {face}, {}, {{0, 0}, {1, 0}, {0, 1}});
        check(mesh, {{{-0.3, 0, 0}, 0.175, 0.5}, {{0.4135 - 0.3, -0.4697, 0}, 0.3371, 0.3826}});
        // Without places of its own every point is at the same.
        check(Mesh(points, {}, {face}, {}), {{{0.3, 0.1, 0}, 0, 0}});
    }

    void ofPatches() {
        BicubicPatch::Points points;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                points[static_cast<std::size_t>(4 * row + column)] = {column - 1.5, row - 1.5, 0};
        check(BicubicPatch(points, 4, 4, 0), {{{-0.2067, 0.4468, 0}, 0.4311, 0.6490}});
        check(BicubicPatch(points, 4, 4, 0, {glm::dvec2(0, 0), {0.2, 0.9}, {0.8, 0.7}, {0.6, 0.1}}),
              {{{0, 0, 0}, 0.4, 0.425}, {{-0.2067, 0.4468, 0}, 0.4756, 0.3689}});
    }

    void othersHaveNone() { QVERIFY(!Plane({0, 1, 0}, 0).surfacePlace({1, 0, 2})); }

    void texturesOfBlobsCountAsTheirComponents() {
        BlobComponent one{{-0.3, 0, 0}, {-0.3, 0, 0}, 0.8, 1}, other{{0.3, 0, 0}, {0.3, 0, 0}, 0.8, 1.5};
        one.texture = 1;
        other.texture = 2;
        const Blob blob({one, other}, 0.3);
        const std::vector<TextureShare> shares = blob.textureShares({0, 0.5, 0});
        QCOMPARE(shares.size(), std::size_t{2});
        QCOMPARE(shares[0].texture, std::size_t{1});
        QVERIFY(std::abs(shares[0].share - 0.4) < 1e-12);
        QVERIFY(std::abs(shares[1].share - 0.6) < 1e-12);
        // Far away none of them does.
        QCOMPARE(blob.textureShares({9, 9, 9}).front().texture, std::size_t{0});
    }

    void texturesOfFacesBlendBetweenTheCorners() {
        Mesh::Face face{{0, 1, 2}};
        face.textures = {1, 2, 3};
        const Mesh mesh({{-0.9, -0.9, 0}, {0.9, -0.9, 0}, {0, 0.9, 0}}, {}, {face}, {});
        const std::vector<TextureShare> shares = mesh.textureShares({0, 0, 0});
        QCOMPARE(shares.size(), std::size_t{3});
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs(shares[k].share - (k == 2 ? 0.5 : 0.25)) < 1e-12);
    }
};

QTEST_APPLESS_MAIN(SurfacePlaceTest)
#include "surface_place_test.moc"

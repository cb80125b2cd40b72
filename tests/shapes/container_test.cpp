// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/container.h"

#include <QTest>
#include <algorithm>
#include <random>

#include "core/shapes/rays/line_interval.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(16180);

/// Many ordinary rays, and what a scene can bring forth besides.
std::vector<Ray> someRays() {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-3, 3);
    const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
    std::vector<Ray> rays;
    for (int k = 0; k < 5000; ++k) {
        Ray ray{vector(), vector()};
        if (k % 5 == 0) ray.direction[k % 3] = 0;
        if (k % 7 == 0) ray.origin[k % 3] = k % 2 ? 1 : -1;
        if (k % 11 == 0) ray.direction *= 1e-200;
        if (k % 13 == 0) ray.origin *= 1e200;
        rays.push_back(ray);
    }
    const double nan = std::nan(""), infinite = INFINITY;
    rays.push_back({{0, 0, 0}, {0, 0, 0}});
    rays.push_back({{nan, 0, -3}, {0, 0, 1}});
    rays.push_back({{0, 0, -3}, {0, nan, 1}});
    rays.push_back({{infinite, 0, -3}, {0, 0, 1}});
    rays.push_back({{0, 0, -3}, {0, 0, infinite}});
    return rays;
}

bool same(const RayInterval& a, const RayInterval& b) {
    return (a.empty() && b.empty()) || (a.near == b.near && a.far == b.far);
}

}  // namespace

class ContainerTest : public QObject {
    Q_OBJECT

  private slots:
    void spheresArePassedAsOneByOne() {
        const std::vector<Ray> rays = someRays();
        std::size_t passed = 0;
        for (const ContainerSphere& sphere :
             {ContainerSphere{}, ContainerSphere{{0.5, -1, 2}, 1.5}, ContainerSphere{{0, 0, 0}, 0}}) {
            ContainerPassages passages;
            passages.find(sphere, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const LineInterval alone = sphereInterval(rays[i], sphere.center, sphere.radius);
                QVERIFY2(same(passages.range(i), alone.range), qPrintable(QString::number(i)));
                if (alone.empty()) continue;
                ++passed;
                QVERIFY(passages.wallNormal(sphere, rays[i], i, true) == alone.nearNormal);
                QVERIFY(passages.wallNormal(sphere, rays[i], i, false) == alone.farNormal);
            }
        }
        QVERIFY(passed > 1000);
    }

    /// A bug once: for more rays than stand in one block places were counted from where a sphere has no
    /// columns of faces, from a null pointer. UndefinedBehaviorSanitizer tells (the preset `sanitize`).
    void aSphereNeedsNoFaces() {
        const std::vector<Ray> rays(3 * LineColumns::padding, Ray{{0, 0.5, -3}, {0, 0, 1}});
        ContainerPassages passages;
        passages.find(ContainerSphere{}, rays);
        QVERIFY(same(passages.range(rays.size() - 1), passages.range(0)) && !passages.range(0).empty());
    }

    void boxesArePassedAsOneByOne() {
        const std::vector<Ray> rays = someRays();
        std::size_t passed = 0;
        for (const ContainerBox& box :
             {ContainerBox{}, ContainerBox{{-2, 0, -1}, {1, 0.5, 2}}, ContainerBox{{-1, 0, -1}, {1, 0, 1}},
              ContainerBox{{1, 1, 1}, {-1, -1, -1}}}) {
            ContainerPassages passages;
            passages.find(box, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const LineInterval alone = boxInterval(rays[i], box.low, box.high);
                QVERIFY2(same(passages.range(i), alone.range), qPrintable(QString::number(i)));
                if (alone.empty()) continue;
                ++passed;
                QVERIFY(passages.wallNormal(box, rays[i], i, true) == alone.nearNormal);
                QVERIFY(passages.wallNormal(box, rays[i], i, false) == alone.farNormal);
            }
        }
        QVERIFY(passed > 1000);
    }

    /// In columns, cut where the rays begin and where they are to end.
    void batchesArePassedAsRays() {
        const std::vector<Ray> rays = someRays();
        RayBatch batch;
        batch.assign(rays);
        AlignedColumn ends(rays.size() + LineColumns::padding);
        for (std::size_t i = 0; i < rays.size(); ++i) ends[i] = 0.01 * static_cast<double>(i % 700);
        std::size_t behind = 0, tooFar = 0;
        for (const Container& container : {Container(ContainerBox{{-2, 0, -1}, {1, 0.5, 2}}),
                                           Container(ContainerSphere{{0.5, -1, 2}, 1.5})}) {
            ContainerPassages alone, together;
            alone.find(container, rays);
            together.find(container, batch);
            together.beginWithRays(rays.size(), ends.data());
            std::vector<std::size_t> passing;
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (!alone.range(i).empty()) passing.push_back(i);
            std::array<std::array<AlignedColumn, 3>, 2> normals;
            for (const bool entering : {true, false})
                together.wallNormals(container, batch, passing, entering, normals[entering]);
            for (std::size_t k = 0; k < passing.size(); ++k) {
                const std::size_t i = passing[k];
                for (const bool entering : {true, false}) {
                    const auto& columns = normals[entering];
                    QVERIFY(glm::dvec3(columns[0][k], columns[1][k], columns[2][k]) ==
                            alone.wallNormal(container, rays[i], i, entering));
                }
                const double near = std::max(0.0, alone.range(i).near);
                const bool ended = ends[i] < near;
                QCOMPARE(together.range(i).near, near);
                QCOMPARE(together.range(i).far, ended ? -1 : alone.range(i).far);
                for (const bool entering : {true, false})
                    QVERIFY(together.wallNormal(container, batch, i, entering) ==
                            alone.wallNormal(container, rays[i], i, entering));
                behind += alone.range(i).near < 0;
                tooFar += ended;
            }
        }
        QVERIFY(behind > 10 && tooFar > 10);
    }
};

QTEST_APPLESS_MAIN(ContainerTest)
#include "container_test.moc"

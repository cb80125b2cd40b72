// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/object_tracer.h"

#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/sphere.h"

using namespace isoscope;

namespace {

constexpr std::size_t rayCount = 1024;

/// A ball that counts the rays it is shown.
class CountingBall : public Sphere {
  public:
    using Sphere::Sphere;
    void nearestInBatch(const RayBatch& rays, TraceContext& context, HitBatch& hits) const override {
        asked += rays.size();
        Sphere::nearestInBatch(rays, context, hits);
    }
    static inline std::size_t asked = 0;
};

double between(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 pointIn(std::mt19937_64& random, double size) {
    return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

/// Small balls in a cube, every seventh of them twice, and a floor; materials are the numbers of the objects.
Scene manyObjects(int count, std::mt19937_64& random) {
    Scene scene;
    const auto add = [&](ShapePointer shape) {
        SceneObject object;
        object.shape = std::move(shape);
        object.material = static_cast<MaterialId>(scene.objects.size());
        scene.objects.push_back(std::move(object));
    };
    glm::dvec3 center(0);
    for (int i = 0; i < count - 1; ++i) {
        if (i % 7 != 0) center = pointIn(random, 12);
        add(std::make_shared<CountingBall>(center, 0.2));
    }
    add(std::make_shared<Plane>(glm::dvec3(0, 1, 0), -13));
    return scene;
}

/// The rays of a picture's tile, all of them into the cube.
std::vector<Ray> tileOfRays(std::mt19937_64& random) {
    const glm::dvec3 eye(0, 0, -30), toward = pointIn(random, 8);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < rayCount; ++i)
        rays.push_back({eye, glm::normalize(toward + pointIn(random, 0.5) - eye)});
    return rays;
}

/// What the rays meet when every object is asked about every ray.
std::vector<NearestHit> byScan(const Scene& scene, std::span<const Ray> rays) {
    TraceContext context;
    std::vector<NearestHit> result(rays.size());
    for (const SceneObject& object : scene.objects) {
        std::vector<NearestHit> found(result);
        object.shape->nearest(rays, context, found);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!found[i].found || (result[i].found && !(found[i].hit.t < result[i].hit.t))) continue;
            result[i] = found[i];
            result[i].hit.material = object.material;
        }
    }
    return result;
}

bool everything(const SceneObject&) { return true; }

void compareHits(std::span<const NearestHit> found, std::span<const NearestHit> expected) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        QCOMPARE(found[i].found, expected[i].found);
        if (!expected[i].found) continue;
        QCOMPARE(found[i].hit.material, expected[i].hit.material);
        QVERIFY(found[i].hit.t == expected[i].hit.t && found[i].hit.normal == expected[i].hit.normal);
    }
}

}  // namespace

class ObjectTracerTest : public QObject {
    Q_OBJECT

  private slots:
    /// To the bit, and of two objects in one place the first; with and without a tree.
    void findsWhatAScanFinds_data() {
        QTest::addColumn<int>("count");
        for (const int count : {2, 15, 16, 17, 300, 2000}) QTest::addRow("%d objects", count) << count;
    }
    void findsWhatAScanFinds() {
        QFETCH(int, count);
        constexpr unsigned seed = 20;
        qInfo("seed %u", seed);
        std::mt19937_64 random(seed);
        const Scene scene = manyObjects(count, random);
        const ObjectTracer tracer(scene, everything);
        TraceContext context;
        GatheredRays gathered;
        for (int tile = 0; tile < 4; ++tile) {
            const std::vector<Ray> rays = tileOfRays(random);
            std::vector<NearestHit> found(rays.size());
            tracer.nearest(rays, context, gathered, found);
            compareHits(found, byScan(scene, rays));
        }
    }

    void blocksWhatAScanBlocks() {
        constexpr unsigned seed = 21;
        qInfo("seed %u", seed);
        std::mt19937_64 random(seed);
        const Scene scene = manyObjects(500, random);
        const ObjectTracer tracer(scene, everything);
        TraceContext context;
        GatheredRays gathered;
        int blockedRays = 0;
        for (int tile = 0; tile < 8; ++tile) {
            const std::vector<Ray> rays = tileOfRays(random);
            std::vector<double> limits;
            for (std::size_t i = 0; i < rays.size(); ++i) limits.push_back(between(random, 15, 60));
            std::vector<std::uint8_t> blocked(rays.size());
            tracer.blocked(rays, limits, context, gathered, blocked);
            const std::vector<NearestHit> expected = byScan(scene, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                QCOMPARE(blocked[i] != 0, expected[i].found && expected[i].hit.t < limits[i]);
                blockedRays += blocked[i];
            }
        }
        QVERIFY(blockedRays > 100 && blockedRays < 8 * 1024 - 100);
    }

    /// 10 000 objects: a ray is shown to a few of them, after a few dozen tests of boxes.
    void asksFewObjects() {
        constexpr unsigned seed = 22;
        qInfo("seed %u", seed);
        std::mt19937_64 random(seed);
        const Scene scene = manyObjects(10000, random);
        const ObjectTracer tracer(scene, everything);
        TraceContext context;
        GatheredRays gathered;
        CountingBall::asked = 0;
        constexpr int tiles = 20;
        for (int tile = 0; tile < tiles; ++tile) {
            const std::vector<Ray> rays = tileOfRays(random);
            std::vector<NearestHit> found(rays.size());
            tracer.nearest(rays, context, gathered, found);
        }
        const double rays = tiles * static_cast<double>(rayCount);
        const double asked = static_cast<double>(CountingBall::asked) / rays;
        const double tests = static_cast<double>(gathered.walk.tests) / rays;
        qInfo("%.2f objects asked a ray, %.1f boxes tested", asked, tests);
        QVERIFY(asked > 0 && asked < 4);
        QVERIFY(tests < 200);
    }

    /// The picture's blocks of rays that meet nothing are found without asking all objects.
    void bundlesPassByTheTree() {
        constexpr unsigned seed = 23;
        qInfo("seed %u", seed);
        std::mt19937_64 random(seed);
        Scene scene = manyObjects(1000, random);
        scene.objects.pop_back();  // the floor
        const ObjectTracer tracer(scene, everything);
        const auto bundle = [](const glm::dvec3& toward) {
            return RayBundle({{-1, -1, -31}, {1, 1, -29}}, {toward - 0.05, toward + 0.05});
        };
        QVERIFY(tracer.mayMeet(bundle({0, 0, 1})));
        QVERIFY(!tracer.mayMeet(bundle({0, 0, -1})));
        QVERIFY(!tracer.mayMeet(bundle({0, 1, 0.1})));
    }

    void nothingIsMetInAnEmptyScene() {
        const Scene scene;
        const ObjectTracer tracer(scene, everything);
        TraceContext context;
        GatheredRays gathered;
        const std::vector<Ray> rays(3);
        std::vector<NearestHit> found(3, NearestHit{true, {}});
        tracer.nearest(rays, context, gathered, found);
        for (const NearestHit& hit : found) QVERIFY(!hit.found);
        QVERIFY(!tracer.mayMeet(RayBundle(rays)));
    }
};

QTEST_APPLESS_MAIN(ObjectTracerTest)
#include "object_tracer_test.moc"

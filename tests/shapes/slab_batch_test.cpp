// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/slab_batch.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <QTest>
#include <random>

#include "core/shapes/rays/slab_ray.h"

using namespace isoscope;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t rayCount = 203;  // no multiple of any vector

struct Random {
    explicit Random(std::uint64_t seed) : engine(seed) {}

    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    /// Often on the walls of the boxes below, often along an axis.
    double coordinate() {
        const double some[] = {0, -0.0, 1, -1, 2, (*this)(-3, 3), (*this)(-3, 3), (*this)(-3, 3)};
        return some[engine() % std::size(some)];
    }
    glm::dvec3 point() { return {coordinate(), coordinate(), coordinate()}; }

    std::mt19937_64 engine;
};

/// Some flat, some endless, some empty.
Bounds anyBox(Random& random) {
    Bounds box{random.point(), random.point()};
    if (random.engine() % 4 != 0) box = {glm::min(box.low, box.high), glm::max(box.low, box.high)};
    if (random.engine() % 4 == 0) box.high[static_cast<int>(random.engine() % 3)] = infinity;
    if (random.engine() % 4 == 0) box.low[static_cast<int>(random.engine() % 3)] = -infinity;
    return box;
}

/// Of some of the rays, in runs of any length, the same are kept as of all.
void compareWithSome(const SlabBatch& batch, const Bounds& box, const std::vector<double>& farthest,
                     const std::vector<std::uint32_t>& meeting, Random& random) {
    std::vector<std::uint32_t> among, expected;
    bool taken = false;
    for (std::uint32_t i = 0; i < rayCount; ++i) {
        if (random.engine() % 8 == 0) taken = !taken;
        if (taken) among.push_back(i);
    }
    std::set_intersection(among.begin(), among.end(), meeting.begin(), meeting.end(),
                          std::back_inserter(expected));
    std::vector<std::uint32_t> kept(among.size());
    kept.resize(batch.keepMeeting(box, farthest.data(), among.data(), among.size(), kept.data()));
    QCOMPARE(kept, expected);
}

}  // namespace

/// Slab tests pass by no box that Bounds::clip finds, one ray at a time or many.
class SlabBatchTest : public QObject {
    Q_OBJECT

  private slots:
    void passesByNothingThatIsMet() {
        const std::uint64_t seed = std::random_device()();
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        int met = 0, passedBy = 0;
        for (int round = 0; round < 300; ++round) {
            std::vector<Ray> rays(rayCount);
            std::vector<double> farthest(rayCount + SlabBatch::padding, 0.0);
            for (std::size_t i = 0; i < rayCount; ++i) {
                rays[i] = {random.point(), random.point()};
                farthest[i] = random.engine() % 3 == 0 ? random(-0.5, 4) : infinity;
            }
            RayBatch columns;
            columns.assign(rays);
            SlabBatch batch;
            batch.assign(columns);
            const Bounds box = anyBox(random);
            std::vector<std::uint32_t> numbers{7, 7, 7};
            batch.findMeeting(box, farthest.data(), numbers);
            compareWithSome(batch, box, farthest, numbers, random);
            auto next = numbers.begin();
            for (std::uint32_t i = 0; i < rayCount; ++i) {
                const bool found = next != numbers.end() && *next == i;
                if (found) ++next;
                const RayInterval inside = box.clip(rays[i]);
                const bool wanted = !inside.empty() && inside.near <= farthest[i];
                const bool alone = SlabRay(rays[i]).mayMeet(box, farthest[i]);
                QVERIFY2(found || !wanted, qPrintable(QString::number(i)));
                QVERIFY2(found || !alone, qPrintable(QString::number(i)));
                QVERIFY2(alone || !wanted, qPrintable(QString::number(i)));
                ++(found ? met : passedBy);
            }
            QVERIFY(next == numbers.end());
        }
        QVERIFY(met > 1000 && passedBy > 1000);
    }

    void whatIsNoRayMeetsNothing() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const std::vector<Ray> rays{{{nan, 0, 0}, {0, 0, 1}},
                                    {{0, 0, 0}, {0, nan, 1}},
                                    {{0, -infinity, 0}, {0, 1, 0}},
                                    {{0, 0, 0}, {0, 0, infinity}},
                                    {{0, 0, -9}, {0, 0, 1}}};
        const std::vector<double> farthest(rays.size() + SlabBatch::padding, infinity);
        RayBatch columns;
        columns.assign(rays);
        SlabBatch batch;
        batch.assign(columns);
        std::vector<std::uint32_t> numbers;
        batch.findMeeting(Bounds(), farthest.data(), numbers);
        QCOMPARE(numbers, std::vector<std::uint32_t>{4});
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(!SlabRay(rays[i]).mayMeet(Bounds(), infinity));
    }
};

QTEST_APPLESS_MAIN(SlabBatchTest)
#include "slab_batch_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/point_membership.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/evaluate/prepared_function.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(271828);

/// Balls on a sphere of radius 1, less one of them where `bitten`, squeezed together and without a value
/// where `undefined`.
std::shared_ptr<const PreparedFunction> balls(int count, bool bitten, bool undefined) {
    return PreparedFunction::of(
        tapeOf([=](auto x, auto y, auto z) {
            const auto ball = [&](int k, double radius) {
                const double height = 1 - 2 * (k + 0.5) / count, wide = std::sqrt(1 - height * height);
                const Expression u = x - wide * std::cos(2.39996 * k), v = y - height,
                                 w = z - wide * std::sin(2.39996 * k);
                const Expression far = sq(u) + sq(v) + sq(w);
                return undefined && k % 7 == 3 ? sqrt(far - 0.5 * radius * radius) - 0.5 * radius
                                               : sqrt(far) - radius;
            };
            const double radius = 1.1 * std::sqrt(2.0 / count);
            Expression least = x.number(10);
            for (int k = 0; k < count; ++k) least = min(least, ball(k, radius));
            return bitten ? max(least, -ball(count / 3, 4 * radius)) : least;
        }),
        {});
}

RootSettings settingsOf(bool positivePolarity, double threshold) {
    RootSettings settings;
    settings.region = LineRegion{glm::dvec3(-1.5), glm::dvec3(1.5)};
    settings.positivePolarity = positivePolarity;
    settings.threshold = threshold;
    return settings;
}

}  // namespace

class PointMembershipTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// Points anywhere, outside of the region too, and again and again in one place.
    void answersAreThoseOfTheWholeFunction() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-1.7, 1.7), near(-0.01, 0.01);
        std::size_t inside = 0, all = 0;
        for (int round = 0; round < 16; ++round) {
            const auto function = balls(40 + 60 * (round % 3), round % 2 == 1, round % 4 >= 2);
            const RootSettings settings = settingsOf(round % 5 == 4, 0.01 * (round % 3));
            PointMembership membership(function, settings);
            PointEvaluator points(function);
            glm::dvec3 place{0};
            for (int k = 0; k < 4000; ++k) {
                if (k % 40 == 0) place = {anywhere(random), anywhere(random), anywhere(random)};
                const glm::dvec3 p = k % 2 == 0
                                         ? glm::dvec3(anywhere(random), anywhere(random), anywhere(random))
                                         : place + glm::dvec3(near(random), near(random), near(random));
                const bool expected = !(settings.signedValue(points.evaluate(p.x, p.y, p.z)) > 0);
                QCOMPARE(membership.isInside(p), expected);
                inside += expected;
                ++all;
            }
        }
        qInfo("%zu of %zu points inside", inside, all);
        QVERIFY(20 * inside > all && 20 * inside < 19 * all);
    }

    /// What is not defined is inside, as in POV-Ray; nowhere is no place.
    void noValueIsInside() {
        PointMembership membership(
            PreparedFunction::of(tapeOf([](auto x, auto, auto) { return sqrt(x); }), {}),
            settingsOf(false, 0.5));
        QVERIFY(membership.isInside({-1, 0, 0}));
        QVERIFY(membership.isInside({0.2, 0, 0}));
        QVERIFY(!membership.isInside({0.3, 0, 0}));
        QVERIFY(membership.isInside({NAN, 0, 0}));
    }

    /// A point of 2000 balls costs what few of them cost, once there were some points; the first ones what
    /// the whole function does.
    void pointsCostWhatIsNearThem() {
        const auto function = balls(2000, false, false);
        const std::uint64_t length = function->tape()->instructions().size();
        PointMembership membership(function, settingsOf(false, 0));
        std::mt19937_64 random(seed + 1);
        std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
        const auto ask = [&](int count) {
            const std::uint64_t before = membership.work();
            for (int k = 0; k < count; ++k)
                membership.isInside({anywhere(random), anywhere(random), anywhere(random)});
            return membership.work() - before;
        };
        QCOMPARE(ask(3), 3 * length);
        ask(20000);
        const std::uint64_t work = ask(2000);
        qInfo("%g instructions a point, the whole function has %llu", static_cast<double>(work) / 2000,
              static_cast<unsigned long long>(length));
        QVERIFY(work < 2000 * length / 20);
    }
};

QTEST_APPLESS_MAIN(PointMembershipTest)
#include "point_membership_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Gradients of crackle over boxes: no two points of a box differ by more than they say, jumps included.
#include <algorithm>
#include <array>
#include <cmath>
#include <QTest>
#include <random>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/function/scalar_operations.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(20261124);

using Point = std::array<double, 3>;
using Box = std::array<Interval, 3>;

class Random {
  public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    bool chance(double part) { return between(0, 1) < part; }

    CrackleSettings settings() {
        CrackleSettings settings;
        const int kind = static_cast<int>(between(0, 7));
        if (kind == 1) settings.form = {1, 0, 0};
        if (kind == 2) settings.form = {0, 0, 1};
        if (kind == 3) settings.form = {between(-1, 1), between(-1, 1), between(-1, 1)};
        if (kind == 4) settings.form = {0.6, -0.4, 0.3};
        if (kind == 5) settings.solid = true;
        if (kind == 6 && chance(0.3)) settings.cells = true;
        // Below 1 the 81 cells are too few, and crackle jumps at walls of cells.
        if (chance(0.5)) settings.metric = chance(0.2) ? 1 : chance(0.5) ? between(0.3, 1) : between(1, 8);
        // Other metrics have no values with an offset below 0.
        if (chance(0.3)) settings.offset = between(settings.metric == 2 ? -1 : 0, 1);
        return settings;
    }
    /// Across a wall of cells along some of the axes.
    Box box(double smallest = -7, double largest = 0) {
        const double size = std::pow(10, between(smallest, largest));
        Box box;
        for (Interval& axis : box) {
            double center = between(-40, 40);
            if (chance(0.4)) center = std::round(center) + size * between(-0.9, 0.9);
            axis = {center - size, center + size, false};
        }
        return box;
    }
    Point inside(const Box& box) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = between(box[k].low, box[k].high);
        return p;
    }
    /// Close to `p`, on the other side of a wall where there is one.
    Point beside(const Point& p, const Box& box) {
        Point q = p;
        const auto axis = static_cast<std::size_t>(between(0, 3));
        const double wall = std::round(p[axis]), way = std::pow(10, between(-9, -2));
        const double side = p[axis] < wall ? 1 : -1;
        q[axis] = chance(0.5) && std::abs(p[axis] - wall) < 0.01 ? wall + side * way : p[axis] + side * way;
        q[axis] = std::clamp(q[axis], box[axis].low, box[axis].high);
        return q;
    }

  private:
    std::mt19937_64 engine_{seed};
};

IntervalGradient gradientOf(const CrackleSettings& settings, const Box& box) {
    std::array<IntervalGradient, 3> places;
    for (int k = 0; k < 3; ++k) places[k] = gradient_rules::coordinate(k, box[k]);
    const std::array<const IntervalGradient*, 3> operands{&places[0], &places[1], &places[2]};
    return evaluateOperation(Operation::crackle, operands, &settings);
}

double climbBetween(const IntervalGradient& answer, const Point& p, const Point& q) {
    const double way = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    return answer.steepness * way * (1 + 1e-9) + 1e-12;
}

}  // namespace

class IntervalGradientCrackleTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    /// Where points of a box look at different cells crackle jumps, and that must be told.
    void noClimbIsSteeperThanTold() {
        Random random;
        int bounded = 0;
        for (int round = 0; round < 30000; ++round) {
            const CrackleSettings settings = random.settings();
            const Box box = random.box();
            const IntervalGradient answer = gradientOf(settings, box);
            if (answer.hazard > GradientHazard::jump) continue;
            bounded += answer.bounded();
            for (int sample = 0; sample < 12; ++sample) {
                const Point p = random.inside(box),
                            q = sample < 3 ? random.inside(box) : random.beside(p, box);
                const double fp = evaluateOperation(Operation::crackle, p, &settings),
                             fq = evaluateOperation(Operation::crackle, q, &settings);
                const double climb = climbBetween(answer, p, q);
                if (std::abs(fp - fq) > climb && answer.bounded())
                    QFAIL(qPrintable(QString::asprintf(
                        "round %d: %.17g from %a %a %a to %a %a %a, more than %.17g; metric %g offset %g "
                        "form "
                        "%g %g %g solid %d cells %d",
                        round, fq - fp, p[0], p[1], p[2], q[0], q[1], q[2], climb, settings.metric,
                        settings.offset, settings.form[0], settings.form[1], settings.form[2], settings.solid,
                        settings.cells)));
            }
        }
        QVERIFY2(bounded > 12000, qPrintable(QString::number(bounded)));
    }

    /// Below 1 the nearest in the metric may be in a cell that only one side of a wall looks at.
    void jumpsAtWallsAreTold() {
        Random random;
        int jumps = 0, steepBesides = 0;
        for (int round = 0; round < 60000; ++round) {
            CrackleSettings settings = random.settings();
            settings.solid = settings.cells = false;
            settings.metric = random.between(0.3, 0.9);
            // Not clipped as a rule.
            settings.form = {random.between(0, 0.3), random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
            Box box = random.box(-6, -2);
            const auto axis = static_cast<std::size_t>(round % 3);
            const double wall = std::round(box[axis].low), size = box[axis].width();
            box[axis] = {wall - size / 2, wall + size / 2, false};
            Point p = random.inside(box), q = p;
            p[axis] = wall - size * 1e-3;
            q[axis] = wall + size * 1e-3;
            const IntervalGradient answer = gradientOf(settings, box);
            const double apart = std::abs(evaluateOperation(Operation::crackle, p, &settings) -
                                          evaluateOperation(Operation::crackle, q, &settings));
            steepBesides += answer.hazard == GradientHazard::steepEdge;
            if (!(apart > climbBetween(answer, p, q))) continue;
            ++jumps;
            QVERIFY2(answer.hazard == GradientHazard::jump,
                     qPrintable(QString("round %1: %2").arg(round).arg(apart)));
        }
        qInfo("%d jumps, %d steep edges", jumps, steepBesides);
        QVERIFY2(jumps > 100, qPrintable(QString::number(jumps)));
    }

    void slopesAreWithinTheirRanges() {
        Random random;
        int compared = 0, tight = 0;
        for (int round = 0; round < 20000; ++round) {
            const CrackleSettings settings = random.settings();
            const Box box = random.box();
            const IntervalGradient answer = gradientOf(settings, box);
            if (!answer.bounded() || settings.solid || settings.cells) continue;
            const Point p = random.inside(box);
            constexpr double step = 1e-6;
            for (std::size_t k = 0; k < 3; ++k) {
                Point a = p, b = p;
                a[k] = std::max(p[k] - step, box[k].low);
                b[k] = std::min(p[k] + step, box[k].high);
                const double rise = evaluateOperation(Operation::crackle, b, &settings) -
                                    evaluateOperation(Operation::crackle, a, &settings);
                const double way = b[k] - a[k], rounding = 1e-13;
                ++compared;
                if (!(rise <= answer.slope[k].high * way + rounding &&
                      rise >= answer.slope[k].low * way - rounding))
                    QFAIL(qPrintable(QString::asprintf(
                        "round %d axis %d: slope %.17g beside [%.17g, %.17g], metric %g offset %g", round,
                        static_cast<int>(k), rise / way, answer.slope[k].low, answer.slope[k].high,
                        settings.metric, settings.offset)));
            }
            if (box[0].high - box[0].low < 1e-4) tight += answer.slope[0].high - answer.slope[0].low < 0.01;
        }
        QVERIFY2(compared > 20000, qPrintable(QString::number(compared)));
        QVERIFY2(tight > 2000, qPrintable(QString::number(tight)));
    }

    void cuspsOfLowMetricsAreSteep() {
        CrackleSettings settings;
        settings.metric = 0.5;
        Random random;
        int cusps = 0, bounded = 0;
        for (int round = 0; round < 2000; ++round) {
            Box box = random.box();
            const IntervalGradient answer = gradientOf(settings, box);
            cusps += answer.hazard == GradientHazard::steepEdge;
            bounded += answer.bounded();
        }
        QVERIFY2(cusps > 200 && bounded > 200, qPrintable(QString("%1 %2").arg(cusps).arg(bounded)));
    }

    /// In metric 1 a distance climbs by 1 along each axis, up or down.
    void aDistanceOfMetric1ClimbsByTheRootOf3() {
        CrackleSettings settings;
        settings.metric = 1;
        settings.form = {1, 0, 0};
        Random random;
        int known = 0;
        for (int round = 0; round < 300; ++round) {
            const IntervalGradient answer = gradientOf(settings, random.box(-7, -5));
            QVERIFY(answer.bounded() && answer.steepness < std::sqrt(3.0) * (1 + 1e-11));
            bool isKnown = true;
            for (const SlopeRange& slope : answer.slope) {
                QVERIFY(slope.size() < 1 + 1e-11);
                isKnown = isKnown && slope.gap() > 0.5;
            }
            if (!isKnown) continue;
            ++known;
            QVERIFY(answer.steepness >= std::sqrt(3.0));
        }
        QVERIFY2(known > 150, qPrintable(QString::number(known)));
    }

    /// Which cell point is the nearest one, and which the second, is certain nearly everywhere.
    void slopesAreThoseOfThePointsOfEachRank() {
        Random random;
        int narrow = 0;
        for (int round = 0; round < 300; ++round) {
            const IntervalGradient answer = gradientOf({}, random.box(-8, -7));
            const auto isNarrow = [](const SlopeRange& slope) { return slope.high - slope.low < 1e-3; };
            narrow += std::ranges::all_of(answer.slope, isNarrow);
        }
        QVERIFY2(narrow > 280, qPrintable(QString::number(narrow)));
    }
};

QTEST_APPLESS_MAIN(IntervalGradientCrackleTest)
#include "interval_gradient_crackle_test.moc"

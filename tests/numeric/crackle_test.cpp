// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/crackle.h"

#include <algorithm>
#include <cmath>
#include <QTest>
#include <random>

#include "core/numeric/crackle_sight.h"
#include "tests/numeric/slow_crackle.h"

using namespace isoscope;
using test::slowDistances;

class CrackleTest : public QObject {
    Q_OBJECT

  private slots:
    void uniformSequenceIsTheSpecifiedOne() {
        QVERIFY(uniformSequence()[0] == 0.8147236919030547);
        QVERIFY(uniformSequence()[1] == 0.13547700410708785);
        QVERIFY(uniformSequence()[2] == 0.9057919341139495);
    }

    void cellPointsAreTheSpecifiedOnes() {
        const auto origin = cracklePoint(0, 0, 0);
        QVERIFY(origin[0] == 0.7118189153261483 && origin[1] == 0.43665663921274245 &&
                origin[2] == 0.3563989873509854);
        const auto other = cracklePoint(-1, 2, 5);
        QVERIFY(other[0] == -0.010049795964732766 && other[1] == 2.443371911533177 &&
                other[2] == 5.5276800754945725);
    }

    void skippingFarCellsChangesNothing() {
        constexpr unsigned seed = 4711;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-30, 30);
        for (int i = 0; i < 4000; ++i) {
            double p[3] = {coordinate(random), coordinate(random), coordinate(random)};
            // Every fourth point lies on a lattice plane, where the cell is displaced.
            if (i % 4 == 0) p[i % 3] = std::round(p[i % 3]);
            const CrackleDistances found = crackleDistances(p[0], p[1], p[2], 2, 0);
            const CrackleDistances wanted = slowDistances(p[0], p[1], p[2]);
            QVERIFY(found.d == wanted.d && found.points == wanted.points);
        }
    }

    /// Far from the origin no candidates are kept, and in other metrics cells are looked at one by one.
    void everySearchFindsTheSamePoints() {
        constexpr unsigned seed = 4713;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        for (const double center : {0.0, 2e6, -3e9})
            for (const double metric : {1.0, 1.5, 2.0, 3.0})
                for (const double offset : {0.0, 0.2, 1.0, 2.0})
                    for (int i = 0; i < 100; ++i) {
                        std::uniform_real_distribution<double> coordinate(center - 30, center + 30);
                        std::array<double, 3> p{coordinate(random), coordinate(random), coordinate(random)};
                        if (i % 4 == 0) p[static_cast<std::size_t>(i / 4 % 3)] = std::round(p[0]);
                        const CrackleDistances found = crackleDistances(p[0], p[1], p[2], metric, offset);
                        const CrackleDistances wanted = slowDistances(p[0], p[1], p[2], metric, offset);
                        QVERIFY(found.points == wanted.points);
                        for (std::size_t rank = 0; rank < 3; ++rank)
                            QVERIFY(std::abs(found.d[rank] - wanted.d[rank]) < 1e-13);
                    }
    }

    /// A coordinate up to 1e-10 above a whole number belongs to the cell below, and none beyond that.
    void cellsAreDisplaced() {
        constexpr unsigned seed = 4714;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-300, 300);
        for (int i = 0; i < 20000; ++i) {
            std::array<double, 3> p{coordinate(random), coordinate(random), coordinate(random)};
            for (const double beyond : {0.9e-10, 1.2e-10}) {
                for (double& at : p) at = std::floor(at) + beyond;
                // Few of the nearest are at the rim of what is looked at; in this metric more than in others.
                QVERIFY(crackleDistances(p[0], p[1], p[2], 0.3, 0).points ==
                        slowDistances(p[0], p[1], p[2], 0.3).points);
                QVERIFY(crackleDistances(p[0], p[1], p[2], 2, 0).points ==
                        slowDistances(p[0], p[1], p[2]).points);
            }
        }
    }

    void cellsHaveTheFirstNumberOfTheirPoints() {
        for (const double x : {0.0, 0.5, -0.5, -3.0, 4099.25, -5000.5})
            for (const double y : {0.75, -7.25, 4095.5})
                for (const double z : {0.25, -0.25, 8191.0}) {
                    const auto cell = [](double at) { return static_cast<std::int64_t>(std::floor(at)); };
                    QVERIFY(std::abs(cellValue(x, y, z) -
                                     (cracklePoint(cell(x), cell(y), cell(z))[0] - std::floor(x))) < 1e-12);
                }
        const auto numbers = [](std::int64_t i, std::int64_t j, std::int64_t k) {
            const auto point = cracklePoint(i, j, k);
            return std::array{point[0] - double(i), point[1] - double(j), point[2] - double(k)};
        };
        // The hash has as many entries along each axis.
        for (const std::int64_t far : {4096, -4096, 8192}) {
            const auto here = numbers(5, 9, 2);
            for (const auto& there : {numbers(5 + far, 9, 2), numbers(5, 9 + far, 2), numbers(5, 9, 2 + far)})
                for (std::size_t axis = 0; axis < 3; ++axis)
                    QVERIFY(std::abs(here[axis] - there[axis]) < 1e-11);
        }
    }

    void generalMetricMeetsEuclidean() {
        const auto square = crackleDistances(0.3, 0.4, -0.7, 2, 0.2);
        const auto nearly = crackleDistances(0.3, 0.4, -0.7, 2 + 1e-12, 0.2);
        for (int i = 0; i < 3; ++i) QVERIFY(std::abs(square.d[i] - nearly.d[i]) < 1e-10);
        QCOMPARE(square.points, nearly.points);
    }

    /// What is out of sight is two cells away along two axes: where a cell is said to see enough, each place
    /// of it, corners and edges too, has enough points that are nearer.
    void cellsThatSeeEnoughHaveNearPointsEverywhere() {
        constexpr int side = 12, steps = 8;
        for (const double metric : {1.0, 2.0}) {
            const double limit = std::pow(2, 1 / metric);
            int said = 0;
            for (int n = 0; n < side * side * side; ++n) {
                const std::array<std::int64_t, 3> cell{n % side, n / side % side, n / side / side};
                if (!crackleSeesEnough({cell, cell}, metric, 3)) continue;
                ++said;
                std::array<std::array<double, 3>, 27> points;
                for (int k = 0; k < 27; ++k)
                    points[k] =
                        cracklePoint(cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1);
                for (int place = 0; place < (steps + 1) * (steps + 1) * (steps + 1); ++place) {
                    const std::array<double, 3> p{
                        double(cell[0]) + place % (steps + 1) / double(steps),
                        double(cell[1]) + place / (steps + 1) % (steps + 1) / double(steps),
                        double(cell[2]) + place / (steps + 1) / (steps + 1) / double(steps)};
                    int near = 0;
                    for (const auto& point : points)
                        near += crackleNorm(std::abs(p[0] - point[0]), std::abs(p[1] - point[1]),
                                            std::abs(p[2] - point[2]), metric) < limit;
                    QVERIFY(near >= 3);
                }
            }
            qInfo("metric %g: %d of %d cells", metric, said, side * side * side);
        }
    }

    /// Where the 81 cells are said to suffice, no cell further away holds a nearer point.
    void cellsThatSeeEnoughMissNothing() {
        constexpr unsigned seed = 4712;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> coordinate(-300, 300);
        for (const double metric : {1.0, 1.5, 2.0, 3.0, 8.0}) {
            int sufficient = 0;
            for (int i = 0; i < 400; ++i) {
                std::array<double, 3> p{coordinate(random), coordinate(random), coordinate(random)};
                p[i % 3] = std::round(p[i % 3]) + 1e-10;
                const int order = 1 + i % 3;
                const auto found = crackleDistances(p[0], p[1], p[2], metric, 0);
                if (!crackleSeesEnough(crackleCells(p, p), metric, order)) continue;
                ++sufficient;
                std::vector<double> all;
                for (int k = 0; k < 729; ++k) {
                    const std::array<int, 3> o{k % 9 - 4, k / 9 % 9 - 4, k / 81 - 4};
                    std::array<std::int64_t, 3> cell;
                    for (int a = 0; a < 3; ++a) cell[a] = std::int64_t(std::floor(p[a])) + o[a];
                    const auto point = cracklePoint(cell[0], cell[1], cell[2]);
                    all.push_back(crackleNorm(std::abs(p[0] - point[0]), std::abs(p[1] - point[1]),
                                              std::abs(p[2] - point[2]), metric));
                }
                std::sort(all.begin(), all.end());
                for (int rank = 0; rank < order; ++rank) QVERIFY(std::abs(all[rank] - found.d[rank]) < 1e-9);
            }
            QVERIFY2(sufficient >= 360, qPrintable(QString("%1 in metric %2").arg(sufficient).arg(metric)));
        }
        QVERIFY(!crackleSeesEnough({{0, 0, 0}, {0, 0, 0}}, 0.5, 1));
        QVERIFY(!crackleSeesEnough({{0, 0, 0}, {1000, 1000, 0}}, 2, 1));
        QVERIFY(crackleSeesEnough({{0, 0, 0}, {4095, 0, 0}}, 2, 1));
        QVERIFY(crackleSeesEnough({{0, 0, 0}, {15, 15, 15}}, 2, 1));
        QVERIFY(!crackleSeesEnough({{0, 0, 0}, {16, 15, 15}}, 2, 1));
    }

    void wildCoordinatesGiveNaN() {
        for (const double wild : {std::nan(""), double(INFINITY), -double(INFINITY), 1e300, 0x1p62, -0x1p62})
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::array<double, 3> p{0.1, 0.2, 0.3};
                p[axis] = wild;
                QVERIFY(std::isnan(cellValue(p[0], p[1], p[2])));
                for (const double metric : {2.0, 3.0})
                    for (const double d : crackleDistances(p[0], p[1], p[2], metric, 0).d)
                        QVERIFY(std::isnan(d));
                p[axis] = std::nextafter(0x1p62, 0);
                QVERIFY(!std::isnan(cellValue(p[0], p[1], p[2])));
                for (const double d : crackleDistances(p[0], p[1], p[2], 2, 0).d) QVERIFY(!std::isnan(d));
            }
    }
};

QTEST_APPLESS_MAIN(CrackleTest)
#include "crackle_test.moc"

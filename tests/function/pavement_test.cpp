// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/pavement.h"

#include <cmath>
#include <numbers>
#include <QTest>
#include <set>
#include <vector>

using namespace isoscope;

namespace {

/// A triangle, a square or a hexagon with unit sides.
struct Cell {
    PlanePoint center;
    int sides = 3;
    bool upright = true;  ///< whether a triangle points to +z

    double inner() const { return 0.5 / std::tan(std::numbers::pi / sides); }
    /// The way to the middle of a side.
    PlanePoint way(int side) const {
        const double first = sides == 4 ? 0 : sides == 6 ? 30 : upright ? 30 : 90;
        const double angle = (first + 360.0 * side / sides) * (std::numbers::pi / 180);
        return {inner() * std::cos(angle), inner() * std::sin(angle)};
    }
    Cell beyond(int side) const {
        const PlanePoint step = way(side);
        return {{center[0] + 2 * step[0], center[1] + 2 * step[1]}, sides, !upright};
    }
    std::pair<long, long> key() const { return {std::lround(center[0] * 100), std::lround(center[1] * 100)}; }
};

Cell firstCell(int sides) {
    const double h = std::numbers::sqrt3 / 2;
    if (sides == 4) return {{0.5, 0.5}, 4};
    return sides == 3 ? Cell{{0.5, h / 3}, 3} : Cell{{-0.5, h}, 6};
}

/// The cells that no border parts from this one; gives up beyond `most`.
std::size_t tileAround(const Pavement& pavement, const Cell& cell, std::size_t most) {
    std::vector<Cell> found{cell};
    std::set<std::pair<long, long>> seen{cell.key()};
    for (std::size_t k = 0; k < found.size() && found.size() <= most; ++k)
        for (int side = 0; side < cell.sides; ++side) {
            const Cell here = found[k];
            const PlanePoint step = here.way(side);
            if (pavement.value({here.center[0] + step[0], 7, here.center[1] + step[1]}) > 0.99) continue;
            const Cell next = here.beyond(side);
            if (seen.insert(next.key()).second) found.push_back(next);
        }
    return found.size();
}

}  // namespace

/// The values at places are those of POV-Ray: tests/data/texture/lookups.csv.
class PavementTest : public QObject {
    Q_OBJECT

  private slots:
    void everyTileHasItsCells() {
        int layouts = 0;
        for (const int sides : {3, 4, 6})
            for (int tiles = 1; nearestPavement({sides, tiles, 1}).tiles == tiles; ++tiles)
                for (int layout = 1; nearestPavement({sides, tiles, layout}).layout == layout; ++layout) {
                    const auto pavement = Pavement::of({sides, tiles, layout});
                    ++layouts;
                    Cell cell = firstCell(sides);
                    for (int step = 0; step < 40; ++step) {
                        const std::size_t cells = tileAround(*pavement, cell, 8);
                        QVERIFY2(cells == static_cast<std::size_t>(tiles),
                                 qPrintable(QString("%1 sides, %2 tiles, layout %3: %4")
                                                .arg(sides)
                                                .arg(tiles)
                                                .arg(layout)
                                                .arg(cells)));
                        cell = cell.beyond((step * step / 3) % sides);
                    }
                }
        QCOMPARE(layouts, 112);
    }

    void choicesThatDoNotExistActAsTheNearest() {
        QCOMPARE(nearestPavement({5, 9, 99}), (PavementChoice{4, 6, 35}));
        QCOMPARE(nearestPavement({7, 6, 0}), (PavementChoice{6, 5, 1}));
        QCOMPARE(nearestPavement({-1, -1, 2}), (PavementChoice{3, 1, 1}));
    }

    void placesWithoutACellAreZero() {
        for (const int sides : {3, 4, 6}) {
            const auto pavement = Pavement::of({sides, 2, 1});
            for (const double far : {2e9, -HUGE_VAL, std::nan("")}) {
                QCOMPARE(pavement->value({far, 0, 0}), 0.0);
                QCOMPARE(pavement->value({0, 0, far}), 0.0);
            }
            QVERIFY(pavement->value({-1e9, 0, 1e9}) >= 0);
        }
    }
};

QTEST_APPLESS_MAIN(PavementTest)
#include "pavement_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/cell_march.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/evaluate/prepared_function.h"
#include "core/function/patterns/pattern.h"
#include "tests/roots/line_table.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using test::LineTable;
using test::tapeOf;

namespace {

/// 32 x 32 parallel lines along z, 8 x 8 at a time.
std::vector<LineQuery> ahead(double apart) {
    std::vector<LineQuery> lines;
    for (int k = 0; k < 1024; ++k) {
        const int tile = k / 64, x = tile % 4 * 8 + k % 8, y = tile / 4 * 8 + k / 8 % 8;
        lines.push_back({{apart * (x - 15.5), apart * (y - 15.5), -4}, {0, 0, 1}, 2.1, 6});
    }
    return lines;
}

/// A row of balls of radius 0.3 along x, one apart.
std::shared_ptr<const Tape> rowOfBalls() {
    return tapeOf([](auto x, auto y, auto z) {
        Expression least = x.number(10);
        for (int k = -10; k <= 10; ++k) least = min(least, sq(x - k) + sq(y) + sq(z) - 0.09);
        return least;
    });
}

/// What a CellMarch works with.
class March {
  public:
    explicit March(const std::shared_ptr<const Tape>& tape, const RootSettings& settings = {})
        : settings_(settings),
          function_(PreparedFunction::of(tape, {})),
          forms_(function_),
          gradients_(function_),
          march_(forms_, settings_),
          polish_(gradients_, settings_),
          cells(*function_, {settings_, forms_, march_, polish_}) {}

    CellMarch::Outcome run(const std::vector<LineQuery>& lines) {
        const LineTable table(lines);
        roots.clear(lines.size());
        const CellMarch::Outcome outcome = cells.run(table.columns(), 0, {}, roots);
        evaluations = forms_.evaluations();
        return outcome;
    }
    double t(std::size_t line) const { return roots.crossings[FirstRoots::t][line]; }

  private:
    RootSettings settings_;
    std::shared_ptr<const PreparedFunction> function_;
    AffineEvaluator forms_;
    GradientEvaluator gradients_;
    MarchKernel march_;
    NewtonPolish polish_;

  public:
    CellMarch cells;
    FirstRoots roots;
    std::uint64_t evaluations = 0;
};

}  // namespace

class CellMarchTest : public QObject {
    Q_OBJECT

  private slots:
    /// Cells are for functions of which little is left in each. Ten clamps that never act are no such
    /// choices.
    void decidedChoicesAloneMakeNoCells() {
        const auto clamped = tapeOf([](auto x, auto y, auto z) {
            auto sum = z * -1;
            for (int k = 0; k < 10; ++k) sum = sum + 0.01 * max(sin(x * k) + sin(y * k) + 3, 0.5);
            return sum;
        });
        QVERIFY(March(clamped).cells.worthwhile());
        QCOMPARE(March(clamped).run(ahead(0.001)), CellMarch::Outcome::vain);
        QCOMPARE(March(rowOfBalls()).run(ahead(0.001)), CellMarch::Outcome::done);
        const std::vector<LineQuery> none(64, {{0, 0, -4}, {0, 0, 1}, 6, 2});
        QCOMPARE(March(rowOfBalls()).run(none), CellMarch::Outcome::nothingAsked);
    }

    /// The threshold is on neither side.
    void whereTheFunctionIsTheThresholdABoxHasNoSign() {
        const auto function =
            PreparedFunction::of(tapeOf([](auto x, auto, auto) { return max(x, x.number(0)); }), {});
        for (const bool inverted : {false, true}) {
            RootSettings settings;
            settings.positivePolarity = inverted;
            BoxPieces boxes(*function, settings);
            boxes.place({-2, 0, 0}, {1, 1, 1}, 0);
            boxes.place({2, 0, 0}, {1, 1, 1}, 1);
            boxes.enclose(2);
            QCOMPARE(boxes.sign(0), 0.0);
            QVERIFY(!boxes.isOutside(0));
            QCOMPARE(boxes.sign(1), inverted ? -1.0 : 1.0);
        }
    }

    /// A bug once: at the edge of a fractal each tile made short tapes by the thousand, 46 s for a picture of
    /// a magnet that takes 8 s without cells.
    void cellsThatCostTooMuchAreLeft() {
        const auto magnet = tapeOf([](auto x, auto y, auto z) {
            Pattern pattern;
            pattern.kind = PatternKind::magnetJulia;
            pattern.juliaPoint = {0.3, 0.3};
            pattern.iterations = 30;
            pattern.exterior = {1, 1};
            return buildPattern(pattern, x, y, z, 2) - 0.3;
        });
        std::vector<LineQuery> lines = ahead(0.01);
        for (LineQuery& line : lines) {
            line.direction =
                glm::normalize(glm::dvec3(0.1 + 0.4 * line.origin.x, 0.05 + 0.2 * line.origin.y, 1));
            line.origin.x -= 0.5;
        }
        March march(magnet);
        QCOMPARE(march.run(lines), CellMarch::Outcome::vain);
        qInfo("%llu enclosures", static_cast<unsigned long long>(march.evaluations));
        QVERIFY(march.evaluations > 0);
    }

    void rowsOfBallsAreMet() {
        March march(rowOfBalls());
        const std::vector<LineQuery> lines = ahead(0.07);
        QCOMPARE(march.run(lines), CellMarch::Outcome::done);
        std::size_t hits = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double x = lines[i].origin.x, y = lines[i].origin.y, off = x - std::round(x);
            const double square = 0.09 - off * off - y * y;
            const bool left = std::any_of(march.cells.rest().begin(), march.cells.rest().end(),
                                          [i](const MarchKernel::Line& line) { return line.line == i; });
            if (left) continue;
            QCOMPARE(march.t(i) < FirstRoots::none, square > 0);
            if (square > 0) QVERIFY(std::abs(march.t(i) - (4 - std::sqrt(square))) < 1e-7);
            hits += square > 0;
        }
        QVERIFY(hits > 100);
        QVERIFY(march.cells.rest().size() < 5);
        QVERIFY(march.cells.unsettled().empty());
        QCOMPARE(march.cells.searched(), lines.size());
        qInfo("%g enclosures a line", static_cast<double>(march.evaluations) / 1024);
        // Nearly all of them of single balls.
        QVERIFY(march.evaluations < 6 * lines.size());
    }

    /// Behind the wall hardly a choice is decided anywhere: there, cells would cost too much.
    void whatIsHiddenMakesNoCells() {
        const auto wallBeforeWaves = tapeOf([](auto, auto, auto z) {
            Expression waves = z * 0;
            for (int k = 0; k < 30; ++k) waves = waves + max(sin((1e5 + k) * z), 0.0);
            return min(sq(z + 1) - 0.01, max(-z, waves - 10));
        });
        March march(wallBeforeWaves);
        const std::vector<LineQuery> lines = ahead(0.001);
        QCOMPARE(march.run(lines), CellMarch::Outcome::done);
        for (std::size_t i = 0; i < lines.size(); ++i) QVERIFY(std::abs(march.t(i) - 2.9) < 1e-7);
    }

    /// Lines that begin inside an open surface leave it later, several cells on.
    void linesThatBeginInsideLeave() {
        RootSettings settings;
        settings.open = true;
        March march(rowOfBalls(), settings);
        std::vector<LineQuery> lines = ahead(0.001);
        for (LineQuery& line : lines) line.near = 4;
        QCOMPARE(march.run(lines), CellMarch::Outcome::done);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double x = lines[i].origin.x, y = lines[i].origin.y;
            QVERIFY(std::abs(march.t(i) - (4 + std::sqrt(0.09 - x * x - y * y))) < 1e-7);
        }
    }
};

QTEST_APPLESS_MAIN(CellMarchTest)
#include "cell_march_test.moc"

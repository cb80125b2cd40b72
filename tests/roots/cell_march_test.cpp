// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/cell_march.h"

#include <QTest>
#include <cmath>
#include <array>
#include <glm/geometric.hpp>
#include <random>

#include "core/evaluate/prepared_function.h"
#include "core/function/patterns/pattern.h"
#include "tests/roots/line_table.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::LineTable;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(271828);

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
          points_(function_),
          fallback_(points_, settings_),
          parts_(*function_, settings_),
          cells(*function_, {settings_, forms_, march_, polish_, fallback_, gradients_, parts_}) {}

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
    PointEvaluator points_;
    RootPolish fallback_;
    LazyUnionParts parts_;

  public:
    CellMarch cells;
    FirstRoots roots;
    std::uint64_t evaluations = 0;
};

}  // namespace

class CellMarchTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

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
        QVERIFY(march.roots.others.empty());
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

    /// Where two balls meet there is a kink, which the first polish leaves: it is settled by the short tape.
    void kinksAreSettled() {
        March march(tapeOf([](auto x, auto y, auto z) {
            Expression least = x.number(10);
            for (int k = -10; k <= 10; ++k) least = min(least, sq(x - k) + sq(y) + sq(z) - 1);
            return least;
        }));
        // Aslant, about where two balls meet.
        std::vector<LineQuery> lines = ahead(1e-6);
        for (LineQuery& line : lines) {
            line.direction = {0.6, 0, 0.8};
            line.origin += glm::dvec3(0.5, 0, 4 - std::sqrt(0.75)) - 4.0 * line.direction;
        }
        QCOMPARE(march.run(lines), CellMarch::Outcome::done);
        QVERIFY(march.cells.rest().empty());
        std::vector<double> found(lines.size());
        for (std::size_t i = 0; i < lines.size(); ++i) found[i] = march.t(i);
        for (const FirstRoots::Other& other : march.roots.others) {
            QVERIFY(other.root.kind == RootKind::crossing);
            found[other.line] = other.root.t;
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            double first = FirstRoots::none;
            for (int k = -10; k <= 10; ++k) {
                const glm::dvec3 from = lines[i].origin - glm::dvec3(k, 0, 0);
                const double nearest = -glm::dot(from, lines[i].direction);
                const double square = 1 - glm::dot(from, from) + nearest * nearest;
                if (square > 0) first = std::min(first, nearest - std::sqrt(square));
            }
            QVERIFY(std::abs(found[i] - first) < 1e-7);
        }
        qInfo("%zu settled by point values", march.roots.others.size());
        QVERIFY(!march.roots.others.empty());
    }

    /// More cells than tapes are kept: those that are made again are the same, and hold.
    void droppedTapesAreMadeAgain() {
        constexpr int row = 90;
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            Expression least = x.number(10);
            for (int k = 0; k < row * row; ++k)
                least = min(least, sq(x - k % row) + sq(y - k / row) + sq(z) - 0.16);
            return least;
        });
        const auto function = PreparedFunction::of(tape, {});
        PointEvaluator points(function);
        RootSettings settings;
        settings.region = LineRegion{glm::dvec3(-1, -1, -1), glm::dvec3(row, row, 1)};
        CellTree tree(*function, settings);
        struct Seen {
            glm::dvec3 center;
            std::vector<std::uint32_t> numbers;
        };
        std::vector<Seen> seen(row * row);
        std::size_t instructions = 0;
        std::mt19937_64 random(seed);
        for (const bool again : {false, true})
            for (int k = 0; k < row * row; ++k) {
                // A bundle about the top of a ball.
                const glm::dvec3 origin{k % row, k / row, -1};
                const std::vector<LineQuery> lines{{origin - glm::dvec3(0.05), {0, 0, 1}, 0.5, 0.8},
                                                   {origin + glm::dvec3(0.05), {0, 0, 1}, 0.5, 0.8}};
                const LineTable table(lines);
                const LineBundle bundle = *LineBundle::around(table.columns(), 0, lines.size());
                tree.begin(bundle);
                const CellTree::Cell& cell = tree.find(bundle, 0.5);
                QVERIFY(cell.tape != nullptr);
                std::vector<std::uint32_t> numbers;
                for (const Instruction& instruction : cell.tape->instructions)
                    numbers.push_back(instruction.number);
                if (again) {
                    QCOMPARE(cell.center, seen[static_cast<std::size_t>(k)].center);
                    QCOMPARE(numbers, seen[static_cast<std::size_t>(k)].numbers);
                    continue;
                }
                instructions += numbers.size();
                seen[static_cast<std::size_t>(k)] = {cell.center, numbers};
                std::array<double, 8> x, y, z, whole, left;
                std::uniform_real_distribution<double> place(-cell.halfWidth, cell.halfWidth);
                for (std::size_t i = 0; i < x.size(); ++i) {
                    x[i] = cell.center.x + place(random);
                    y[i] = cell.center.y + place(random);
                    z[i] = cell.center.z + place(random);
                }
                points.evaluate(x, y, z, whole);
                points.evaluate(x, y, z, left, *cell.tape);
                for (std::size_t i = 0; i < x.size(); ++i) QCOMPARE(left[i] < 0, whole[i] < 0);
            }
        qInfo("%zu instructions in all", instructions);
        QVERIFY(instructions > (std::size_t(1) << 16));
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

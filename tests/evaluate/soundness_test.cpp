// SPDX-License-Identifier: GPL-3.0-or-later
// Random graphs, boxes and points, on every instruction set in turn: the enclosures hold what the function is
// at 200 bits. A million points in the suite; ISOSCOPE_SOUNDNESS_POINTS asks for another number (`make soak`:
// 10^8) and ISOSCOPE_SEED for other graphs.
#include "core/evaluate/affine_evaluator.h"

#include <cmath>
#include <QTest>

#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "tests/support/exact_evaluator.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t defaultSeed = 16180339;
constexpr double defaultPoints = 1e6;
constexpr std::array shares{0.0, 0.5, 1.0};

/// Every operation with a bound of its own, without parameters: a part that depends on them alone counts as
/// its rounded value.
RandomFunctionSettings allOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    for (int k = 0; k < operationCount; ++k)
        if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
            settings.operations.push_back(static_cast<Operation>(k));
    return settings;
}

/// A coordinate of all points of a piece.
Interval coordinateRange(const std::array<std::array<ExactNumber, 3>, shares.size()>& points, int axis) {
    Interval range{INFINITY, -INFINITY, false};
    for (const auto& point : points) {
        range.low = std::min(range.low, mpfr_get_d(point[axis].get(), MPFR_RNDD));
        range.high = std::max(range.high, mpfr_get_d(point[axis].get(), MPFR_RNDU));
    }
    return range;
}

bool holds(const Interval& range, const ExactNumber& value) {
    if (value.isNan()) return range.maybeUndefined;
    return mpfr_cmp_d(value.get(), range.low) >= 0 && mpfr_cmp_d(value.get(), range.high) <= 0;
}

struct Counts {
    double points = 0;
    double boundedForms = 0;
    double boundedIntervals = 0;
};

using PiecePoints = std::array<std::array<ExactNumber, 3>, shares.size()>;

/// A piece of a ray with everything that encloses the function on it.
struct Enclosures {
    AffineForm form;
    Interval range;       ///< over the smallest box around the piece
    Interval batchRange;  ///< the same with vector instructions
};

/// Empty when all enclosures hold at the points.
QString checkPiece(const Function& function, const PiecePoints& points, const Enclosures& enclosures,
                   Counts& counts) {
    const AffineForm& form = enclosures.form;
    counts.boundedForms += std::abs(form.e) < INFINITY;
    counts.boundedIntervals += enclosures.range.width() < INFINITY;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        bool regular = true;
        const ExactNumber value = evaluateExactly(function, points[k], {}, regular);
        if (!regular) continue;
        ++counts.points;
        if (!admits(form, shares[k], value))
            return QString::asprintf("%.17g + %.17g s +- %.17g does not hold %.17g at share %g", form.a,
                                     form.b, form.e, value.rounded(), shares[k]);
        for (const Interval& range : {enclosures.range, enclosures.batchRange})
            if (!holds(range, value))
                return QString::asprintf(
                    "[%.17g, %.17g] (maybe undefined: %d) does not hold %.17g at share %g", range.low,
                    range.high, range.maybeUndefined, value.rounded(), shares[k]);
    }
    return {};
}

/// One graph on a batch of pieces.
QString checkGraph(const Function& function, std::mt19937_64& random, Counts& counts) {
    const auto tape = Tape::compile(function);
    AffineEvaluator affine(tape, {});
    IntervalEvaluator interval(tape, {});
    BoxEvaluator batch(tape, {});
    const RayPieces pieces = randomPieces(random);
    std::array<AffineForm, batchLanes> forms;
    affine.evaluate(pieces, forms);
    std::array<PiecePoints, batchLanes> points;
    BoxLanes boxes;
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        for (std::size_t k = 0; k < shares.size(); ++k) points[lane][k] = pointAt(pieces, lane, shares[k]);
        for (int axis = 0; axis < 3; ++axis) {
            const Interval side = coordinateRange(points[lane], axis);
            boxes.low[axis][lane] = side.low;
            boxes.high[axis][lane] = side.high;
        }
    }
    std::array<Interval, batchLanes> batchRanges;
    batch.evaluate(boxes, batchRanges);
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        std::array<Interval, 3> box;
        for (int axis = 0; axis < 3; ++axis)
            box[axis] = {boxes.low[axis][lane], boxes.high[axis][lane], false};
        const QString problem = checkPiece(function, points[lane],
                                           {forms[lane], interval.evaluate(box), batchRanges[lane]}, counts);
        if (!problem.isEmpty()) return problem;
    }
    return {};
}

}  // namespace

class SoundnessTest : public QObject {
    Q_OBJECT

  private slots:
    void enclosuresHoldExactValues() {
        const std::uint64_t seed = seedSetting(defaultSeed);
        const double wanted = setting("ISOSCOPE_SOUNDNESS_POINTS", defaultPoints);
        qInfo("seed %llu, %g points", static_cast<unsigned long long>(seed), wanted);
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = allOperations();
        Counts counts;
        double graphs = 0;
        const auto sets = instructionSets();
        for (; counts.points < wanted; ++graphs) {
            const auto& [set, setName] = sets[static_cast<std::size_t>(graphs) % sets.size()];
            const ForcedInstructionSet forced(set);
            settings.nodes = 1 + static_cast<int>(random() % 12);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            const QString problem = checkGraph(function, random, counts);
            QVERIFY2(problem.isEmpty(),
                     qPrintable(QString::asprintf("graph %g, %s: ", graphs, setName) + problem + "\n" +
                                QString::fromStdString(describe(function))));
        }
        const double pieces = graphs * double(batchLanes);
        qInfo("%g graphs; bounded: %.2f of the forms, %.2f of the intervals", graphs,
              counts.boundedForms / pieces, counts.boundedIntervals / pieces);
        QVERIFY(counts.boundedForms > 0.3 * pieces);
        QVERIFY(counts.boundedIntervals > 0.3 * pieces);
    }
};

QTEST_APPLESS_MAIN(SoundnessTest)
#include "soundness_test.moc"

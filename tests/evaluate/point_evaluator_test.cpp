// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/point_evaluator.h"

#include <bit>
#include <cmath>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/support/csv_table.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(20240611);

bool same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Zeros of the same sign, infinities and NaN alike, everything else within `tolerance` of max(1, |wanted|).
bool agrees(double got, double wanted, double tolerance) {
    if (tolerance == 0 || wanted == 0 || !std::isfinite(wanted)) return same(got, wanted);
    return goldenError(got, wanted) <= tolerance;
}

bool isExact(Operation operation) {
    const auto exact = exactOperations();
    return std::find(exact.begin(), exact.end(), operation) != exact.end();
}

std::vector<Operation> plainOperations() {
    std::vector<Operation> operations;
    for (int k = 0; k < operationCount; ++k)
        if (arity(static_cast<Operation>(k)) > 0) operations.push_back(static_cast<Operation>(k));
    return operations;
}

/// Columns of arguments, `count` of each.
using Columns = std::vector<std::vector<double>>;

std::vector<double> runBatch(PointEvaluator& evaluator, const Columns& columns, std::size_t count,
                             std::size_t first = 0, std::size_t result = 0) {
    std::vector<const double*> pointers;
    for (const auto& column : columns) pointers.push_back(column.data() + first);
    std::vector<double> out(count);
    evaluator.evaluate(pointers, count, out, result);
    return out;
}

QString hex(double a) { return QString::asprintf("%a", a); }

QByteArray describe(Operation operation, const std::vector<double>& arguments, double got, double wanted) {
    QByteArray text(std::string(name(operation)).c_str());
    for (const double argument : arguments) text += " " + hex(argument).toLatin1();
    return text + ": got " + hex(got).toLatin1() + ", wanted " + hex(wanted).toLatin1();
}

/// All combinations of special numbers (up to three operands; thinned above), and `randomCount` rows of
/// random ones.
Columns operandColumns(int arity, std::size_t randomCount, std::mt19937_64& random) {
    Columns columns(arity);
    const auto& special = specialNumbers();
    if (arity <= 2) {
        for (const double a : special)
            for (const double b : special) {
                columns[0].push_back(a);
                if (arity == 2) columns[1].push_back(b);
                if (arity == 1) break;
            }
    } else {
        for (int k = 0; k < 4000; ++k)
            for (auto& column : columns) column.push_back(special[random() % special.size()]);
    }
    for (std::size_t k = 0; k < randomCount; ++k)
        for (auto& column : columns) column.push_back(anyNumber(random));
    return columns;
}

Function csgFunction(int terms) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    Expression total = x.number(1e9);
    for (int k = 0; k < terms; ++k) {
        const Expression sphere = sqrt(sq(x - 0.1 * k) + sq(y - 0.2 * k) + sq(z + 0.3 * k)) - 0.5;
        total = k % 2 ? min(sphere, total) : max(total, -sphere);
    }
    const NodeId result = total.node();
    return finish(std::move(graph), {result}, 3);
}

}  // namespace

class PointEvaluatorTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void everyOperationAgreesWithTheReference() {
        std::mt19937_64 random(seed);
        for (const Operation operation : plainOperations()) {
            const int count = arity(operation);
            FunctionGraph graph;
            std::vector<NodeId> operands;
            for (int k = 0; k < 4; ++k) operands.push_back(graph.variable(k));
            const NodeId root = addOperation(graph, operation, operands, random);
            const Function function = finish(std::move(graph), {root}, count);
            const double tolerance = isExact(operation) || operation == Operation::crackle ? 0 : 1e-12;
            const Columns columns =
                operandColumns(count, operation == Operation::crackle ? 300 : 20000, random);
            PointEvaluator batch(Tape::compile(function), {});
            ReferenceEvaluator reference(function);
            const std::vector<double> got = runBatch(batch, columns, columns[0].size());
            for (std::size_t i = 0; i < got.size(); ++i) {
                std::vector<double> arguments;
                for (const auto& column : columns) arguments.push_back(column[i]);
                const double wanted = reference.evaluate(arguments);
                if (!agrees(got[i], wanted, tolerance)) QFAIL(describe(operation, arguments, got[i], wanted));
            }
        }
    }

    /// Full batches keep values in an accumulator (StepProgram); floor ends a stretch of its steps.
    void fullBatchesAgreeWithTheReferenceToTheLastBit() {
        std::mt19937_64 random(seed + 7);
        RandomFunctionSettings settings;
        settings.loops = false;
        for (int round = 0; round < 3000; ++round) {
            settings.operations = {Operation::add, Operation::subtract, Operation::multiply,
                                   Operation::square};
            if (round % 2)
                settings.operations.insert(
                    settings.operations.end(),
                    {Operation::divide, Operation::minimum, Operation::maximum, Operation::negate,
                     Operation::absolute, Operation::squareRoot, Operation::floor});
            settings.nodes = 2 + static_cast<int>(random() % 24);
            const Function function = randomFunction(random, settings);
            const std::vector<double> parameters{anyNumber(random), anyNumber(random), anyNumber(random)};
            Columns columns(3);
            for (auto& column : columns)
                for (std::size_t i = 0; i < batchLanes; ++i) column.push_back(anyNumber(random));
            PointEvaluator batch(Tape::compile(function), parameters);
            ReferenceEvaluator reference(function);
            for (std::size_t result = 0; result < function.results.size(); ++result) {
                const std::vector<double> got = runBatch(batch, columns, batchLanes, 0, result);
                for (std::size_t i = 0; i < batchLanes; ++i) {
                    const double wanted = reference.evaluate({{columns[0][i], columns[1][i], columns[2][i]}},
                                                             parameters, result);
                    QVERIFY2(same(got[i], wanted), isoscope::test::describe(function).c_str());
                }
            }
        }
    }

    /// The last result of a full batch goes straight to the caller; the next run must not write there again.
    void everyResultGoesWhereItWasAskedFor() {
        FunctionGraph graph;
        const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1));
        const NodeId sum = (x + y).node(), product = (x * y * (x + y)).node();
        PointEvaluator batch(Tape::compile(finish(std::move(graph), {sum, product}, 3)), {});
        const std::vector<double> twos(batchLanes, 2.0), threes(batchLanes, 3.0);
        std::vector<double> first(batchLanes), second(batchLanes);
        batch.evaluate(twos, threes, twos, first, 1);
        QCOMPARE(first, std::vector<double>(batchLanes, 30.0));
        batch.evaluate(twos, twos, twos, second, 0);
        QCOMPARE(second, std::vector<double>(batchLanes, 4.0));
        QCOMPARE(first, std::vector<double>(batchLanes, 30.0));
    }

    void uniformOperandsAgreeWithTheReference() {
        std::mt19937_64 random(seed + 1);
        for (const Operation operation : plainOperations()) {
            const int count = arity(operation);
            if (count < 2 || operation == Operation::crackle) continue;
            for (unsigned uniform = 1; uniform + 1 < (1u << count); ++uniform) {
                FunctionGraph graph;
                std::vector<NodeId> operands;
                for (int k = 0; k < count; ++k)
                    operands.push_back(uniform >> k & 1 ? graph.parameter(k) : graph.variable(k));
                const NodeId root = addOperation(graph, operation, operands, random);
                const Function function = finish(std::move(graph), {root}, count);
                const auto tape = Tape::compile(function);
                ReferenceEvaluator reference(function);
                const double tolerance = isExact(operation) ? 0 : 1e-12;
                for (int round = 0; round < 20; ++round) {
                    std::vector<double> parameters;
                    for (int k = 0; k < count; ++k) parameters.push_back(anyNumber(random));
                    PointEvaluator batch(tape, parameters);
                    Columns columns(count);
                    for (auto& column : columns)
                        for (int i = 0; i < 100; ++i) column.push_back(anyNumber(random));
                    const std::vector<double> got = runBatch(batch, columns, 100);
                    for (std::size_t i = 0; i < got.size(); ++i) {
                        std::vector<double> arguments;
                        for (const auto& column : columns) arguments.push_back(column[i]);
                        const double wanted = reference.evaluate(arguments, parameters);
                        if (!agrees(got[i], wanted, tolerance))
                            QFAIL(describe(operation, arguments, got[i], wanted));
                    }
                }
            }
        }
    }

    void randomFunctionsOfExactOperationsAgreeToTheLastBit() {
        std::mt19937_64 random(seed + 2);
        for (int round = 0; round < 400; ++round) {
            RandomFunctionSettings settings;
            settings.nodes = 1 + static_cast<int>(random() % 60);
            const Function function = randomFunction(random, settings);
            std::vector<double> parameters;
            for (int k = 0; k < settings.parameters; ++k) parameters.push_back(anyNumber(random));
            Columns columns(3);
            for (auto& column : columns)
                for (int i = 0; i < 100; ++i) column.push_back(anyNumber(random));
            PointEvaluator batch(Tape::compile(function), parameters);
            ReferenceEvaluator reference(function);
            for (std::size_t result = 0; result < function.results.size(); ++result) {
                const std::vector<double> got = runBatch(batch, columns, 100, 0, result);
                for (std::size_t i = 0; i < got.size(); ++i) {
                    const double arguments[] = {columns[0][i], columns[1][i], columns[2][i]};
                    const double wanted = reference.evaluate(arguments, parameters, result);
                    QVERIFY2(same(got[i], wanted), qPrintable(QStringLiteral("round %1 lane %2: %3 %4")
                                                                  .arg(round)
                                                                  .arg(i)
                                                                  .arg(hex(got[i]), hex(wanted))));
                }
            }
        }
    }

    void aPointsAnswerDependsOnNothingElse() {
        std::mt19937_64 random(seed + 3);
        RandomFunctionSettings settings;
        settings.operations = plainOperations();
        std::erase(settings.operations, Operation::crackle);
        settings.nodes = 30;
        for (int round = 0; round < 40; ++round) {
            const Function function = randomFunction(random, settings);
            const std::vector<double> parameters{1.5, -2, 0.3};
            PointEvaluator batch(Tape::compile(function), parameters);
            Columns columns(3);
            for (auto& column : columns)
                for (int i = 0; i < 131; ++i) column.push_back(anyNumber(random));
            std::vector<double> alone;
            for (int i = 0; i < 131; ++i)
                alone.push_back(batch.evaluate(columns[0][i], columns[1][i], columns[2][i]));
            for (std::size_t size = 1; size <= 130; ++size) {
                const std::size_t first = random() % (132 - size);
                const std::vector<double> got = runBatch(batch, columns, size, first);
                for (std::size_t i = 0; i < size; ++i) QVERIFY(same(got[i], alone[first + i]));
            }
        }
    }

    void writesOnlyWhatWasAsked() {
        FunctionGraph graph;
        const NodeId root = graph.binary(Operation::add, graph.variable(0), graph.variable(1));
        PointEvaluator batch(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        const std::vector<double> ones(70, 1.0);
        for (std::size_t count = 0; count <= 70; ++count) {
            std::vector<double> out(80, -7.0);
            const std::span<const double> column(ones.data(), count);
            batch.evaluate(column, column, column, std::span(out.data() + 1, count));
            for (std::size_t i = 0; i < out.size(); ++i) QCOMPARE(out[i], i >= 1 && i <= count ? 2.0 : -7.0);
        }
    }

    void countsEvaluations() {
        FunctionGraph graph;
        const NodeId root = graph.variable(2);
        PointEvaluator batch(Tape::compile(finish(std::move(graph), {root}, 3)), {});
        QCOMPARE(batch.evaluate(1, 2, 3), 3.0);
        const std::vector<double> column(100, 4.0);
        std::vector<double> out(100);
        batch.evaluate(column, column, column, out);
        QCOMPARE(out[99], 4.0);
        QCOMPARE(batch.evaluations(), std::uint64_t(101));
    }

    void aCsgScaleFunctionAgrees() {
        const Function function = csgFunction(100);
        PointEvaluator batch(Tape::compile(function), {});
        ReferenceEvaluator reference(function);
        std::mt19937_64 random(seed + 4);
        for (int k = 0; k < 200; ++k) {
            const double arguments[] = {anyNumber(random), anyNumber(random), anyNumber(random)};
            QVERIFY(same(batch.evaluate(arguments[0], arguments[1], arguments[2]),
                         reference.evaluate(arguments)));
        }
    }

    void loopsThatAreTooLongGiveNaN() {
        const double bounds[][2] = {
            {0, 1e7},          {0, 1e300},          {-INFINITY, 0},        {INFINITY, INFINITY},
            {1e17, 1e17 + 64}, {-1e17, -1e17 + 64}, {-INFINITY, -INFINITY}};
        for (const auto& [from, to] : bounds) {
            FunctionGraph body;
            const NodeId term = body.variable(0);
            FunctionGraph graph;
            const NodeId root = graph.loop(Operation::sum, graph.variable(0), graph.variable(1),
                                           finish(std::move(body), {term}, 1), {});
            const Function function = finish(std::move(graph), {root}, 2);
            const double arguments[] = {from, to};
            QVERIFY(std::isnan(ReferenceEvaluator(function).evaluate(arguments)));
            PointEvaluator batch(Tape::compile(function), {});
            QVERIFY(std::isnan(runBatch(batch, {{from}, {to}}, 1)[0]));
        }
    }

    void nestedLoopsShareTheirAllowance() {
        const auto nested = [](NodeId (*outerLast)(FunctionGraph&)) {
            FunctionGraph inner;
            const NodeId one = inner.constant(1);
            FunctionGraph outer;
            const NodeId innerSum = outer.loop(Operation::sum, outer.constant(1), outer.variable(1),
                                               finish(std::move(inner), {one}, 1), {});
            FunctionGraph graph;
            const NodeId captured[] = {graph.variable(0)};
            const NodeId root = graph.loop(Operation::sum, graph.constant(1), outerLast(graph),
                                           finish(std::move(outer), {innerSum}, 2), captured);
            return finish(std::move(graph), {root}, 1);
        };
        const Function function = nested([](FunctionGraph& graph) { return graph.variable(0); });
        PointEvaluator batch(Tape::compile(function), {});
        for (const double steps : {0.0, 10.0, 500.0, 900.0, 1001.0, 5000.0}) {
            const double wanted = ReferenceEvaluator(function).evaluate({{steps}});
            QVERIFY(same(wanted, steps * steps > 1e6 ? NAN : steps * steps));
            QVERIFY(same(runBatch(batch, {{steps}}, 1)[0], wanted));
        }
    }
};

QTEST_APPLESS_MAIN(PointEvaluatorTest)
#include "point_evaluator_test.moc"

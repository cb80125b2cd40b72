// SPDX-License-Identifier: GPL-3.0-or-later
// The evaluators give the same answers with every instruction set that they are compiled for.
#include "core/evaluate/affine_evaluator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/gradient_kernel.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/evaluate/taylor_evaluator.h"
#include "core/evaluate/taylor_kernel.h"
#include "tests/support/csv_table.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::uint64_t seed = seedSetting(577215);
constexpr std::size_t count = 3 * batchLanes + 5;

using Column = std::vector<double>;

struct Points {
    Column x, y, z;

    explicit Points(std::mt19937_64& random) {
        for (Column* column : {&x, &y, &z})
            for (std::size_t i = 0; i < count; ++i) column->push_back(anyNumber(random));
    }
};

bool sameBits(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Unless nothing is known: then only the error means anything.
bool sameForm(const AffineLanes& a, const AffineLanes& b, std::size_t i) {
    if (!sameBits(a.error[i], b.error[i])) return false;
    return !std::isfinite(a.error[i]) ||
           (sameBits(a.center[i], b.center[i]) && sameBits(a.slope[i], b.slope[i]));
}

/// Sums, products and choices over few values: what StepProgram keeps in registers; in every third round also
/// what ends its stretches.
Function randomSteps(std::mt19937_64& random, int round, std::vector<Operation> others) {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.operations = {Operation::add, Operation::subtract, Operation::multiply, Operation::square,
                           Operation::negate};
    if (round % 3 >= 1)
        settings.operations.insert(settings.operations.end(),
                                   {Operation::absolute, Operation::minimum, Operation::maximum});
    if (round % 3 == 2) settings.operations.insert(settings.operations.end(), others.begin(), others.end());
    settings.nodes = 2 + static_cast<int>(random() % 40);
    Function function = randomFunction(random, settings);
    function.results.resize(1);
    return function;
}

/// The tape with some choices made at random.
SimplifiedTape randomSimplifiedTape(const Tape& tape, std::mt19937_64& random) {
    const TapeLinks links(tape);
    TapeSimplifier simplifier(links);
    std::vector<Choice> choices(simplifier.choiceCount());
    for (Choice& choice : choices) choice = static_cast<Choice>(random() % 3);
    SimplifiedTape simplifiedTape;
    simplifier.simplify(choices, 0, simplifiedTape);
    return simplifiedTape;
}

/// The program of a simplified tape, though it is run but once.
struct SimplifiedProgram {
    const SimplifiedTape& tape;
    TapeWorkspace workspace;
    StepCode code;
    StepProgram program;

    SimplifiedProgram(const PreparedFunction& function, const SimplifiedTape& simplifiedTape,
                      std::size_t components)
        : tape(simplifiedTape),
          workspace(*function.tape(), function.uniforms(), components),
          code(*function.tape(), tape.instructions, std::span(&tape.result, 1),
               StepProgram::numbersOf(workspace)),
          program(workspace, code) {}

    double* argument(std::size_t k) { return workspace.slot(static_cast<Slot>(k)); }
    const double* result() const { return workspace.address(tape.result); }
};

std::vector<double> entriesOf(const GradientLanes& lanes, std::size_t i) {
    return {lanes.value[i], lanes.gradient[0][i], lanes.gradient[1][i], lanes.gradient[2][i]};
}

std::vector<double> entriesOf(const TaylorLanes& lanes, std::size_t i) {
    std::vector<double> entries = entriesOf(lanes.point, i);
    entries.insert(entries.end(), {lanes.slope[i], lanes.remainder[i], lanes.rounding[i]});
    return entries;
}

std::vector<Operation> operationsWithVectorCode() {
    std::vector<Operation> operations;
    for (int k = 0; k < operationCount; ++k)
        if (arity(static_cast<Operation>(k)) > 0 && static_cast<Operation>(k) != Operation::crackle)
            operations.push_back(static_cast<Operation>(k));
    return operations;
}

}  // namespace

class InstructionSetsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        for (const auto& [target, name] : instructionSets()) qInfo("%s", name);
        QVERIFY(instructionSets().size() > 1);
    }

    void exactOperationsAgreeToTheLastBit() {
        std::mt19937_64 random(seed);
        for (int round = 0; round < 200; ++round) {
            RandomFunctionSettings settings;
            settings.nodes = 1 + static_cast<int>(random() % 30);
            const Function function = randomFunction(random, settings);
            const Points p(random);
            const Column parameters{anyNumber(random), 1, 2};
            Column first;
            for (const auto& [target, name] : instructionSets()) {
                const ForcedInstructionSet forced(target);
                PointEvaluator evaluator(Tape::compile(function), parameters);
                Column values(count);
                evaluator.evaluate(p.x, p.y, p.z, values);
                if (first.empty()) first = values;
                for (std::size_t i = 0; i < count; ++i)
                    QVERIFY2(sameBits(values[i], first[i]),
                             qPrintable(QString::asprintf("%s, round %d: %.17g, not %.17g\n", name, round,
                                                          values[i], first[i]) +
                                        QString::fromStdString(describe(function))));
            }
        }
    }

    /// Few operations and many readers of each value: what StepProgram keeps, computes again and reorders.
    void fullBatchesOfSumsAndProductsAgreeWithTheReference() {
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 3);
            RandomFunctionSettings settings;
            settings.loops = false;
            for (int round = 0; round < 1500; ++round) {
                settings.operations = {Operation::add, Operation::subtract, Operation::multiply,
                                       Operation::square};
                if (round % 3 == 1)
                    settings.operations.insert(
                        settings.operations.end(),
                        {Operation::divide, Operation::minimum, Operation::maximum, Operation::negate,
                         Operation::absolute, Operation::squareRoot});
                if (round % 3 == 2) settings.operations.push_back(Operation::floor);
                settings.nodes = 2 + static_cast<int>(random() % 40);
                const Function function = randomFunction(random, settings);
                const Column parameters{anyNumber(random), anyNumber(random), anyNumber(random)};
                const Points p(random);
                PointEvaluator evaluator(Tape::compile(function), parameters);
                ReferenceEvaluator reference(function);
                for (std::size_t result = 0; result < function.results.size(); ++result) {
                    std::array<double, batchLanes> values;
                    evaluator.evaluate(std::span(p.x).first(batchLanes), std::span(p.y).first(batchLanes),
                                       std::span(p.z).first(batchLanes), values, result);
                    for (std::size_t i = 0; i < batchLanes; ++i) {
                        const double wanted =
                            reference.evaluate({{p.x[i], p.y[i], p.z[i]}}, parameters, result);
                        QVERIFY2(sameBits(values[i], wanted),
                                 qPrintable(QString::asprintf("%s, round %d: %.17g, not %.17g\n", name, round,
                                                              values[i], wanted) +
                                            QString::fromStdString(describe(function))));
                    }
                }
            }
        }
    }

    /// Whole functions run as programs on several vectors at once, parts of them (evaluateChoices)
    /// instruction by instruction.
    void formsByProgramsAreThoseByInstructions() {
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 4);
            std::vector<LaneChoices> choices;
            for (int round = 0; round < 1500; ++round) {
                const Function function = randomSteps(
                    random, round,
                    {Operation::squareRoot, Operation::divide, Operation::floor, Operation::sine});
                const Column parameters{anyNumber(random), anyNumber(random), anyNumber(random)};
                const auto tape = Tape::compile(function);
                const auto prepared = PreparedFunction::of(tape, parameters);
                AffineEvaluator program(prepared), instructions(prepared);
                const RayPieces pieces = randomPieces(random);
                const std::size_t lanes = 9 + random() % (batchLanes - 8);
                const AffineLanes got = program.evaluate(pieces, lanes);
                const AffineLanes wanted = instructions.evaluateChoices(pieces, lanes, nullptr, choices,
                                                                        prepared->global()->decided());
                for (std::size_t i = 0; i < lanes; ++i)
                    QVERIFY2(
                        sameForm(got, wanted, i),
                        qPrintable(QString::asprintf("%s, round %d, lane %zu: %.17g %.17g, not %.17g %.17g\n",
                                                     name, round, i, got.center[i], got.error[i],
                                                     wanted.center[i], wanted.error[i]) +
                                   QString::fromStdString(describe(function))));
            }
        }
    }

    /// Many points at once run as a program, few instruction by instruction, and so do tapes that are not
    /// expected to last.
    void gradientsByProgramsAreThoseByInstructions() {
        constexpr std::size_t few = TapePrograms::fewestLanes - 1;
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 5);
            for (int round = 0; round < 1500; ++round) {
                const Function function = randomSteps(
                    random, round,
                    {Operation::squareRoot, Operation::divide, Operation::floor, Operation::sine});
                const Column parameters{anyNumber(random), anyNumber(random), anyNumber(random)};
                const auto tape = Tape::compile(function);
                const SimplifiedTape simplifiedTape = randomSimplifiedTape(*tape, random);
                const auto prepared = PreparedFunction::of(tape, parameters);
                GradientEvaluator program(prepared), instructions(prepared);
                const Points p(random);
                const std::size_t lanes = few + 1 + random() % (batchLanes - few);
                const auto from = [&](std::size_t first) {
                    return std::array<const double*, 3>{&p.x[first], &p.y[first], &p.z[first]};
                };
                const auto compare = [&, set = name](const GradientLanes& got, const GradientLanes& wanted,
                                                     std::size_t first, std::size_t size) {
                    for (std::size_t i = 0; i < size; ++i)
                        QVERIFY2(
                            std::ranges::equal(entriesOf(got, first + i), entriesOf(wanted, i), sameBits),
                            qPrintable(QString::asprintf("%s, round %d, lane %zu\n", set, round, i) +
                                       QString::fromStdString(describe(function))));
                };
                const auto compareParts = [&](const GradientLanes& got, const auto& evaluatePart) {
                    for (std::size_t first = 0; first < lanes; first += few) {
                        const std::size_t size = std::min(few, lanes - first);
                        compare(got, evaluatePart(from(first), size), first, size);
                    }
                };
                compareParts(program.evaluateLanes(from(0), lanes), [&](const auto& at, std::size_t size) {
                    return instructions.evaluateLanes(at, size);
                });
                const SimplifiedTape& decided = *prepared->global()->decided();
                compareParts(program.evaluateLanes(from(0), lanes, decided),
                             [&](const auto& at, std::size_t size) {
                                 return instructions.evaluateLanes(at, size, decided);
                             });
                if (tape->isUniform(simplifiedTape.result)) continue;
                SimplifiedProgram simplified(*prepared, simplifiedTape, 4);
                for (std::size_t k = 0; k < 3; ++k) {
                    double* argument = simplified.argument(k);
                    std::copy_n(from(0)[k], lanes, argument);
                    std::fill_n(argument + (k + 1) * batchLanes, batchLanes, 1.0);
                }
                runGradientProgram(simplified.workspace, simplified.program, lanes);
                const auto at = [&](std::size_t c) { return simplified.result() + c * batchLanes; };
                compare({at(0), {at(1), at(2), at(3)}},
                        instructions.evaluateLanes(from(0), lanes, simplifiedTape), 0, lanes);
            }
        }
    }

    void tangentsByProgramsAreThoseByInstructions() {
        constexpr std::size_t few = TapePrograms::fewestLanes - 1;
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 6);
            for (int round = 0; round < 1500; ++round) {
                const Function function = randomSteps(
                    random, round,
                    {Operation::squareRoot, Operation::divide, Operation::sine, Operation::cosine});
                const Column parameters{anyNumber(random), anyNumber(random), anyNumber(random)};
                const auto tape = Tape::compile(function);
                const SimplifiedTape simplifiedTape = randomSimplifiedTape(*tape, random);
                const RayPieces pieces = randomPieces(random);
                const std::size_t lanes = few + 1 + random() % (batchLanes - few);
                if (!TaylorEvaluator::covers(*tape)) continue;
                const auto prepared = PreparedFunction::of(tape, parameters);
                TaylorEvaluator program(prepared), instructions(prepared);
                const auto from = [&](std::size_t first) {
                    RayPlaces places{{}, {}, &pieces.start[first], &pieces.length[first]};
                    for (std::size_t k = 0; k < 3; ++k) {
                        places.origin[k] = &pieces.origin[k][first];
                        places.direction[k] = &pieces.direction[k][first];
                    }
                    return places;
                };
                const auto compare = [&, set = name](const TaylorLanes& got, const TaylorLanes& wanted,
                                                     std::size_t first, std::size_t size) {
                    for (std::size_t i = 0; i < size; ++i)
                        QVERIFY2(
                            std::ranges::equal(entriesOf(got, first + i), entriesOf(wanted, i), sameBits),
                            qPrintable(QString::asprintf("%s, round %d, lane %zu\n", set, round, i) +
                                       QString::fromStdString(describe(function))));
                };
                const SimplifiedTape* const decided = prepared->global()->decided();
                for (const SimplifiedTape* of : {static_cast<const SimplifiedTape*>(nullptr), decided}) {
                    if (of != nullptr && tape->isUniform(of->result)) continue;
                    const TaylorLanes whole = program.evaluate(from(0), lanes, of);
                    for (std::size_t first = 0; first < lanes; first += few) {
                        const std::size_t size = std::min(few, lanes - first);
                        compare(whole, instructions.evaluate(from(first), size, of), first, size);
                    }
                }
                if (tape->isUniform(simplifiedTape.result)) continue;
                SimplifiedProgram simplified(*prepared, simplifiedTape, 7);
                for (std::size_t k = 0; k < 3; ++k)
                    std::fill_n(simplified.argument(k) + (k + 1) * batchLanes, batchLanes, 1.0);
                writeTangentArguments(from(0), lanes, simplified.workspace);
                runTangentProgram(simplified.workspace, simplified.program, lanes);
                const auto at = [&](std::size_t c) { return simplified.result() + c * batchLanes; };
                compare({{at(0), {at(1), at(2), at(3)}}, at(4), at(5), at(6)},
                        instructions.evaluate(from(0), lanes, &simplifiedTape), 0, lanes);
            }
        }
    }

    void elementaryFunctionsAgreeWithinTheirError() {
        std::mt19937_64 random(seed + 1);
        for (const Operation operation : operationsWithVectorCode()) {
            FunctionGraph graph;
            std::vector<NodeId> operands;
            for (int k = 0; k < 4; ++k) operands.push_back(graph.variable(k % 3));
            const NodeId root = addOperation(graph, operation, operands, random);
            const auto tape = Tape::compile(finish(std::move(graph), {root}, 3));
            const Points p(random);
            Column first;
            std::vector<ValueAndGradient> firstGradients;
            for (const auto& [target, name] : instructionSets()) {
                const ForcedInstructionSet forced(target);
                Column values(count);
                std::vector<ValueAndGradient> gradients(count);
                PointEvaluator(tape, {}).evaluate(p.x, p.y, p.z, values);
                GradientEvaluator(tape, {}).evaluate(p.x, p.y, p.z, gradients);
                if (first.empty()) {
                    first = values;
                    firstGradients = gradients;
                }
                for (std::size_t i = 0; i < count; ++i) {
                    bool same = goldenError(values[i], first[i]) <= 1e-14;
                    for (int k = 0; k < 3; ++k)
                        same = same &&
                               goldenError(gradients[i].gradient[k], firstGradients[i].gradient[k]) <= 1e-12;
                    QVERIFY2(same, qPrintable(
                                       QString::asprintf("%s: %s at %.17g %.17g %.17g: %.17g, not %.17g",
                                                         name, std::string(isoscope::name(operation)).c_str(),
                                                         p.x[i], p.y[i], p.z[i], values[i], first[i])));
                }
            }
        }
    }

    void formsHoldExactValuesEverywhere() {
        for (const auto& [target, name] : instructionSets()) {
            const ForcedInstructionSet forced(target);
            std::mt19937_64 random(seed + 2);
            RandomFunctionSettings settings;
            settings.loops = false;
            settings.parameters = 0;
            settings.operations = operationsWithVectorCode();
            for (int round = 0; round < 200; ++round) {
                settings.nodes = 1 + static_cast<int>(random() % 10);
                Function function = randomFunction(random, settings);
                function.results.resize(1);
                AffineEvaluator evaluator(Tape::compile(function), {});
                const RayPieces pieces = randomPieces(random);
                std::array<AffineForm, batchLanes> forms;
                evaluator.evaluate(pieces, forms);
                for (std::size_t lane = 0; lane < batchLanes; ++lane) {
                    const double share = uniform(random, 0, 1);
                    bool regular = true;
                    const ExactNumber value =
                        evaluateExactly(function, pointAt(pieces, lane, share), {}, regular);
                    QVERIFY2(!regular || admits(forms[lane], share, value),
                             qPrintable(QString::asprintf("%s, round %d, lane %zu\n", name, round, lane) +
                                        QString::fromStdString(describe(function))));
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(InstructionSetsTest)
#include "instruction_sets_test.moc"

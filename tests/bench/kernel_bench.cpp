// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluators beside hand-written code of the same functions, per batch of 64; `items_per_second` counts
// lanes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/function/graph_builder.h"
#include "tests/bench/bench_formulas-inl.h"
#include "tests/bench/hand_written.h"

using namespace isoscope;
using namespace isoscope::bench;

namespace {

std::shared_ptr<const Tape> tapeOf(BenchFunction function) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    NodeId root = noNode;
    HWY_NAMESPACE::visitFormula(function, [&](auto formula) { root = formula(x, y, z).node(); });
    return Tape::compile(finish(std::move(graph), {root}, 3));
}

std::shared_ptr<const Tape> noiseTape(int generator) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    return Tape::compile(finish(std::move(graph), {noise(x.number(generator), x, y, z).node()}, 3));
}

/// Pieces of rays as a march meets them, and the points at their starts.
struct Inputs {
    RayPieces pieces;
    std::array<std::array<double, batchLanes>, 3> points;

    Inputs() {
        std::mt19937_64 random(1);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        for (std::size_t i = 0; i < batchLanes; ++i) {
            for (int k = 0; k < 3; ++k) {
                pieces.origin[k][i] = uniform(-2, 2);
                pieces.direction[k][i] = uniform(-1, 1);
                points[k][i] = pieces.origin[k][i];
            }
            pieces.length[i] = uniform(0.01, 0.1);
        }
    }
};

const Inputs inputs;

void points(benchmark::State& state, std::shared_ptr<const Tape> tape) {
    PointEvaluator evaluator(tape, {});
    std::array<double, batchLanes> out;
    const std::array<const double*, 3> arguments{inputs.points[0].data(), inputs.points[1].data(),
                                                 inputs.points[2].data()};
    for (auto _ : state) {
        evaluator.evaluate(arguments, batchLanes, out);
        benchmark::DoNotOptimize(out);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batchLanes));
}

void writtenPoints(benchmark::State& state, BenchFunction function) {
    alignas(64) std::array<double, batchLanes> out;
    for (auto _ : state) {
        handWrittenPoints(function, inputs.points[0].data(), inputs.points[1].data(), inputs.points[2].data(),
                          out.data());
        benchmark::DoNotOptimize(out);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batchLanes));
}

void forms(benchmark::State& state, std::shared_ptr<const Tape> tape, std::size_t count) {
    AffineEvaluator evaluator(tape, {});
    for (auto _ : state) benchmark::DoNotOptimize(evaluator.evaluate(inputs.pieces, count));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void writtenForms(benchmark::State& state, BenchFunction function) {
    alignas(64) std::array<double, 3 * batchLanes> out;
    for (auto _ : state) {
        handWrittenForms(function, inputs.pieces, out.data());
        benchmark::DoNotOptimize(out);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batchLanes));
}

void intervals(benchmark::State& state, std::shared_ptr<const Tape> tape) {
    BoxEvaluator evaluator(tape, {});
    BoxLanes boxes;
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < batchLanes; ++i) {
            boxes.low[k][i] = inputs.points[k][i];
            boxes.high[k][i] = inputs.points[k][i] + 0.1;
        }
    std::array<Interval, batchLanes> out;
    for (auto _ : state) {
        evaluator.evaluate(boxes, out);
        benchmark::DoNotOptimize(out);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batchLanes));
}

void gradients(benchmark::State& state, std::shared_ptr<const Tape> tape) {
    GradientEvaluator evaluator(tape, {});
    std::array<ValueAndGradient, batchLanes> out;
    for (auto _ : state) {
        evaluator.evaluate(inputs.points[0], inputs.points[1], inputs.points[2], out);
        benchmark::DoNotOptimize(out);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batchLanes));
}

void registerAll() {
    for (const BenchFunction function : benchFunctions) {
        const std::string called = bench::name(function);
        const auto tape = tapeOf(function);
        benchmark::RegisterBenchmark(("point/" + called + "/tape").c_str(), points, tape);
        benchmark::RegisterBenchmark(("point/" + called + "/written").c_str(), writtenPoints, function);
        benchmark::RegisterBenchmark(("affine/" + called + "/tape").c_str(), forms, tape, batchLanes);
        benchmark::RegisterBenchmark(("affine/" + called + "/written").c_str(), writtenForms, function);
        benchmark::RegisterBenchmark(("affine/" + called + "/tape-8").c_str(), forms, tape, std::size_t{8});
        benchmark::RegisterBenchmark(("interval/" + called + "/tape").c_str(), intervals, tape);
        benchmark::RegisterBenchmark(("gradient/" + called + "/tape").c_str(), gradients, tape);
    }
    for (const int generator : {1, 2, 3}) {
        const std::string called = "noise" + std::to_string(generator);
        const auto tape = noiseTape(generator);
        benchmark::RegisterBenchmark(("point/" + called + "/tape").c_str(), points, tape);
        benchmark::RegisterBenchmark(("affine/" + called + "/tape").c_str(), forms, tape, batchLanes);
        benchmark::RegisterBenchmark(("gradient/" + called + "/tape").c_str(), gradients, tape);
    }
}

/// Both sides must compute the same, or their times mean nothing.
void checkAnswers() {
    for (const BenchFunction function : benchFunctions) {
        PointEvaluator evaluator(tapeOf(function), {});
        alignas(64) std::array<double, batchLanes> written;
        std::array<double, batchLanes> found;
        evaluator.evaluate(inputs.points[0], inputs.points[1], inputs.points[2], found);
        handWrittenPoints(function, inputs.points[0].data(), inputs.points[1].data(), inputs.points[2].data(),
                          written.data());
        AffineEvaluator forms(tapeOf(function), {});
        const AffineLanes lanes = forms.evaluate(inputs.pieces, batchLanes);
        alignas(64) std::array<double, 3 * batchLanes> writtenLanes;
        handWrittenForms(function, inputs.pieces, writtenLanes.data());
        for (std::size_t i = 0; i < batchLanes; ++i) {
            const double margin = 1e-12 * (1 + std::abs(lanes.center[i]));
            if (std::abs(found[i] - written[i]) <= 1e-12 * (1 + std::abs(found[i])) &&
                std::abs(lanes.center[i] - writtenLanes[i]) <= margin &&
                std::abs(lanes.error[i] - writtenLanes[2 * batchLanes + i]) <= margin)
                continue;
            std::fprintf(stderr, "the two codes for %s differ\n", bench::name(function));
            std::exit(1);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    checkAnswers();
    registerAll();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

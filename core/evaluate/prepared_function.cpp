// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/prepared_function.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"

namespace isoscope {

PreparedTape::PreparedTape(const Tape& tape)
    : tape_(tape), cost_(tape), codes_(tape, tape.instructions(), tape.results()) {}

const TapeLinks& PreparedTape::links() const {
    std::call_once(linked_, [&] { links_.emplace(tape_); });
    return *links_;
}

GlobalSimplification::GlobalSimplification(const std::shared_ptr<const Tape>& tape, const TapeLinks& links,
                                           const UniformValues& uniforms, std::span<const SignLevel> levels) {
    IntervalEvaluator everywhere(tape, uniforms);
    // Arguments behind x, y, z are 0.
    const std::array box{Interval::all(), Interval::all(), Interval::all()};
    everywhere.evaluate(box);
    domains_ = OperandDomains(*tape, everywhere);
    approximations_ = approximationsOf(links, everywhere, uniforms, levels);
    for (const TapeApproximation& approximation : approximations_)
        codes_.emplace_back(*tape, approximation.tape.instructions, std::span(&approximation.tape.result, 1));
}

PreparedFunction::PreparedFunction(std::shared_ptr<const Tape> tape,
                                   std::shared_ptr<const PreparedTape> prepared, UniformValues uniforms)
    : tape_(std::move(tape)), prepared_(std::move(prepared)), uniforms_(std::move(uniforms)) {}

PreparedFunction::PreparedFunction(std::shared_ptr<const Tape> tape, std::span<const double> parameters)
    : tape_(std::move(tape)),
      prepared_(std::make_shared<const PreparedTape>(*tape_)),
      uniforms_(*tape_, parameters) {}

std::shared_ptr<const PreparedFunction> PreparedFunction::of(std::shared_ptr<const Tape> tape,
                                                             std::span<const double> parameters) {
    return std::make_shared<const PreparedFunction>(std::move(tape), parameters);
}

std::shared_ptr<const PreparedFunction> PreparedFunction::with(std::span<const double> parameters) const {
    UniformValues uniforms(*tape_, parameters);
    if (uniforms.sameAs(uniforms_)) return shared_from_this();
    return std::shared_ptr<const PreparedFunction>(
        new PreparedFunction(tape_, prepared_, std::move(uniforms)));
}

std::shared_ptr<const GlobalSimplification> PreparedFunction::global() const {
    const auto make = [&] { return std::make_shared<const GlobalSimplification>(tape_, links(), uniforms_); };
    // Loops may keep the thread that makes it for seconds; a stop does not wait for that.
    std::unique_lock lock(globalMutex_, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(10)))
        if (LoopStop::requested()) return make();
    if (global_) return global_;
    auto made = make();
    if (LoopStop::requested()) return made;
    global_ = std::move(made);
    kept_.store(global_.get(), std::memory_order_release);
    return global_;
}

std::shared_ptr<const GlobalSimplification> PreparedFunction::globalFor(double threshold) const {
    const std::shared_ptr<const GlobalSimplification> plain = global();
    const std::vector<std::uint32_t>& numbers = links().whole().levelNumbers;
    const SimplifiedTape* const decided = plain->decided();
    if (decided == nullptr ||
        std::all_of(numbers.begin(), numbers.end(), [](auto number) { return number == 0; }))
        return plain;
    const std::lock_guard lock(signMutex_);
    if (signGlobal_ && signThreshold_ == threshold) return signGlobal_;
    const std::vector<SignLevel> levels = links().levels(uniforms_, threshold);
    auto made = std::make_shared<const GlobalSimplification>(tape_, links(), uniforms_, levels);
    const bool shorter = made->decided()->instructions.size() < decided->instructions.size();
    signGlobal_ = shorter ? std::move(made) : plain;
    signThreshold_ = threshold;
    return signGlobal_;
}

}  // namespace isoscope

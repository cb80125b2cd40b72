// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/prepared_function.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/tape_simplifier.h"

namespace isoscope {

PreparedTape::PreparedTape(const Tape& tape)
    : tape_(tape), cost_(tape), codes_(tape, tape.instructions(), tape.results()) {}

const TapeLinks& PreparedTape::links() const {
    std::call_once(linked_, [&] { links_.emplace(tape_); });
    return *links_;
}

/// One interval evaluation over all of space.
struct GlobalSimplification::Everywhere {
    explicit Everywhere(const PreparedFunction& function) : ranges(function) {
        // Arguments behind x, y, z are 0.
        ranges.evaluate(std::array{Interval::all(), Interval::all(), Interval::all()});
        domains = OperandDomains(*function.tape(), ranges);
    }

    IntervalEvaluator ranges;  ///< of the operands
    OperandDomains domains;
};

GlobalSimplification::GlobalSimplification(const PreparedFunction& function)
    : everywhere_(std::make_shared<const Everywhere>(function)) {
    simplify(function, choicesEverywhere(function.links(), everywhere_->ranges));
}

GlobalSimplification::GlobalSimplification(const PreparedFunction& function,
                                           std::shared_ptr<const Everywhere> everywhere,
                                           std::span<const Choice> choices)
    : everywhere_(std::move(everywhere)) {
    simplify(function, choices);
}

void GlobalSimplification::simplify(const PreparedFunction& function, std::span<const Choice> choices) {
    approximations_ = approximationsOf(function.links(), choices, everywhere_->ranges, function.uniforms());
    for (const TapeApproximation& approximation : approximations_)
        codes_.emplace_back(*function.tape(), approximation.tape->instructions,
                            std::span(&approximation.tape->result, 1));
}

std::shared_ptr<const GlobalSimplification> GlobalSimplification::forSigns(const PreparedFunction& function,
                                                                           double threshold) const {
    const TapeLinks& links = function.links();
    const std::vector<Choice> choices =
        choicesEverywhere(links, everywhere_->ranges, links.levels(function.uniforms(), threshold));
    if (choices == choicesEverywhere(links, everywhere_->ranges)) return nullptr;
    // A few of many instructions are not worth another tape, whose memory has its price.
    constexpr std::size_t worthwhileShare = 64;
    const std::size_t length = decided()->instructions.size();
    if (TapeSimplifier(links).countLeft(choices, 0) + length / worthwhileShare >= length) return nullptr;
    return std::shared_ptr<const GlobalSimplification>(
        new GlobalSimplification(function, everywhere_, choices));
}

const OperandDomains& GlobalSimplification::domains() const { return everywhere_->domains; }

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
    const auto make = [&] { return std::make_shared<const GlobalSimplification>(*this); };
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
    signGlobal_ = plain->forSigns(*this, threshold);
    if (!signGlobal_) signGlobal_ = plain;
    signThreshold_ = threshold;
    return signGlobal_;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
// Included once per instruction set. One interpreter for every number type: the algebra says what a number is
// and what the operations do, the interpreter walks the tape, spreads uniform operands and runs loops.
#if defined(ISOSCOPE_EVALUATE_TAPE_INTERPRETER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOSCOPE_EVALUATE_TAPE_INTERPRETER_INL
#undef ISOSCOPE_EVALUATE_TAPE_INTERPRETER_INL
#else
#define ISOSCOPE_EVALUATE_TAPE_INTERPRETER_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/evaluate/algebra/loop_lanes-inl.h"
#include "core/evaluate/algebra/point_algebra-inl.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/tape_workspace.h"
#include "core/numeric/noise.h"

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {

/// `fullRun`: all batchLanes lanes, a number the compiler can count on.
template <class Algebra, bool fullRun>
class TapeInterpreter {
    using Number = typename Algebra::Number;

  public:
    /// Works on the first `lanes` lanes, rounded up to whole vectors.
    TapeInterpreter(TapeWorkspace& workspace, std::size_t lanes)
        : workspace_(workspace), lanes_((lanes + step() - 1) / step() * step()) {}

    void run() { run(workspace_.tape().instructions()); }
    /// Only some of the tape's instructions.
    void run(std::span<const Instruction> instructions) {
        for (std::size_t k = 0; k < instructions.size(); ++k) {
            const Instruction& instruction = instructions[k];
            if constexpr (requires(Number n, const Algebra a) { a.sineAndCosine(n, n, n); })
                if (k + 1 < instructions.size() && areWaves(instruction, instructions[k + 1])) {
                    executeWaves(instruction, instructions[k + 1]);
                    ++k;
                    continue;
                }
            if constexpr (requires { &Algebra::vectorNoise; })
                if (isVectorNoise(instruction.operation)) {
                    k += executeVectorNoise(instructions.subspan(k)) - 1;
                    continue;
                }
            if constexpr (Algebra::fuses && (fullRun || Algebra::components > 1))
                if (k + 1 < instructions.size() && executePair(instruction, instructions[k + 1])) {
                    ++k;
                    continue;
                }
            algebra_.begin(workspace_, instruction.number);
            execute(instruction);
        }
    }

  private:
    static constexpr std::size_t step() { return hn::MaxLanes(Doubles()); }
    std::size_t lanes() const { return fullRun ? batchLanes : lanes_; }

    // clang-format off
#define ISOSCOPE_UNARY(operation) \
    case Operation::operation: unary(instruction, [algebra = algebra_](auto a) HWY_ATTR { return algebra.operation(a); }); break;
#define ISOSCOPE_BINARY(operation) \
    case Operation::operation: binary(instruction, [algebra = algebra_](auto a, auto b) HWY_ATTR { return algebra.operation(a, b); }); break;
    // clang-format on
    HWY_INLINE void execute(const Instruction& instruction) {
        switch (instruction.operation) {
            ISOSCOPE_SLOPED_OPERATIONS(ISOSCOPE_UNARY, ISOSCOPE_BINARY)
            ISOSCOPE_OTHER_OPERATIONS(ISOSCOPE_UNARY, ISOSCOPE_BINARY)
            case Operation::select3: select3(instruction); break;
            case Operation::select4: select4(instruction); break;
            case Operation::sum:
            case Operation::product: loop(instruction); break;
            default: scalar(instruction); break;
        }
    }
#undef ISOSCOPE_UNARY
#undef ISOSCOPE_BINARY

    /// target[i] = apply(i) for all vectors.
    template <class Operator>
    HWY_INLINE void forEachVector(double* target, Operator apply) {
        for (std::size_t i = 0; i < lanes(); i += step()) Algebra::store(apply(i), target + i);
    }

    template <class Operator>
    HWY_INLINE void unary(const Instruction& instruction, Operator apply) {
        // Uniform only in shortened tapes.
        const double* a = spread(instruction, 0);
        forEachVector(workspace_.slot(instruction.target),
                      [=](std::size_t i) HWY_ATTR { return apply(Algebra::load(a + i)); });
    }

    template <class Operator>
    HWY_INLINE void binary(const Instruction& instruction, Operator apply) {
        const double* a = workspace_.address(instruction.operands[0]);
        const double* b = workspace_.address(instruction.operands[1]);
        double* target = workspace_.slot(instruction.target);
        if (workspace_.isUniform(instruction.operands[1])) {
            // Both are only in shortened tapes.
            a = spread(instruction, 0);
            const auto uniform = Algebra::uniform(*b);
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return apply(Algebra::load(a + i), uniform); });
        } else if (workspace_.isUniform(instruction.operands[0])) {
            const auto uniform = Algebra::uniform(*a);
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return apply(uniform, Algebra::load(b + i)); });
        } else {
            forEachVector(target, [=](std::size_t i)
                                      HWY_ATTR { return apply(Algebra::load(a + i), Algebra::load(b + i)); });
        }
    }

    /// Sine and cosine of one angle, which the compiler puts side by side.
    static HWY_INLINE bool areWaves(const Instruction& first, const Instruction& second) {
        const bool sineFirst = first.operation == Operation::sine;
        if (!sineFirst && first.operation != Operation::cosine) return false;
        if (second.operation != (sineFirst ? Operation::cosine : Operation::sine)) return false;
        const Slot angle = first.operands[0];
        return second.operands[0] == angle && first.target != angle;
    }

    /// Both of them together.
    HWY_NOINLINE void executeWaves(const Instruction& first, const Instruction& second) {
        const bool sineFirst = first.operation == Operation::sine;
        const double* a = spread(first, 0);
        double* sines = workspace_.slot(sineFirst ? first.target : second.target);
        double* cosines = workspace_.slot(sineFirst ? second.target : first.target);
        for (std::size_t i = 0; i < lanes(); i += step()) {
            Number sine, cosine;
            algebra_.sineAndCosine(Algebra::load(a + i), sine, cosine);
            Algebra::store(sine, sines + i);
            Algebra::store(cosine, cosines + i);
        }
    }

    /// Components of the vector noise at the same places, which the compiler puts side by side, together.
    /// Returns how many of the instructions these were; the first has to be one.
    std::size_t executeVectorNoise(std::span<const Instruction> instructions) {
        const Instruction& first = instructions.front();
        std::array<int, 3> components{};
        std::array<double*, 3> targets{};
        std::size_t count = 0;
        for (const Instruction& next : instructions.first(std::min(instructions.size(), targets.size()))) {
            if (!isVectorNoise(next.operation) || next.operands != first.operands) break;
            components[count] = noiseComponent(next.operation);
            targets[count++] = workspace_.slot(next.target);
            // Who comes behind takes another place then.
            if (std::ranges::count(first.operands, next.target) > 0) break;
        }
        Algebra::vectorNoise(std::span(components).first(count),
                             {spread(first, 0), spread(first, 1), spread(first, 2)}, targets, lanes());
        return count;
    }

    /// Sums and products whose value goes into the next sum, product or square and nowhere else stay in
    /// registers: storing them costs as much as computing them. False when the instructions are no such pair.
    HWY_INLINE bool executePair(const Instruction& first, const Instruction& second) {
        // Written over by the second, the value has no other reader.
        if (first.target != second.target || !isPlain(first.operation) || !isPlain(second.operation))
            return false;
        const bool left = second.operands[0] == first.target, right = second.operands[1] == first.target;
        const bool squared = second.operation == Operation::square;
        if (squared ? !left : left == right) return false;
        const bool uniform0 = workspace_.isUniform(first.operands[0]);
        // Both are only in shortened tapes.
        if (uniform0 && (first.operation != Operation::multiply || workspace_.isUniform(first.operands[1])))
            return false;
        runPair(first, second);
        return true;
    }

    static bool isPlain(Operation operation) {
        return operation == Operation::add || operation == Operation::subtract ||
               operation == Operation::multiply || operation == Operation::square;
    }

    HWY_INLINE void runPair(const Instruction& first, const Instruction& second) {
        const double* a = workspace_.address(first.operands[0]);
        const double* b = workspace_.address(first.operands[1]);
        const Algebra algebra = algebra_;
        const auto both = [=](auto operation) HWY_ATTR {
            return [=](std::size_t i)
                       HWY_ATTR { return operation(Algebra::load(a + i), Algebra::load(b + i)); };
        };
        if (first.operation == Operation::square)
            return goOn(second, [=](std::size_t i) HWY_ATTR { return algebra.square(Algebra::load(a + i)); });
        if (workspace_.isUniform(first.operands[0]) || workspace_.isUniform(first.operands[1])) {
            const bool reversed = workspace_.isUniform(first.operands[0]);
            const double* lanes = reversed ? b : a;
            const double value = reversed ? *a : *b;
            if (first.operation == Operation::multiply) {
                const auto factor = Algebra::uniform(value);
                return goOn(second, [=](std::size_t i) HWY_ATTR {
                    return algebra.multiply(Algebra::load(lanes + i), factor);
                });
            }
            const auto term = Algebra::uniform(first.operation == Operation::add ? value : -value);
            return goOn(second,
                        [=](std::size_t i) HWY_ATTR { return algebra.add(Algebra::load(lanes + i), term); });
        }
        if (first.operation == Operation::multiply)
            return goOn(second, both([=](auto p, auto q) HWY_ATTR { return algebra.multiply(p, q); }));
        if (first.operation == Operation::add)
            return goOn(second, both([=](auto p, auto q) HWY_ATTR { return algebra.add(p, q); }));
        return goOn(second, both([=](auto p, auto q) HWY_ATTR { return algebra.subtract(p, q); }));
    }

    /// The second instruction of a pair on the values begin(i) of the first. The order of factors matters to
    /// the last bit of an error.
    template <class Begin>
    HWY_INLINE void goOn(const Instruction& second, Begin begin) {
        const Algebra algebra = algebra_;
        double* target = workspace_.slot(second.target);
        if (second.operation == Operation::square)
            return forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.square(begin(i)); });
        const bool left = second.operands[0] == second.target;
        const Slot other = second.operands[left ? 1 : 0];
        const double* r = workspace_.address(other);
        if (workspace_.isUniform(other)) {
            const auto c = Algebra::uniform(*r);
            if (second.operation == Operation::multiply)
                forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.multiply(begin(i), c); });
            else if (second.operation == Operation::add)
                forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.add(begin(i), c); });
            else if (left)
                forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.subtract(begin(i), c); });
            else
                forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.subtract(c, begin(i)); });
            return;
        }
        const auto lanes = [=](std::size_t i) HWY_ATTR { return Algebra::load(r + i); };
        if (second.operation == Operation::add)
            forEachVector(target, [=](std::size_t i) HWY_ATTR { return algebra.add(begin(i), lanes(i)); });
        else if (second.operation == Operation::multiply && left)
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return algebra.multiply(begin(i), lanes(i)); });
        else if (second.operation == Operation::multiply)
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return algebra.multiply(lanes(i), begin(i)); });
        else if (left)
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return algebra.subtract(begin(i), lanes(i)); });
        else
            forEachVector(target,
                          [=](std::size_t i) HWY_ATTR { return algebra.subtract(lanes(i), begin(i)); });
    }

    /// The lanes of operand `k`, a uniform one spread out.
    const double* spread(const Instruction& instruction, std::size_t k) {
        const Slot slot = instruction.operands[k];
        if (!workspace_.isUniform(slot)) return workspace_.address(slot);
        double* room = workspace_.spread(k);
        if (workspace_.isSpread(k, slot, lanes())) return room;
        const Number value = Algebra::widen(Algebra::uniform(workspace_.uniform(slot)));
        for (std::size_t i = 0; i < lanes(); i += step()) Algebra::store(value, room + i);
        return room;
    }

    void select3(const Instruction& instruction) {
        const double* a = spread(instruction, 0);
        const double* b = spread(instruction, 1);
        const double* c = spread(instruction, 2);
        double* target = workspace_.slot(instruction.target);
        for (std::size_t i = 0; i < lanes(); i += step())
            Algebra::store(algebra_.select3(Algebra::load(a + i), Algebra::load(b + i), Algebra::load(c + i)),
                           target + i);
    }

    void select4(const Instruction& instruction) {
        const double* a = spread(instruction, 0);
        const double* b = spread(instruction, 1);
        const double* c = spread(instruction, 2);
        const double* d = spread(instruction, 3);
        double* target = workspace_.slot(instruction.target);
        for (std::size_t i = 0; i < lanes(); i += step())
            Algebra::store(algebra_.select4(Algebra::load(a + i), Algebra::load(b + i), Algebra::load(c + i),
                                            Algebra::load(d + i)),
                           target + i);
    }

    /// Noise and crackle.
    void scalar(const Instruction& instruction) {
        if constexpr (requires { &Algebra::noise; })
            if (instruction.operation == Operation::noise && isOneNumber(instruction.operands[0])) {
                const int generator = noiseGeneratorNumber(workspace_.uniform(instruction.operands[0]));
                const bool ground = generator != 3 && isZero(instruction.operands[2]);
                return Algebra::noise(generator,
                                      {spread(instruction, 1), ground ? nullptr : spread(instruction, 2),
                                       spread(instruction, 3)},
                                      lanes(), workspace_.slot(instruction.target));
            }
        std::array<const double*, 4> operands{};
        for (std::size_t k = 0; k < instruction.operandCount; ++k) operands[k] = spread(instruction, k);
        const CrackleSettings* crackle = instruction.operation == Operation::crackle
                                             ? &workspace_.tape().crackle(instruction.index)
                                             : nullptr;
        algebra_.scalarOperation(instruction, crackle, operands, workspace_.slot(instruction.target),
                                 lanes());
    }

    /// Whether a slot has the same number in all lanes. What is none may be something else to an algebra.
    bool isOneNumber(Slot slot) const {
        return workspace_.isUniform(slot) && std::isfinite(workspace_.uniform(slot));
    }

    bool isZero(Slot slot) const { return workspace_.isUniform(slot) && workspace_.uniform(slot) == 0; }

    /// Copies a number of any components, uniform ones spread out.
    void copyNumber(Slot from, double* to) {
        if (workspace_.isUniform(from)) {
            const Number value = Algebra::widen(Algebra::uniform(workspace_.uniform(from)));
            for (std::size_t i = 0; i < lanes(); i += step()) Algebra::store(value, to + i);
        } else {
            const double* lane = workspace_.address(from);
            for (std::size_t i = 0; i < lanes(); i += step()) Algebra::store(Algebra::load(lane + i), to + i);
        }
    }

    void passCaptured(const Instruction& instruction, TapeWorkspace& body) {
        const std::vector<Slot>& captured = workspace_.tape().loop(instruction.index).captured;
        for (std::size_t k = 0; k < captured.size(); ++k)
            copyNumber(captured[k], body.ownArgument(static_cast<int>(k) + 1));
    }

    /// Every lane has bounds of its own; the body runs on all lanes until the last of them is through.
    void loop(const Instruction& instruction) {
        TapeWorkspace& body = workspace_.loop(instruction.index);
        passCaptured(instruction, body);
        double* variable = body.ownArgument(0);
        copyNumber(instruction.operands[0], variable);
        const double* last = spread(instruction, 1);

        LoopLanes<Algebra> state(instruction.operation == Operation::sum);
        double* total = workspace_.slot(instruction.target);
        state.start(workspace_, body, variable, last, lanes());
        for (std::size_t i = 0; i < lanes(); i += step()) Algebra::store(state.neutral(i), total + i);
        while (state.left() > 0 && !LoopStop::requested()) {
            TapeInterpreter(body, lanes_).run();
            const Slot result = body.tape().results()[0];
            const bool uniformTerm = body.isUniform(result);
            const double* term = body.address(result);
            for (std::size_t i = 0; i < lanes(); i += step()) {
                const Mask running = state.running(i);
                const Number value =
                    uniformTerm ? Algebra::widen(Algebra::uniform(*term)) : Algebra::load(term + i);
                const Number before = Algebra::load(total + i);
                const Number after =
                    state.isSum() ? algebra_.add(before, value) : algebra_.multiply(before, value);
                Algebra::store(Algebra::choose(running, after, before), total + i);
                const Number now = Algebra::load(variable + i);
                Algebra::store(Algebra::choose(running, Algebra::increment(now), now), variable + i);
            }
            state.advance(variable, last, lanes());
        }
    }

    TapeWorkspace& workspace_;
    std::size_t lanes_;
    Algebra algebra_;
};

}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

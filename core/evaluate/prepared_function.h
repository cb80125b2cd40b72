// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/steps/step_code.h"
#include "core/evaluate/tape/operand_domains.h"
#include "core/evaluate/tape/tape.h"
#include "core/evaluate/tape/tape_approximation.h"
#include "core/evaluate/tape/tape_cost.h"
#include "core/evaluate/tape/tape_links.h"
#include "core/evaluate/tape/uniform_values.h"

namespace isoscope {

/// What is made once for a tape, whatever the parameters: its cost, its links and its code. Parts that cost
/// something are made when they are first asked for. Immutable for its users, and shared by threads.
class PreparedTape {
  public:
    /// The tape must outlive it.
    explicit PreparedTape(const Tape& tape);

    /// What enclosures of the function cost.
    const TapeCost& cost() const { return cost_; }
    /// For TapeSimplifier. The tape must have a result.
    const TapeLinks& links() const;
    /// The code of the whole tape.
    const StepCode& code(StepNumberKind numbers) const { return codes_.of(numbers); }

  private:
    const Tape& tape_;
    TapeCost cost_;
    mutable std::once_flag linked_;
    mutable std::optional<TapeLinks> links_;
    StepCodes codes_;
};

class PreparedFunction;

/// What one interval evaluation over all of space says about a function: what operands can be at all, and
/// approximations without what is decided or next to nothing everywhere. Immutable.
class GlobalSimplification {
  public:
    /// The function must outlive it.
    explicit GlobalSimplification(const PreparedFunction& function);
    /// The same where nothing but the sign of the function minus a threshold counts (choicesEverywhere). Null
    /// where that makes the tape hardly shorter.
    std::shared_ptr<const GlobalSimplification> forSigns(const PreparedFunction& function,
                                                         double threshold) const;

    /// For the workspaces of forms.
    const OperandDomains& domains() const;
    /// As approximationsOf() has them; empty for tapes with loops.
    std::span<const TapeApproximation> approximations() const { return approximations_; }
    /// The first of them: the tape without choices that are the same everywhere; null for the tape as it is.
    const SimplifiedTape* decided() const {
        return approximations_.empty() ? nullptr : approximations_[0].tape.get();
    }
    /// The code of an approximation, by its number.
    const StepCode& code(std::size_t approximation, StepNumberKind numbers) const {
        return codes_[approximation].of(numbers);
    }

  private:
    struct Everywhere;

    GlobalSimplification(const PreparedFunction& function, std::shared_ptr<const Everywhere> everywhere,
                         std::span<const Choice> choices);
    void simplify(const PreparedFunction& function, std::span<const Choice> choices);

    std::shared_ptr<const Everywhere> everywhere_;  ///< also of the one for signs
    std::vector<TapeApproximation> approximations_;
    std::deque<StepCodes> codes_;  ///< of each
};

/// A function made ready for its evaluators: a tape with values of its parameters, and all that can be found
/// out once for both. Immutable for its users; threads and panels share one. What costs something is made
/// when it is first asked for. Its memory is linear in the tape, mostApproximations times at most.
class PreparedFunction : public std::enable_shared_from_this<PreparedFunction> {
  public:
    /// Missing parameters count as 0.
    PreparedFunction(std::shared_ptr<const Tape> tape, std::span<const double> parameters);

    /// The same as a shared object.
    static std::shared_ptr<const PreparedFunction> of(std::shared_ptr<const Tape> tape,
                                                      std::span<const double> parameters);
    /// The function for other values of the parameters, which shares what does not depend on them: this very
    /// object where none of them changes the function. Only for shared objects.
    std::shared_ptr<const PreparedFunction> with(std::span<const double> parameters) const;

    /// What it was made from, the values as those of the uniform slots.
    const std::shared_ptr<const Tape>& tape() const { return tape_; }
    const UniformValues& uniforms() const { return uniforms_; }
    /// As PreparedTape has them.
    const TapeCost& cost() const { return prepared_->cost(); }
    const TapeLinks& links() const { return prepared_->links(); }
    /// The code of the whole tape.
    const StepCode& code(StepNumberKind numbers) const { return prepared_->code(numbers); }

    /// What is known over all of space. It is kept but when the caller's loops are to end (LoopStop): then
    /// its bounds are wide, and it is for the caller alone.
    std::shared_ptr<const GlobalSimplification> global() const;
    /// The same where nothing but the sign of the function minus a threshold counts: what cannot change it is
    /// left out. Kept for the last threshold that was asked for; global() itself where that is no shorter.
    std::shared_ptr<const GlobalSimplification> globalFor(double threshold) const;
    /// The first if it is kept already, else null.
    const GlobalSimplification* keptGlobal() const { return kept_.load(std::memory_order_acquire); }

  private:
    PreparedFunction(std::shared_ptr<const Tape> tape, std::shared_ptr<const PreparedTape> prepared,
                     UniformValues uniforms);

    std::shared_ptr<const Tape> tape_;
    std::shared_ptr<const PreparedTape> prepared_;
    UniformValues uniforms_;
    mutable std::timed_mutex globalMutex_;
    mutable std::shared_ptr<const GlobalSimplification> global_;
    mutable std::atomic<const GlobalSimplification*> kept_ =
        nullptr;  ///< global_, for readers without a lock
    mutable std::mutex signMutex_;
    mutable double signThreshold_ = 0;
    mutable std::shared_ptr<const GlobalSimplification> signGlobal_;  ///< for that threshold
};

}  // namespace isoscope

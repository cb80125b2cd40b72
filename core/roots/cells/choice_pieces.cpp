// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/choice_pieces.h"

#include <bit>

#include "core/evaluate/prepared_function.h"
#include "core/roots/certified/form_sign.h"

namespace isoscope {

ChoicePieces::ChoicePieces(const PreparedFunction& function, const RootSettings& settings,
                           AffineEvaluator& forms)
    : settings_(settings),
      forms_(forms),
      simplifier_(function.links()),
      levels_(function.links().levels(function.uniforms(), settings.threshold)),
      choiceCount_(simplifier_.choiceCount()) {}

void ChoicePieces::setBase(const SimplifiedTape* base) {
    base_ = base;
    simplifier_.setBase(base);
}

void ChoicePieces::place(const LineBundle& bundle, const DepthRange& range, std::size_t lane) {
    bundle.place(lane, pieces_, spread_);
    pieces_.start[lane] = range.near;
    pieces_.length[lane] = range.far - range.near;
}

void ChoicePieces::enclose(std::size_t count) {
    const SignStakes stakes{levels_, simplifier_.levelNumbers()};
    const SignRule rule{settings_.threshold, settings_.positivePolarity};
    const AffineLanes found = forms_.evaluateChoices(pieces_, count, &spread_, choices_, base_, &stakes);
    for (std::size_t lane = 0; lane < count; ++lane)
        signs_[lane] = formSign(found.center[lane], found.slope[lane], found.error[lane], rule);
}

bool ChoicePieces::mostDecided(std::size_t count) const {
    std::size_t decided = 0;
    for (const LaneChoices& choice : choices_)
        decided += static_cast<std::size_t>(std::popcount(choice.first | choice.second));
    // Choices that the base leaves out are decided.
    decided += (choiceCount_ - choices_.size()) * count;
    return 2 * decided > choiceCount_ * count;
}

void ChoicePieces::simplify(std::uint64_t lanes, SimplifiedTape& simplifiedTape) {
    simplifier_.simplify(choices_, lanes, 0, simplifiedTape);
}

}  // namespace isoscope

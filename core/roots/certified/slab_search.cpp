// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/slab_search.h"

#include <algorithm>
#include <bit>

#include "core/evaluate/prepared_function.h"
#include "core/roots/certified/form_sign.h"
#include "core/roots/certified/line_bundle.h"

namespace isoscope {

namespace {

/// The tapes that are left have to be shorter than the whole one by this factor.
constexpr std::size_t worthwhileShare = 2;

}  // namespace

SlabSearch::SlabSearch(const PreparedFunction& function, const SearchTools& tools)
    : tools_(tools),
      tapeLength_(function.tape()->instructions().size()),
      simplifier_(function.links()),
      choiceCount_(simplifier_.choiceCount()),
      worthwhile_(simplifier_.choiceCount() >= fewestChoices &&
                  worthwhileShare * function.links().leastLength() < tapeLength_),
      lanes_(tools) {}

bool SlabSearch::pays(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted) {
    common_ = nullptr;
    simplifier_.setBase(nullptr);
    if (enclose(queries, wanted, 0, queries.size(), 0)) {
        enclosePieces(slabs);
        takeCommon();
        // Depth ranges leave out still more.
        if (worthwhileShare * commonTape_.instructions.size() < tapeLength_) return true;
        if (becomesShort()) return true;
    }
    std::size_t first = 0;
    while (first < queries.size() && !enclose(queries, wanted, first, tileLines, 0)) first += tileLines;
    return first < queries.size() && becomesShort();
}

AffineLanes SlabSearch::enclosePieces(std::size_t count) {
    const SignStakes signs{tools_.settings.threshold, simplifier_.dependences()};
    return tools_.forms.evaluateChoices(pieces_, count, &spread_, choices_, common_, &signs);
}

/// Whether the tape becomes short in the depth ranges of tile 0.
bool SlabSearch::becomesShort() {
    enclosePieces(slabs);
    std::size_t left = 0;
    for (std::size_t slab = 0; slab < slabs; ++slab) {
        simplify(0, slab);
        left += simplifiedTape_.instructions.size();
    }
    return worthwhileShare * left < slabs * tapeLength_;
}

/// Leaves out what is decided alike in all depth ranges of tile 0.
void SlabSearch::takeCommon() {
    simplifier_.simplify(choices_, (std::uint64_t(1) << slabs) - 1, 0, commonTape_);
    common_ = &commonTape_;
    simplifier_.setBase(common_);
}

/// Places the depth ranges of tile number `tile` of a batch, which has up to `count` lines from `first` on.
/// False where they are no bundle.
bool SlabSearch::enclose(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                         std::size_t first, std::size_t count, std::size_t tile) {
    const std::size_t begin = std::min(first, queries.size());
    const std::size_t end = std::min(begin + count, queries.size());
    const auto bundle =
        LineBundle::around(queries.subspan(begin, end - begin), wanted.subspan(begin, end - begin));
    tiles_[tile] = {begin, end};
    if (!bundle) return false;
    tiles_[tile] = {begin, end, true, bundle->near, bundle->far};
    for (std::size_t slab = 0; slab < slabs; ++slab) {
        const std::size_t lane = tile * slabs + slab;
        bundle->place(lane, pieces_, spread_);
        pieces_.start[lane] = slab == 0 ? bundle->near : this->end(tile, slab - 1);
        pieces_.length[lane] = this->end(tile, slab) - pieces_.start[lane];
    }
    return true;
}

bool SlabSearch::begin(std::span<const LineQuery> queries, std::span<const std::uint8_t> wanted,
                       std::size_t first) {
    std::size_t used = 0;
    for (std::size_t tile = 0; tile < tilesAtOnce; ++tile)
        if (enclose(queries, wanted, first + tile * tileLines, tileLines, tile)) used = (tile + 1) * slabs;
    if (used == 0) return false;
    const AffineLanes forms = enclosePieces(used);
    const SignRule rule{tools_.settings.threshold, tools_.settings.positivePolarity};
    for (std::size_t lane = 0; lane < used; ++lane)
        signs_[lane] = formSign(forms.center[lane], forms.slope[lane], forms.error[lane], rule);
    return mostDecided(used);
}

bool SlabSearch::mostDecided(std::size_t lanes) const {
    std::size_t decided = 0;
    for (const LaneChoices& choice : choices_)
        decided += static_cast<std::size_t>(std::popcount(choice.first | choice.second));
    // Choices that were left out before are decided.
    decided += (choiceCount_ - choices_.size()) * lanes;
    return 2 * decided > choiceCount_ * lanes;
}

double SlabSearch::end(std::size_t tile, std::size_t slab) const {
    const Tile& of = tiles_[tile];
    if (slab + 1 == slabs) return of.far;
    return of.near + (of.far - of.near) * static_cast<double>(slab + 1) / slabs;
}

CertainStart SlabSearch::certainStart(std::size_t tile) const {
    const double* signs = &signs_[tile * slabs];
    if (!tiles_[tile].enclosed) return {};
    std::size_t clear = 0;
    while (clear < slabs && signs[clear] == signs[0]) ++clear;
    if (signs[0] == 0) return {tiles_[tile].near, 0, 0};
    const double start = end(tile, clear - 1);
    return {start, signs[0], (tiles_[tile].far - tiles_[tile].near) / slabs};
}

void SlabSearch::noteStarts(CertainStarts& starts) const {
    for (std::size_t tile = 0; tile < tilesAtOnce; ++tile) {
        if (!tiles_[tile].enclosed) continue;
        starts.set(tiles_[tile].first, tiles_[tile].end - tiles_[tile].first, certainStart(tile));
    }
}

void SlabSearch::simplify(std::size_t tile, std::size_t slab) {
    simplifier_.simplify(choices_, std::uint64_t(1) << (tile * slabs + slab), 0, simplifiedTape_);
}

}  // namespace isoscope

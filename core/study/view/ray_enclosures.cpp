// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/ray_enclosures.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/evaluate/affine_evaluator.h"

namespace isoscope {

namespace {

constexpr double finestShare = 1.0 / 4096;

class RayEncloser {
  public:
    RayEncloser(const std::shared_ptr<const PreparedFunction>& function, const RootSettings& settings,
                const LineQuery& line)
        : evaluator_(function), settings_(settings) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            pieces_.origin[axis][0] = line.origin[static_cast<int>(axis)];
            pieces_.direction[axis][0] = line.direction[static_cast<int>(axis)];
        }
    }

    RayEnclosure enclose(double begin, double end) {
        pieces_.start[0] = begin;
        pieces_.length[0] = end - begin;
        AffineForm form;
        evaluator_.evaluate(pieces_, std::span(&form, 1));
        const double polarity = settings_.positivePolarity ? -1 : 1;
        const double middle = polarity * (form.a - settings_.threshold), slope = polarity * form.b;
        return {begin,
                end,
                middle - slope - form.e,
                middle - slope + form.e,
                middle + slope - form.e,
                middle + slope + form.e};
    }

  private:
    AffineEvaluator evaluator_;
    const RootSettings& settings_;
    RayPieces pieces_;
};

}  // namespace

int RayEnclosure::sign() const {
    if (std::min(lowAtBegin, lowAtEnd) > 0) return 1;
    return std::max(highAtBegin, highAtEnd) < 0 ? -1 : 0;
}

std::vector<RayEnclosure> encloseRay(const std::shared_ptr<const PreparedFunction>& function,
                                     const RootSettings& settings, const LineQuery& line, std::size_t most) {
    std::vector<RayEnclosure> done;
    const double length = line.far - line.near;
    if (!(length > 0) || !std::isfinite(length) || most == 0) return done;
    const double finest = std::max(settings.accuracy, length * finestShare);
    RayEncloser encloser(function, settings, line);
    // The longest first, so that a limit leaves no part of the line without an enclosure.
    std::deque<RayEnclosure> undecided{encloser.enclose(line.near, line.far)};
    while (!undecided.empty()) {
        const RayEnclosure piece = undecided.front();
        undecided.pop_front();
        const double middle = (piece.begin + piece.end) / 2;
        const bool divisible = piece.end - piece.begin > finest && piece.begin < middle && middle < piece.end;
        if (piece.sign() != 0 || !divisible || done.size() + undecided.size() + 2 > most) {
            done.push_back(piece);
            continue;
        }
        undecided.push_back(encloser.enclose(piece.begin, middle));
        undecided.push_back(encloser.enclose(middle, piece.end));
    }
    std::sort(done.begin(), done.end(),
              [](const RayEnclosure& a, const RayEnclosure& b) { return a.begin < b.begin; });
    return done;
}

}  // namespace isoscope

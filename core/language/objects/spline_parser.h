// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/language/expressions/operand.h"
#include "core/language/expressions/spline.h"
#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// `spline { ... }` and the calls of declared splines.
class SplineParser {
  public:
    explicit SplineParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block; the word `spline` has been read. Null after a mistake, which has been reported.
    std::shared_ptr<const Spline> parse();
    /// `(place)` or `(place, type)` behind the name of a spline.
    Operand call(const std::shared_ptr<const Spline>& spline);

  private:
    std::optional<SplineType> acceptType();
    bool parsePoint();

    TokenStream& tokens_;
    std::vector<Spline::Point> points_;
    int components_ = 0;
};

}  // namespace isoscope

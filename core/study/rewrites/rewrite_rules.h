// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/study/rewrites/formula_tree.h"

namespace isoscope {

/// What a rewrite is for.
enum class RewriteKind : std::uint8_t {
    power,         ///< a product of equal factors as pow, or the other way round, whichever is quicker
    root,          ///< pow(A, 0.5) as sqrt(A)
    squared,       ///< sqrt(A) - B as A - B*B: the same surface without the infinite slope where A is 0
    cancellation,  ///< a difference of large numbers as a product, a quotient or a sine
    overflow,      ///< sqrt(A*A + B*B) with A and B divided by a power of 2 first
    angle,         ///< cos and sin of n atan2(B, A) as a quotient: no seam of atan2
    common,        ///< what is computed more than once as an argument of a function of its own
};

/// For output: "power", "root" and so on.
std::string_view name(RewriteKind kind);

/// What a rewrite takes for granted, to be proven over the container: `formula` is at least 0 there, or
/// `positive`: greater than 0.
struct RewriteCondition {
    std::string formula;
    bool positive = false;
};

/// A rewrite by its form alone: what follows from algebra where its conditions hold.
struct RewriteCandidate {
    RewriteKind kind = RewriteKind::power;
    SourceRange range;        ///< of the text, what goes
    std::string replacement;  ///< what stands there then
    std::string before;       ///< of `replacement`, what has to stand before the statement of the function
    std::string identity;     ///< the law, for a person: "A*A = pow(A, 2)"
    std::vector<RewriteCondition> conditions;
    double saved = 0;       ///< nanoseconds of POV-Ray for one evaluation; below 0: slower
    bool signOnly = false;  ///< the values differ, but are 0 at the same places and have the same sign
};

/// What the rules ask for beside the formula.
struct RewriteContext {
    std::string_view text;               ///< the whole text
    std::vector<std::string> arguments;  ///< of the function: x, y, z
    bool isWhole = true;                 ///< the surface is where this formula is 0
    std::string freeName = "parts";      ///< no word of the text
};

/// All that the rules find in a formula, from its beginning to its end; at most `most`.
std::vector<RewriteCandidate> rewriteCandidates(const FormulaPointer& formula, const RewriteContext& context,
                                                std::size_t most = 64);

}  // namespace isoscope

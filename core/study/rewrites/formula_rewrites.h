// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/language/parse.h"
#include "core/study/health/function_health.h"
#include "core/study/rewrites/rewrite_rules.h"

namespace isoscope {

/// How sure it is that a rewrite shows the same.
enum class RewriteProof : std::uint8_t {
    same,      ///< the function computes the same, operation by operation
    identity,  ///< by a law of algebra, whose conditions enclosures prove over the whole container
    measured,  ///< by that law, whose conditions are not proven: what the sampled points say
};
/// For output: "same", "identity", "measured".
std::string_view name(RewriteProof proof);

/// Another way to write a part of a formula that is quicker or loses less, with what was found out about it.
struct FormulaRewrite {
    RewriteKind kind = RewriteKind::power;
    QuickFix fix;          ///< of the user's own text; every other character is kept
    std::string identity;  ///< the law
    RewriteProof proof = RewriteProof::measured;
    bool conditional = false;      ///< the law has conditions, which `proof` is about
    std::size_t points = 0;        ///< where both functions were evaluated
    double largestDifference = 0;  ///< of their values there; NaN where only the signs have to agree
    std::size_t mended = 0;        ///< of these points, where only the new one has a finite value
    double nanoseconds[2]{0, 0};   ///< of one evaluation by POV-Ray, before and after; estimated
    double off[2]{0, 0};           ///< how far rounding moves the surface, before and after
    double steepest[2]{0, 0};      ///< largest gradient at these points, before and after
};

/// What it does and how sure that is, in a few sentences.
std::string describe(const FormulaRewrite& rewrite);

/// The rewrites that pay for isosurface number `isosurface`: in its function, and in the functions of the
/// user's own text that it calls. Each changed text is read again, and both functions compared at some 4000
/// points of the container and of the surface; one that changes any isosurface of the scene by more than
/// rounding is left out. Those that only differ in size, or cost more than they save, are left out, too. In
/// the order of the text; none after a stop, or when the text has errors.
std::vector<FormulaRewrite> formulaRewrites(const ParseResult& parsed, std::size_t isosurface,
                                            const std::function<void(double)>& progress = {},
                                            std::stop_token stop = {});

/// Whether rewrites of this kind are made against that ailment.
bool helps(RewriteKind kind, Ailment ailment);

/// The text after the rewrite.
std::string rewritten(const ParseResult& parsed, const FormulaRewrite& rewrite);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rewrites/formula_rewrites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/study/accuracy/povray_time.h"
#include "core/study/gradient/function_likeness.h"
#include "core/study/gradient/gradient_domain.h"
#include "core/study/gradient/spread_points.h"
#include "core/study/rewrites/function_texts.h"
#include "core/study/shape/surface_points.h"
#include "core/text/number_format.h"
#include "core/text/text_change.h"

namespace isoscope {

namespace {

constexpr std::size_t spreadCount = 4000, surfaceCount = 400;
constexpr int raysAlong = 14;
/// Evaluations over boxes for one condition.
constexpr std::size_t conditionBoxes = 20'000;
constexpr std::size_t mostCandidates = 24;
/// Values may differ by this part of the largest of them.
constexpr double rounding = 1e-9;
/// A rewrite for time saves this part of it, one for digits makes the error so many times less.
constexpr double worthwhileShare = 0.05, worthwhileFactor = 4;
/// Parts of accuracy that the surface has to be off before digits are worth a rewrite.
constexpr double toleratedShare = 0.01;
/// Slopes above this count as infinite.
constexpr double endless = 1e6;

/// What is known of one function at the points.
struct Sampled {
    std::vector<ValueAndGradient> values;
    double steepest = 0;
    double off = 0;
    bool jumps = false;
};

/// An isosurface of the text as it is, and the points where rewrites of it are tried.
struct Subject {
    std::shared_ptr<const Isosurface> shape;
    std::vector<double> parameters;
    GradientDomain domain;
    SpreadPoints points;
    std::vector<glm::dvec3> surface;
    Sampled sampled;

    Subject(std::shared_ptr<const Isosurface> isosurface, std::vector<double> table,
            const std::stop_token& stop)
        : shape(std::move(isosurface)), parameters(std::move(table)), domain(shape->settings().container) {
        if (domain.empty()) return;
        points = spreadPoints(domain, spreadCount);
        surface = surfacePoints(*shape, parameters, raysAlong, surfaceCount, stop);
        for (const glm::dvec3& point : surface) points.add(point);
        sampled = sample(*shape, parameters);
    }

    Sampled sample(const Isosurface& other, std::span<const double> table) const {
        Sampled answer;
        const auto function = other.prepared(table);
        answer.values.resize(points.x.size());
        GradientEvaluator(function).evaluate(points.x, points.y, points.z, answer.values);
        for (const ValueAndGradient& one : answer.values)
            answer.steepest =
                std::max(answer.steepest, std::hypot(one.gradient[0], one.gradient[1], one.gradient[2]));
        IntervalEvaluator intervals(*function);
        for (std::size_t i = 0; i < surface.size(); ++i) {
            const auto& slope = answer.values[points.x.size() - surface.size() + i].gradient;
            const double length = std::hypot(slope[0], slope[1], slope[2]);
            const double off =
                intervals.evaluate(GradientBox{surface[i], surface[i]}.intervals()).width() / length;
            if (std::isfinite(off)) answer.off = std::max(answer.off, off);
        }
        IntervalGradientEvaluator gradients(*function);
        const IntervalGradient all = gradients.evaluate(domain.box().intervals());
        answer.jumps = all.hazard == GradientHazard::jump || all.wrap != 0;
        return answer;
    }
};

/// What a comparison at the points says.
struct Comparison {
    bool fits = false;
    double largest = 0;
    std::size_t mended = 0;
};

Comparison compare(const Subject& subject, const Sampled& after, bool signOnly) {
    const double threshold = subject.shape->settings().threshold;
    const auto& before = subject.sampled.values;
    double size = std::abs(threshold);
    for (const ValueAndGradient& one : before)
        if (std::isfinite(one.value)) size = std::max(size, std::abs(one.value));
    Comparison answer;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const double a = before[i].value, b = after.values[i].value;
        if (!std::isfinite(a)) {
            answer.mended += std::isfinite(b);
            continue;
        }
        if (!std::isfinite(b)) return {};
        const double difference = std::abs(a - b);
        const bool nearZero = std::abs(a - threshold) <= rounding * size;
        if (signOnly ? !nearZero && (a < threshold) != (b < threshold) : difference > rounding * size)
            return {};
        answer.largest = std::max(answer.largest, difference);
    }
    answer.fits = true;
    if (signOnly) answer.largest = std::numeric_limits<double>::quiet_NaN();
    return answer;
}

/// Whether a function is at least 0 in the whole domain, or more than 0: proven by enclosures.
bool provenPositive(const Isosurface& surface, std::span<const double> parameters, bool strictly,
                    const std::stop_token& stop) {
    const GradientDomain domain(surface.settings().container);
    if (domain.empty()) return false;
    IntervalEvaluator intervals(*surface.prepared(parameters));
    std::deque<GradientBox> queue{domain.box()};
    for (std::size_t count = 0; !queue.empty(); ++count) {
        if (count > conditionBoxes || stop.stop_requested()) return false;
        const GradientBox box = queue.front();
        queue.pop_front();
        if (domain.misses(box)) continue;
        const Interval range = intervals.evaluate(box.intervals());
        if (!range.empty() && !range.maybeUndefined && (strictly ? range.low > 0 : range.low >= 0)) continue;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const double middle = box.center()[axis];
        if (!(middle > box.low[axis] && middle < box.high[axis])) return false;
        GradientBox first = box, second = box;
        first.high[axis] = second.low[axis] = middle;
        queue.push_back(first);
        queue.push_back(second);
    }
    return true;
}

class Search {
  public:
    Search(const ParseResult& parsed, std::size_t isosurface, std::stop_token stop)
        : parsed_(parsed), number_(isosurface), stop_(std::move(stop)), text_((*parsed.sources)[0].text()) {}

    std::vector<FormulaRewrite> run(const std::function<void(double)>& progress) {
        std::vector<std::pair<const FunctionText*, RewriteCandidate>> all;
        const std::vector<FunctionText> texts = functionTexts(parsed_, number_);
        for (const FunctionText& text : texts)
            for (RewriteCandidate& one : candidatesOf(text)) all.emplace_back(&text, std::move(one));
        std::ranges::stable_sort(all, {}, [](const auto& one) { return one.second.range.begin; });
        if (all.size() > mostCandidates) all.resize(mostCandidates);
        std::vector<FormulaRewrite> found;
        if (all.empty()) return found;
        evaluationTime_ = std::accumulate(
            texts.begin(), texts.end(), 56.0,
            [](double sum, const FunctionText& one) { return sum + interpreterTime(*one.formula); });
        for (const SceneIsosurface& one : parsed_.scene->isosurfaces)
            if (one.shape)
                subjects_.emplace_back(std::in_place, one.shape, *parsed_.scene->parameterTable, stop_);
            else
                subjects_.emplace_back();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (stop_.stop_requested()) return {};
            if (auto rewrite = tried(*all[i].first, all[i].second)) found.push_back(std::move(*rewrite));
            if (progress) progress((static_cast<double>(i) + 1) / static_cast<double>(all.size()));
        }
        return stop_.stop_requested() ? std::vector<FormulaRewrite>{} : found;
    }

  private:
    std::vector<RewriteCandidate> candidatesOf(const FunctionText& text) const {
        RewriteContext context;
        context.text = text_;
        context.arguments = text.arguments;
        // What is told of signs must hold for all that use the function.
        context.isWhole = text.whole &&
                          parsed_.scene->isosurfaces[number_].shape->settings().threshold == 0 &&
                          (text.name.empty() || countWord(text_, text.name) == 2);
        const std::string stem = text.name.empty() ? "f_parts" : text.name + "_parts";
        context.freeName = stem;
        for (int i = 2; countWord(text_, context.freeName) > 0; ++i)
            context.freeName = stem + std::to_string(i);
        return rewriteCandidates(text.formula, context);
    }

    ParseResult read(std::string text) const {
        ParseOptions options = withoutStop(parsed_.options);
        options.stop = stop_;
        return parseScene(std::move(text), std::move(options));
    }

    /// The conditions, as the function of this isosurface.
    bool proven(const FunctionText& text, const RewriteCandidate& candidate) const {
        if (candidate.conditions.empty()) return true;
        if (!text.whole) return false;
        const SourceRange place = parsed_.scene->isosurfaces[number_].functionRange;
        return std::ranges::all_of(candidate.conditions, [&](const RewriteCondition& one) {
            const ParseResult asked =
                read(changedText(std::string(text_), {{place, " " + one.formula + " "}}));
            return asked.ok() && number_ < asked.scene->isosurfaces.size() &&
                   asked.scene->isosurfaces[number_].shape &&
                   provenPositive(*asked.scene->isosurfaces[number_].shape, *asked.scene->parameterTable,
                                  one.positive, stop_);
        });
    }

    /// One replacement for both places of a candidate.
    QuickFix fixOf(const FunctionText& text, const RewriteCandidate& candidate) const {
        QuickFix fix{"Rewrite as `" + candidate.replacement + "`", candidate.range, candidate.replacement};
        if (candidate.before.empty()) return fix;
        fix.title = "Compute `" + candidate.replacement.substr(candidate.replacement.rfind(", ") + 2);
        fix.title.back() = '`';
        fix.title += " once";
        fix.range.begin = text.statement;
        const std::string between(text_.substr(text.statement, candidate.range.begin - text.statement));
        fix.replacement = candidate.before + between + candidate.replacement;
        return fix;
    }

    std::optional<FormulaRewrite> tried(const FunctionText& text, const RewriteCandidate& candidate) {
        FormulaRewrite rewrite;
        rewrite.kind = candidate.kind;
        rewrite.identity = candidate.identity;
        rewrite.conditional = !candidate.conditions.empty();
        rewrite.fix = fixOf(text, candidate);
        const ParseResult changed =
            read(changedText(std::string(text_), {{rewrite.fix.range, rewrite.fix.replacement}}));
        const auto& after = changed.scene->isosurfaces;
        if (!changed.ok() || after.size() != subjects_.size()) return {};
        bool same = true;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (!subjects_[i] || !after[i].shape) return {};
            const Subject& subject = *subjects_[i];
            if (i != number_ && sameFunction(*subject.shape->tape(), subject.parameters,
                                             *after[i].shape->tape(), *changed.scene->parameterTable))
                continue;
            // Where nothing can be compared, nothing is told.
            if (subject.domain.empty()) return {};
            const Sampled sampled = subject.sample(*after[i].shape, *changed.scene->parameterTable);
            const Comparison compared = compare(subject, sampled, candidate.signOnly);
            if (!compared.fits) return {};
            if (i != number_) continue;
            same = sameFunction(*subject.shape->tape(), subject.parameters, *after[i].shape->tape(),
                                *changed.scene->parameterTable);
            rewrite.points = subject.points.x.size();
            rewrite.largestDifference = compared.largest;
            rewrite.mended = compared.mended;
            fill(rewrite, candidate, subject.sampled, sampled);
            if (!pays(rewrite, subject, sampled)) return {};
        }
        rewrite.proof = same                      ? RewriteProof::same
                        : proven(text, candidate) ? RewriteProof::identity
                                                  : RewriteProof::measured;
        // Where signs are not certain, nothing is worth them.
        if (candidate.signOnly && rewrite.proof == RewriteProof::measured) return {};
        return rewrite;
    }

    void fill(FormulaRewrite& rewrite, const RewriteCandidate& candidate, const Sampled& before,
              const Sampled& after) const {
        const double slowness = machineSlowness();
        rewrite.nanoseconds[0] = evaluationTime_ * slowness;
        rewrite.nanoseconds[1] = std::max(1.0, evaluationTime_ - candidate.saved) * slowness;
        rewrite.off[0] = before.off, rewrite.off[1] = after.off;
        rewrite.steepest[0] = before.steepest, rewrite.steepest[1] = after.steepest;
    }

    static bool pays(const FormulaRewrite& rewrite, const Subject& subject, const Sampled& after) {
        const bool quicker = rewrite.nanoseconds[1] <= (1 - worthwhileShare) * rewrite.nanoseconds[0];
        const bool exacter = rewrite.off[0] > toleratedShare * subject.shape->rootSettings().accuracy &&
                             rewrite.off[1] * worthwhileFactor <= rewrite.off[0];
        switch (rewrite.kind) {
            case RewriteKind::power:
            case RewriteKind::root:
            case RewriteKind::common: return quicker;
            case RewriteKind::squared: {
                // At the points themselves no slope is infinite: around them it may be.
                IntervalGradientEvaluator gradients(*subject.shape->prepared(subject.parameters));
                const IntervalGradient all = gradients.evaluate(subject.domain.box().intervals());
                return !all.bounded() || all.steepness > endless * rewrite.steepest[1];
            }
            case RewriteKind::cancellation: return exacter;
            case RewriteKind::overflow: return rewrite.mended > 0;
            case RewriteKind::angle: return quicker || (subject.sampled.jumps && !after.jumps);
        }
        return false;
    }

    const ParseResult& parsed_;
    std::size_t number_;
    std::stop_token stop_;
    std::string_view text_;
    std::vector<std::optional<Subject>> subjects_;
    double evaluationTime_ = 0;
};

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

}  // namespace

std::string_view name(RewriteProof proof) {
    switch (proof) {
        case RewriteProof::same: return "same";
        case RewriteProof::identity: return "identity";
        case RewriteProof::measured: break;
    }
    return "measured";
}

std::string describe(const FormulaRewrite& rewrite) {
    std::string text = rewrite.identity + ". ";
    const double share = rewrite.nanoseconds[1] / rewrite.nanoseconds[0];
    if (share < 0.995)
        text += "POV-Ray takes about " + rounded(100 * (1 - share)) + " % less for an evaluation. ";
    if (share > 1.005)
        text += "POV-Ray takes about " + rounded(100 * (share - 1)) + " % more for an evaluation. ";
    if (rewrite.off[0] > worthwhileFactor * rewrite.off[1])
        text += "Rounding moves the surface by up to " + rounded(rewrite.off[1]) + " instead of " +
                rounded(rewrite.off[0]) + ". ";
    if (rewrite.mended > 0)
        text += "It has a finite value at " + std::to_string(rewrite.mended) +
                " sampled points where the formula has none. ";
    const std::string points = std::to_string(rewrite.points) + " points";
    if (rewrite.proof == RewriteProof::same)
        text += "Proven: the same operations on the same numbers.";
    else if (rewrite.proof == RewriteProof::identity)
        text += rewrite.conditional ? "Proven by algebra, its conditions by enclosures over the container; "
                                    : "Proven by algebra; ";
    else
        text += "Not proven over the whole container; ";
    if (rewrite.proof != RewriteProof::same)
        text +=
            std::isnan(rewrite.largestDifference)
                ? "the signs agree at " + points + ". The values differ: max_gradient has to be found anew."
                : "the largest difference at " + points + " is " + rounded(rewrite.largestDifference) + ".";
    return text;
}

std::vector<FormulaRewrite> formulaRewrites(const ParseResult& parsed, std::size_t isosurface,
                                            const std::function<void(double)>& progress,
                                            std::stop_token stop) {
    const LoopStop loops(stop);
    if (!parsed.ok() || !parsed.scene || parsed.notation != Notation::povray || stop.stop_requested() ||
        isosurface >= parsed.scene->isosurfaces.size() || !parsed.scene->isosurfaces[isosurface].shape)
        return {};
    return Search(parsed, isosurface, std::move(stop)).run(progress);
}

bool helps(RewriteKind kind, Ailment ailment) {
    switch (kind) {
        case RewriteKind::squared: return ailment == Ailment::infinite || ailment == Ailment::kink;
        case RewriteKind::overflow: return ailment == Ailment::infinite || ailment == Ailment::undefined;
        case RewriteKind::cancellation: return ailment == Ailment::cancellation;
        case RewriteKind::angle: return ailment == Ailment::jump || ailment == Ailment::undefined;
        default: return false;
    }
}

std::string rewritten(const ParseResult& parsed, const FormulaRewrite& rewrite) {
    return changedText(std::string((*parsed.sources)[0].text()),
                       {{rewrite.fix.range, rewrite.fix.replacement}});
}

}  // namespace isoscope

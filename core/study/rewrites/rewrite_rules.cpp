// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rewrites/rewrite_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>

#include "core/text/text_change.h"

namespace isoscope {

namespace {

using Kind = FormulaPart::Kind;

constexpr std::array<std::string_view, 7> kindNames{"power",    "root",  "squared", "cancellation",
                                                    "overflow", "angle", "common"};
/// Exponents that POV-Ray multiplies out.
constexpr int largestExponent = 8;
/// What a call of one more function costs in POV-Ray, and an argument of it.
constexpr double callTime = 41, argumentTime = 4;
constexpr int largestAngle = 4;

double numberOf(const FormulaPart& part) {
    return part.kind == Kind::number ? std::strtod(part.head.c_str(), nullptr) : NAN;
}

/// Applies every rule to every part of a formula.
class Rules {
  public:
    Rules(const FormulaPointer& formula, const RewriteContext& context, std::size_t most)
        : formula_(formula), context_(context), most_(most) {}

    std::vector<RewriteCandidate> run() {
        squared();
        each(*formula_, false);
        common();
        std::ranges::stable_sort(found_, {}, [](const RewriteCandidate& one) { return one.range.begin; });
        if (found_.size() > most_) found_.resize(most_);
        return std::move(found_);
    }

  private:
    /// As it stands in the text, in parentheses unless it needs none as a factor.
    std::string factor(const FormulaPart& part) const {
        const std::string inner = bare(part);
        return part.kind == Kind::binary || part.kind == Kind::sign ? "(" + inner + ")" : inner;
    }
    /// As it stands in the text, without parentheses around it.
    std::string bare(const FormulaPart& part) const {
        return std::string(context_.text.substr(part.inner.begin, part.inner.end - part.inner.begin));
    }
    /// The square, by what is quickest in POV-Ray.
    std::string square(const FormulaPart& part) const {
        return part.simple() ? bare(part) + "*" + bare(part) : "pow(" + bare(part) + ", 2)";
    }
    static double squareTime(const FormulaPart& part) {
        return part.simple() ? 15.7 : 28 + interpreterTime(part);
    }

    void add(RewriteKind kind, const FormulaPart& part, std::string replacement, std::string identity,
             double timeAfter, std::vector<RewriteCondition> conditions = {}, bool signOnly = false) {
        RewriteCandidate one;
        one.kind = kind;
        one.range = part.range;
        // What stood in parentheses stays in them.
        one.replacement = part.range == part.inner ? std::move(replacement) : "(" + replacement + ")";
        one.identity = std::move(identity);
        one.conditions = std::move(conditions);
        one.saved = interpreterTime(part) - timeAfter;
        one.signOnly = signOnly;
        found_.push_back(std::move(one));
    }

    /// `inProduct`: the part is a factor of a product that has been looked at as a whole.
    void each(const FormulaPart& part, bool inProduct) {
        if (part.isBinary("*") && !inProduct) product(part);
        if (part.isCall("pow") && part.parts.size() == 2) power(part);
        if (part.isBinary("-")) difference(part);
        if (part.isCall("sqrt") && part.parts.size() == 1) overflow(part);
        if ((part.isCall("cos") || part.isCall("sin")) && part.parts.size() == 1) angle(part);
        for (std::size_t i = 0; i < part.parts.size(); ++i) {
            const FormulaPart& below = *part.parts[i];
            each(below, part.isBinary("*") && i == 0 && below.range == below.inner);
        }
    }

    /// A*A with a compound A, which the interpreter works out twice.
    void product(const FormulaPart& part) {
        std::vector<const FormulaPart*> factors;
        const FormulaPart* left = &part;
        while (left->isBinary("*") && (left == &part || left->range == left->inner)) {
            factors.insert(factors.begin(), left->parts[1].get());
            left = left->parts[0].get();
        }
        factors.insert(factors.begin(), left);
        for (std::size_t i = 0; i + 1 < factors.size();) {
            const std::string text = canonicalText(*factors[i]);
            std::size_t end = i + 1;
            while (end < factors.size() && canonicalText(*factors[end]) == text) ++end;
            const auto times = static_cast<int>(end - i);
            if (times >= 2 && times <= largestExponent && !factors[i]->simple() &&
                factors[i]->kind != Kind::sign)
                equalFactors(*factors[i], *factors[end - 1], times);
            i = end;
        }
    }

    void equalFactors(const FormulaPart& first, const FormulaPart& last, int times) {
        RewriteCandidate one;
        one.kind = RewriteKind::power;
        one.range = {first.range.file, first.range.begin, last.range.end};
        const std::string exponent = std::to_string(times);
        one.replacement = "pow(" + bare(first) + ", " + exponent + ")";
        one.identity =
            times == 2 ? "A*A = pow(A, 2)" : "A multiplied " + exponent + " times = pow(A, " + exponent + ")";
        const double own = interpreterTime(first);
        one.saved = (times - 1) * (own + (first.kind == Kind::binary ? 105 : 15.7)) - 28;
        found_.push_back(std::move(one));
    }

    void power(const FormulaPart& part) {
        const FormulaPart &base = *part.parts[0], &exponent = *part.parts[1];
        const double value = numberOf(exponent);
        if (value == 0.5)
            add(RewriteKind::root, part, "sqrt(" + bare(base) + ")", "pow(A, 0.5) = sqrt(A)",
                8.3 + interpreterTime(base));
        if (value == 2 && base.simple())
            add(RewriteKind::power, part, "(" + square(base) + ")", "pow(A, 2) = A*A", squareTime(base));
    }

    void difference(const FormulaPart& part) {
        const FormulaPart &left = *part.parts[0], &right = *part.parts[1];
        const auto squareOf = [](const FormulaPart& one) -> const FormulaPart* {
            if (one.isBinary("*") && canonicalText(*one.parts[0]) == canonicalText(*one.parts[1]))
                return one.parts[0].get();
            if (one.isCall("pow") && one.parts.size() == 2 && numberOf(*one.parts[1]) == 2)
                return one.parts[0].get();
            return nullptr;
        };
        const FormulaPart *a = squareOf(left), *b = squareOf(right);
        const double once = interpreterTime(left) + interpreterTime(right);
        if (a && b)
            add(RewriteKind::cancellation, part,
                "(" + bare(*a) + " - " + factor(*b) + ")*(" + bare(*a) + " + " + factor(*b) + ")",
                "A*A - B*B = (A - B)*(A + B)", 2 * interpreterTime(*a) + 2 * interpreterTime(*b) + 105 + 2.6);
        if (left.isCall("sqrt") && right.isCall("sqrt")) {
            const FormulaPart &p = *left.parts[0], &q = *right.parts[0];
            add(RewriteKind::cancellation, part,
                "((" + bare(p) + ") - " + factor(q) + ")/(" + bare(left) + " + " + bare(right) + ")",
                "sqrt(A) - sqrt(B) = (A - B)/(sqrt(A) + sqrt(B))", 2 * once + 10,
                {{"sqrt(" + bare(p) + ") + sqrt(" + bare(q) + ")", true}});
        }
        if (numberOf(left) == 1 && right.isCall("cos") && right.parts.size() == 1)
            add(RewriteKind::cancellation, part, "2*pow(sin(" + factor(*right.parts[0]) + "/2), 2)",
                "1 - cos(A) = 2*sin(A/2)*sin(A/2)", once + 52);
    }

    /// The whole formula as sqrt(A) - B.
    void squared() {
        const FormulaPart& part = *formula_;
        if (!context_.isWhole || !part.isBinary("-")) return;
        const FormulaPart &left = *part.parts[0], &right = *part.parts[1];
        const bool first = left.isCall("sqrt") && !right.isCall("sqrt");
        if (!first && !(right.isCall("sqrt") && !left.isCall("sqrt"))) return;
        const FormulaPart &root = first ? left : right, &other = first ? right : left;
        if (root.parts.size() != 1) return;
        const FormulaPart& a = *root.parts[0];
        const std::string replacement =
            first ? bare(a) + " - " + square(other) : square(other) + " - " + factor(a);
        add(RewriteKind::squared, part, replacement,
            first ? "sqrt(A) - B is 0 where A - B*B is, and has its sign, for A >= 0 and B > 0"
                  : "B - sqrt(A) is 0 where B*B - A is, and has its sign, for A >= 0 and B > 0",
            interpreterTime(a) + squareTime(other) + 1.3, {{bare(a), false}, {bare(other), true}}, true);
    }

    /// sqrt of a sum of squares; whether they overflow is for the caller to find out.
    void overflow(const FormulaPart& part) {
        std::vector<const FormulaPart*> terms;
        const FormulaPart* left = part.parts[0].get();
        while (left->isBinary("+")) {
            terms.insert(terms.begin(), left->parts[1].get());
            left = left->parts[0].get();
        }
        terms.insert(terms.begin(), left);
        if (terms.size() < 2) return;
        constexpr const char* unit = "1.157920892373162e77";  // 2 to the power of 256
        std::string sum, largest;
        double time = 8.3 + 15.7;
        for (const FormulaPart* term : terms) {
            const bool product =
                term->isBinary("*") && canonicalText(*term->parts[0]) == canonicalText(*term->parts[1]);
            const bool power =
                term->isCall("pow") && term->parts.size() == 2 && numberOf(*term->parts[1]) == 2;
            if (!product && !power) return;
            const FormulaPart& root = *term->parts[0];
            sum += (sum.empty() ? "pow(" : " + pow(") + factor(root) + "/" + unit + ", 2)";
            largest += (largest.empty() ? "" : " + ") + std::string("abs(") + bare(root) + ")";
            time += 28 + 8.3 + interpreterTime(root);
        }
        add(RewriteKind::overflow, part, std::string(unit) + "*sqrt(" + sum + ")",
            "sqrt(A*A + B*B) = S*sqrt((A/S)*(A/S) + (B/S)*(B/S)) with S = 2 to the power of 256, up to 1e-77",
            time, {{"1e230 - (" + largest + ")", true}});
    }

    /// cos or sin of atan2, or of a whole multiple of it.
    void angle(const FormulaPart& part) {
        const FormulaPart* inner = part.parts[0].get();
        int times = 1;
        if (inner->isBinary("*")) {
            const bool before = !std::isnan(numberOf(*inner->parts[0]));
            const double value = numberOf(*inner->parts[before ? 0 : 1]);
            if (!(value >= 1 && value <= largestAngle && value == std::floor(value))) return;
            times = static_cast<int>(value);
            inner = inner->parts[before ? 1 : 0].get();
        }
        if (!inner->isCall("atan2") || inner->parts.size() != 2) return;
        const FormulaPart &b = *inner->parts[0], &a = *inner->parts[1];
        if (!a.simple() || !b.simple()) return;
        const std::string u = bare(a), v = bare(b), uu = u + "*" + u, vv = v + "*" + v;
        const bool cosine = part.isCall("cos");
        const std::array<std::array<std::string, 2>, largestAngle> above{
            {{u, v},
             {uu + " - " + vv, "2*" + u + "*" + v},
             {u + "*(" + uu + " - 3*" + vv + ")", v + "*(3*" + uu + " - " + vv + ")"},
             {"pow(" + uu + " - " + vv + ", 2) - 4*" + uu + "*" + vv,
              "4*" + u + "*" + v + "*(" + uu + " - " + vv + ")"}}};
        const std::string sum = uu + " + " + vv;
        const std::array<std::string, largestAngle> below{"sqrt(" + sum + ")", "(" + sum + ")",
                                                          "pow(" + sum + ", 1.5)", "pow(" + sum + ", 2)"};
        const auto k = static_cast<std::size_t>(times - 1);
        const std::string replacement = "((" + above[k][cosine ? 0 : 1] + ")/" + below[k] + ")";
        const FormulaPointer read =
            readFormula(replacement, {0, 0, static_cast<std::uint32_t>(replacement.size())});
        add(RewriteKind::angle, part, replacement,
            std::string(cosine ? "cos" : "sin") + "(n*atan2(B, A)) by its multiple angles, but at A = B = 0",
            read ? interpreterTime(*read) : interpreterTime(part), {{sum, true}});
    }

    /// The largest part that is computed more than once and calls a function.
    void common() {
        std::map<std::string, std::vector<const FormulaPart*>> places;
        const std::function<bool(const FormulaPart&)> collect = [&](const FormulaPart& part) {
            bool calls = part.kind == Kind::call, bound = part.isCall("sum") || part.isCall("prod");
            if (bound) return true;  // their counters are no arguments
            for (const FormulaPointer& one : part.parts) calls = collect(*one) || calls;
            if (calls) places[canonicalText(part)].push_back(&part);
            return calls;
        };
        collect(*formula_);
        const std::vector<const FormulaPart*>* best = nullptr;
        double most = 0;
        for (const auto& [text, all] : places) {
            const double saved = (static_cast<double>(all.size()) - 1) * interpreterTime(*all.front()) -
                                 callTime - argumentTime * static_cast<double>(context_.arguments.size() + 1);
            if (all.size() < 2 || saved <= most) continue;
            most = saved;
            best = &all;
        }
        if (!best) return;
        RewriteCandidate one;
        one.kind = RewriteKind::common;
        one.range = formula_->range;
        std::vector<TextChange> changes;
        for (const FormulaPart* part : *best)
            changes.push_back(
                {{0, part->range.begin - formula_->range.begin, part->range.end - formula_->range.begin},
                 "part"});
        std::string list;
        for (const std::string& argument : context_.arguments) list += argument + ", ";
        const std::string body = changedText(
            std::string(context_.text.substr(one.range.begin, one.range.end - one.range.begin)), changes);
        one.before = "#declare " + context_.freeName + " = function(" + list + "part) { " + body + " }\n";
        one.replacement = context_.freeName + "(" + list + bare(*best->front()) + ")";
        one.identity = "a part that stands there " + std::to_string(best->size()) + " times is computed once";
        one.saved = most;
        found_.push_back(std::move(one));
    }

    const FormulaPointer& formula_;
    const RewriteContext& context_;
    std::size_t most_;
    std::vector<RewriteCandidate> found_;
};

}  // namespace

std::string_view name(RewriteKind kind) { return kindNames[static_cast<std::size_t>(kind)]; }

std::vector<RewriteCandidate> rewriteCandidates(const FormulaPointer& formula, const RewriteContext& context,
                                                std::size_t most) {
    return formula ? Rules(formula, context, most).run() : std::vector<RewriteCandidate>{};
}

}  // namespace isoscope

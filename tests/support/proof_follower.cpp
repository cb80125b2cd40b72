// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/proof_follower.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace isoscope::test {

namespace {

bool isRoot(const ProofStep& step) { return step.rule >= ProofRule::crossing; }
bool isSurface(const ProofStep& step) { return isRoot(step) && step.rule != ProofRule::pole; }
bool hasSign(const ProofStep& step) { return step.rule == ProofRule::form || step.rule == ProofRule::cases; }

QString describe(const ProofStep& step) {
    return QString::asprintf("%s [%.17g, %.17g] sign %d, form %.17g + %.17g s +- %.17g over %.17g + %.17g",
                             name(step.rule), step.from, step.to, step.sign, step.center, step.slope,
                             step.error, step.start, step.length);
}

/// Of lines of which nothing is certain, this many steps are followed.
constexpr std::size_t mostOpenSteps = 60;

/// Follows one line; see followProof().
class Follower {
  public:
    Follower(const ClaimedLine& claimed, ExactLine& line, FollowedSteps& counts)
        : claimed_(claimed), line_(line), counts_(counts) {
        const LineQuery& query = claimed.line;
        const double speed = glm::length(query.direction);
        tolerance_ = claimed.settings.accuracy / speed;
        double size = 0;
        for (int k = 0; k < 3; ++k)
            size = std::max(size, std::abs(query.origin[k]) + query.far * std::abs(query.direction[k]));
        grain_ = 0x1p-52 * std::max(32 * query.far, 4 * size / speed);
        // What is nearer to the ends of the line is the container's (GeneralSearch).
        wall_ = 1.001 / 64 * std::max(0.003 * tolerance_, grain_);
        const bool certain = claimed.verdict <= Verdict::certifiedMiss;
        stride_ = certain ? 1 : 1 + claimed.steps.size() / mostOpenSteps;
    }

    QString run() {
        for (const auto check : {&Follower::checkSteps, &Follower::checkChain, &Follower::checkRoots})
            if (QString problem = (this->*check)(); !problem.isEmpty()) return problem;
        return {};
    }

  private:
    QString checkSteps() {
        for (std::size_t k = 0; k < claimed_.steps.size(); k += stride_) {
            const ProofStep& step = claimed_.steps[k];
            QString problem;
            if (hasSign(step))
                problem = checkClear(step);
            else if (isSurface(step))
                problem = checkChange(step);
            else if (step.rule == ProofRule::undefined)
                problem = checkUndefined(step);
            if (!problem.isEmpty()) return problem + ": " + describe(step);
        }
        return {};
    }

    QString checkClear(const ProofStep& whole) {
        ProofStep step = whole;
        if (step.to == claimed_.line.far) step.to = std::max(step.from, step.to - wall_);
        if (step.sign != 1 && step.sign != -1) return "no sign";
        if (step.rule == ProofRule::form) {
            // Where the bound of the form meets 0 the place itself is rounded to a double.
            const double from = std::nextafter(step.from, step.to), to = std::nextafter(step.to, step.from);
            for (const double t : {from, to})
                if (from <= to && !formHasSign(step, t)) return "the form has another sign";
            for (const double share : {0.0, 0.3, 1.0})
                if (!line_.admits(step.start, step.length, share, step.center, step.slope, step.error))
                    return QString("the form does not hold the function at the share %1").arg(share);
        }
        const double slack = step.rule == ProofRule::cases ? unitsOf(step.to) : 0;
        if (!(step.from + slack <= step.to - slack)) return {};
        switch (hasSignButFor(slack, step.sign, step.from + slack, step.to - slack)) {
            case ExactLine::Answer::no: return "the function has another sign";
            case ExactLine::Answer::open: ++counts_.open; return {};
            case ExactLine::Answer::yes: break;
        }
        ++counts_.confirmed;
        return {};
    }

    /// ExactLine::hasSign(), but for what is narrower than `slack`: parts by cases leave out what is shorter
    /// than 32 units of t, where two jumps are at one place (CaseMarch).
    ExactLine::Answer hasSignButFor(double slack, int sign, double from, double to) {
        for (int round = 0; round < 8; ++round) {
            const ExactLine::Answer answer = line_.hasSign(sign, from, to);
            if (answer != ExactLine::Answer::no || slack == 0) return answer;
            const double at = line_.refutedAt();
            if (line_.signAt(at - slack) != sign || line_.signAt(at + slack) != sign) return answer;
            if (at - slack > from && line_.hasSign(sign, from, at - slack) == ExactLine::Answer::no)
                return answer;
            if (at + slack >= to) return ExactLine::Answer::yes;
            from = at + slack;
        }
        return ExactLine::Answer::open;
    }

    bool formHasSign(const ProofStep& step, double t) const {
        const ExactRange whole = ExactRange(t) - ExactRange(step.start);
        ExactNumber share;
        mpfr_div_d(share.get(), whole.low.get(), step.length / 2, MPFR_RNDN);
        mpfr_sub_ui(share.get(), share.get(), 1, MPFR_RNDN);
        ExactNumber value;
        mpfr_mul_d(value.get(), share.get(), step.slope, MPFR_RNDN);
        mpfr_add_d(value.get(), value.get(), step.center, MPFR_RNDN);
        mpfr_sub_d(value.get(), value.get(), claimed_.settings.threshold, MPFR_RNDN);
        mpfr_mul_si(value.get(), value.get(), step.sign, MPFR_RNDN);
        mpfr_sub_d(value.get(), value.get(), step.error, MPFR_RNDN);
        return mpfr_sgn(value.get()) >= 0;
    }

    QString checkChange(const ProofStep& step) {
        if (step.sign == 0) {
            ++counts_.open;
            return {};
        }
        const bool byCases = std::ranges::any_of(claimed_.steps, [&](const ProofStep& other) {
            return other.rule == ProofRule::cases && (other.to == step.from || other.from == step.to);
        });
        const double slack = byCases ? unitsOf(step.to) : 0;
        const int before = line_.signAt(std::nextafter(step.from - slack, -INFINITY)),
                  behind = line_.signAt(std::nextafter(step.to + slack, INFINITY));
        if (before == -step.sign) return "the sign before the root is the other one";
        if (behind == step.sign) return "the sign behind the root is the same";
        ++(before == step.sign && behind == -step.sign ? counts_.confirmed : counts_.open);
        return {};
    }

    static double unitsOf(double t) { return 0x1p-52 * 32 * std::abs(t); }

    QString checkUndefined(const ProofStep& step) {
        for (const double share : {0.0, 0.3, 1.0})
            if (!line_.maybeUndefinedAt(step.from, step.to - step.from, share))
                return "the function has a value";
        ++counts_.confirmed;
        return {};
    }

    /// The parts follow each other from the beginning of the line on.
    QString checkChain() {
        double reached = claimed_.line.near;
        for (const ProofStep& step : claimed_.steps) {
            if (step.from > reached)
                return QString::asprintf("nothing is known from %.17g on: ", reached) + describe(step);
            reached = std::max(reached, step.to);
        }
        const bool certain = claimed_.verdict <= Verdict::certifiedMiss;
        const bool full = claimed_.roots.size() >= static_cast<std::size_t>(claimed_.settings.maxTrace);
        if (certain && !full && reached < claimed_.line.far)
            return QString::asprintf("nothing is known from %.17g to the end", reached);
        return certain ? checkPassed() : QString();
    }

    /// Nothing is passed over but roots, and the walls of the container.
    QString checkPassed() {
        int sign = 0;
        double reached = claimed_.line.near;
        for (const ProofStep& step : claimed_.steps) {
            // A search that begins again begins before the last root.
            if (step.rule == ProofRule::undefined || step.from < reached) sign = 0;
            reached = step.to;
            if (hasSign(step)) {
                if (sign == -step.sign) return "the sign changes without a root: " + describe(step);
                sign = step.sign;
            }
            if (isRoot(step)) sign = 0;
            if (step.rule != ProofRule::passed && step.rule != ProofRule::sampled) continue;
            const double fromEnds = std::min(step.to - claimed_.line.near, claimed_.line.far - step.from);
            if (fromEnds <= wall_) continue;
            const bool ofRoot = std::ranges::any_of(claimed_.steps, [&](const ProofStep& root) {
                return isRoot(root) && root.from <= step.from && step.to <= root.to &&
                       (root.rule == ProofRule::pole || root.to - root.from <= 1.001 * tolerance_ + grain_);
            });
            if (!ofRoot) return "a part of a certified line is passed over: " + describe(step);
        }
        return {};
    }

    /// Each root lies where the steps have one.
    QString checkRoots() {
        const bool hit = std::ranges::any_of(claimed_.steps, isSurface);
        if (claimed_.verdict == Verdict::certifiedHit && !hit) return "a certified hit without a root";
        if (claimed_.verdict == Verdict::certifiedMiss && hit) return "a certified miss with a root";
        for (const Root& root : claimed_.roots) {
            const bool found = std::ranges::any_of(claimed_.steps, [&](const ProofStep& step) {
                return isRoot(step) && step.from <= root.t && root.t <= step.to;
            });
            if (!found) return QString::asprintf("no step has found the root at %.17g", root.t);
        }
        return {};
    }

    const ClaimedLine& claimed_;
    ExactLine& line_;
    FollowedSteps& counts_;
    // By t: the accuracy, what doubles tell apart, and what is left to the container.
    double tolerance_ = 0, grain_ = 0, wall_ = 0;
    std::size_t stride_ = 1;
};

}  // namespace

QString followProof(const ClaimedLine& claimed, ExactLine& line, FollowedSteps& counts) {
    return Follower(claimed, line, counts).run();
}

}  // namespace isoscope::test

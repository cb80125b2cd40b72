// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/exact_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/function/scalar_operations.h"

namespace isoscope::test {

namespace {

/// Whether the values lie on one side of 0: 1, -1, else 0.
int sideOf(const ExactRange& range) {
    if (range.maybeUndefined) return 0;
    return range.isPositive() ? 1 : range.isNegative() ? -1 : 0;
}

}  // namespace

ExactLine::ExactLine(Function function, std::span<const double> parameters, const LineQuery& line,
                     double threshold)
    : function_(std::move(function)), line_(line), threshold_(threshold) {
    const FunctionGraph& graph = *function_.graph;
    const NodeId root = function_.results[0];
    values_.resize(root + 1);
    std::vector<bool> needed(root + 1, false), uniform(root + 1, false);
    std::vector<double> rounded(root + 1, 0);
    needed[root] = true;
    for (NodeId id = root + 1; id-- > 0;)
        if (needed[id])
            for (const NodeId operand : graph.operandsOf(id)) needed[operand] = true;
    for (NodeId id = 0; id <= root; ++id) {
        if (!needed[id]) continue;
        const Node& node = graph[id];
        uniform[id] = true;
        if (node.operation == Operation::constant) {
            rounded[id] = node.value;
        } else if (node.operation == Operation::parameter) {
            rounded[id] = node.index < parameters.size() ? parameters[node.index] : 0;
        } else if (node.operation == Operation::variable) {
            uniform[id] = node.index > 2;
        } else {
            isCovered_ = isCovered_ && hasExactRule(node.operation);
            if (!isCovered_) return;
            std::vector<double> operands;
            for (const NodeId operand : graph.operandsOf(id)) {
                uniform[id] = uniform[id] && uniform[operand];
                operands.push_back(rounded[operand]);
            }
            if (uniform[id]) rounded[id] = evaluateOperation(node.operation, operands);
        }
        if (uniform[id])
            values_[id] = ExactJet::constant(rounded[id]);
        else
            order_.push_back(id);
    }
}

const ExactJet& ExactLine::evaluate(const ExactRange& t) {
    ++evaluations_;
    const FunctionGraph& graph = *function_.graph;
    std::array<const ExactJet*, 4> operands{};
    for (const NodeId id : order_) {
        const Node& node = graph[id];
        if (node.operation == Operation::variable) {
            const int axis = static_cast<int>(node.index);
            const ExactRange direction(line_.direction[axis]);
            values_[id] = {ExactRange(line_.origin[axis]) + t * direction, direction, true};
            continue;
        }
        const auto count = static_cast<std::size_t>(arity(node.operation));
        for (std::size_t k = 0; k < count; ++k) operands[k] = &values_[node.operands[k]];
        values_[id] = enclose(node.operation, std::span(operands).first(count));
    }
    return values_[function_.results[0]];
}

/// By the values themselves and, where there is one, by the derivative from the middle.
ExactRange ExactLine::valueOver(const Piece& piece) {
    const ExactJet whole = evaluate({piece.from, piece.to});
    const ExactRange value = whole.value - threshold_;
    if (!whole.isSloped || sideOf(value) != 0) return value;
    ExactNumber middle;
    mpfr_add(middle.get(), piece.from.get(), piece.to.get(), MPFR_RNDN);
    mpfr_div_2ui(middle.get(), middle.get(), 1, MPFR_RNDN);
    const ExactRange t{middle, middle};
    const ExactRange there = evaluate(t).value - threshold_;
    if (there.maybeUndefined) return value;
    return common(value, there + whole.slope * (ExactRange{piece.from, piece.to} - t));
}

ExactLine::Answer ExactLine::hasSign(int sign, double from, double to, int most) {
    std::vector<Piece> open{{ExactNumber(from), ExactNumber(to)}};
    for (int left = most; !open.empty(); --left) {
        if (left <= 0) return Answer::open;
        const Piece piece = open.back();
        open.pop_back();
        const int side = sideOf(valueOver(piece));
        if (side == sign) continue;
        ExactNumber middle;
        mpfr_add(middle.get(), piece.from.get(), piece.to.get(), MPFR_RNDN);
        mpfr_div_2ui(middle.get(), middle.get(), 1, MPFR_RNDN);
        if (side == -sign || sideOf(evaluate({middle, middle}).value - threshold_) == -sign) {
            refutedAt_ = middle.rounded();
            return Answer::no;
        }
        if (mpfr_less_p(piece.from.get(), middle.get()) == 0) return Answer::open;
        if (mpfr_less_p(middle.get(), piece.to.get()) == 0) return Answer::open;
        open.push_back({middle, piece.to});
        open.push_back({piece.from, middle});
    }
    return Answer::yes;
}

const ExactJet& ExactLine::at(double t) { return evaluate(ExactRange(t)); }

bool ExactLine::isWithin(double limit) const {
    const auto isSize = [&](const ExactNumber& number) {
        if (mpfr_zero_p(number.get()) != 0) return true;
        const double size = std::abs(number.rounded());
        return 1 / limit < size && size < limit;
    };
    const auto within = [&](const ExactRange& range) { return isSize(range.low) && isSize(range.high); };
    return std::ranges::all_of(
        order_, [&](NodeId id) { return within(values_[id].value) && within(values_[id].slope); });
}

int ExactLine::signAt(double t) { return sideOf(at(t).value - threshold_); }

bool ExactLine::maybeUndefinedAt(double start, double length, double share) {
    return at(start, length, share).value.maybeUndefined;
}

ExactNumber ExactLine::placeIn(double start, double length, double share) const {
    ExactNumber t(share);
    mpfr_mul_d(t.get(), t.get(), length, MPFR_RNDN);
    mpfr_add_d(t.get(), t.get(), start, MPFR_RNDN);
    return t;
}

const ExactJet& ExactLine::at(double start, double length, double share) {
    const ExactNumber t = placeIn(start, length, share);
    return evaluate({t, t});
}

bool ExactLine::admits(double start, double length, double share, double center, double slope, double error) {
    const ExactRange value = at(start, length, share).value;
    if (value.maybeUndefined) return true;
    const ExactRange rest = value - ExactRange(center) - ExactRange(slope) * ExactRange(2 * share - 1);
    return mpfr_cmp_d(rest.low.get(), error) <= 0 && mpfr_cmp_d(rest.high.get(), -error) >= 0;
}

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/color_ramp_parser.h"

#include <algorithm>

#include "core/language/expression_parser.h"

namespace isoscope {

bool ColorRampParser::parse(ColorRamp& ramp) {
    if (!tokens_.expect("{", "to begin the colour map")) return false;
    ExpressionParser expressions(tokens_);
    while (tokens_.accept("[")) {
        ColorRamp::Entry entry;
        entry.position = expressions.parseFloat();
        tokens_.accept(",");
        entry.color = expressions.parseColor();
        ramp.entries.push_back(entry);
        if (!tokens_.expect("]", "to close the entry of the colour map")) break;
    }
    if (!tokens_.peek().is("}")) {
        tokens_.context().error("unexpected-token", tokens_.peek().range,
                                "Expected `[` or `}` in the colour map.");
        tokens_.skipBlock();
        return false;
    }
    tokens_.next();
    std::stable_sort(ramp.entries.begin(), ramp.entries.end(),
                     [](const auto& a, const auto& b) { return a.position < b.position; });
    return true;
}

Expression grayOf(const ColorRamp& ramp, Expression value) {
    return rampValue(ramp, value,
                     [](const Color& c) { return 0.297 * c.red + 0.589 * c.green + 0.114 * c.blue; });
}

Expression rampValue(const ColorRamp& ramp, Expression value, double (*pick)(const Color&)) {
    if (ramp.entries.empty()) return value.number(0);
    Expression result = value.number(pick(ramp.entries.back().color));
    for (std::size_t k = ramp.entries.size(); k-- > 0;) {
        const ColorRamp::Entry& entry = ramp.entries[k];
        Expression before = value.number(pick(entry.color));
        if (k > 0 && ramp.entries[k - 1].position < entry.position) {
            const double low = pick(ramp.entries[k - 1].color), start = ramp.entries[k - 1].position;
            const double slope = (pick(entry.color) - low) / (entry.position - start);
            before = low + slope * (value - start);
        }
        result = select(value - entry.position, before, result);
    }
    return result;
}

}  // namespace isoscope

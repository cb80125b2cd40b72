// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/argument_reader.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/language/expressions/parameter_collector.h"

namespace isoscope::virtualight {

ArgumentReader::ArgumentReader(TokenReader& tokens, const Names& names, const Token& name)
    : tokens_(tokens), names_(names), name_(name), range_(name.range), depth_(tokens.depth()) {
    failed_ = !tokens_.expect("(", "to begin the arguments of `" + std::string(name.text) + "`");
}

void ArgumentReader::separate() {
    if (!first_) expect(",", "between the arguments of `" + std::string(name_.text) + "`");
    first_ = false;
}

void ArgumentReader::expect(const char* symbol, const std::string& purpose) {
    if (failed_) return;
    failed_ = !tokens_.expect(symbol, purpose);
}

std::optional<double> ArgumentReader::unmoved(const std::string& what) {
    if (failed_) return std::nullopt;
    FormulaParser parser(tokens_, names_, std::string(name_.text), what);
    const std::optional<double> value = parser.parseNumber();
    range_ = parser.range();
    failed_ = !value;
    return value;
}

double ArgumentReader::coordinate(const std::string& what) {
    const std::optional<double> value = unmoved(what);
    if (value) ParameterCollector(tokens_.context()).addShapeNumbers(std::string(name_.text), what, range_);
    return value.value_or(0);
}

double ArgumentReader::number(const std::string& what) {
    separate();
    return coordinate(what);
}

double ArgumentReader::positive(const std::string& what) {
    const double value = number(what);
    if (!failed_ && !(value > 0)) {
        fail(range_, "The " + what + " of `" + std::string(name_.text) + "` must be greater than 0.");
        return 1;
    }
    return failed_ ? 1 : value;
}

int ArgumentReader::count(const std::string& what, int least, int most) {
    separate();
    const double value = unmoved(what).value_or(0);
    if (failed_) return least;
    ParameterCollector(tokens_.context()).addShapeCount(std::string(name_.text), what, least, most, range_);
    if (value != std::floor(value) || value < least || value > most) {
        fail(range_, "The " + what + " of `" + std::string(name_.text) + "` is a whole number from " +
                         std::to_string(least) + " to " + std::to_string(most) + ".");
        return least;
    }
    return static_cast<int>(value);
}

glm::dvec4 ArgumentReader::tuple(const std::string& what, bool mayHaveWeight) {
    if (failed_) return {0, 0, 0, 1};
    const SourceRange start = tokens_.peek().range;
    if (tokens_.peek().kind == TokenKind::word) {
        const DeclaredThing* thing = names_.find(tokens_.peek().text);
        if (const auto* declared = thing ? std::get_if<glm::dvec3>(thing) : nullptr) {
            tokens_.next();
            range_ = start;
            return {*declared, 1};
        }
    }
    expect("(", "to begin the " + what + " of `" + std::string(name_.text) + "`");
    glm::dvec4 point(0, 0, 0, 1);
    static constexpr const char* axes[] = {" x", " y", " z", " w"};
    for (int k = 0; k < 3; ++k) {
        if (k > 0) expect(",", "between the numbers of the " + what);
        point[k] = coordinate(what + axes[k]);
    }
    if (mayHaveWeight && accept(",")) point.w = coordinate(what + axes[3]);
    expect(")", "to close the " + what);
    range_ = tokens_.rangeFrom(start);
    return point;
}

glm::dvec3 ArgumentReader::point(const std::string& what) {
    separate();
    return glm::dvec3(tuple(what, false));
}

glm::dvec4 ArgumentReader::weighted(const std::string& what) {
    separate();
    return tuple(what, true);
}

glm::dvec3 ArgumentReader::direction(const std::string& what) {
    const glm::dvec3 value = point(what);
    if (failed_) return {0, 1, 0};
    if (glm::length(value) > 0) return value;
    fail(range_, "The " + what + " of `" + std::string(name_.text) + "` must have a length.");
    return {0, 1, 0};
}

std::string ArgumentReader::text(const std::string& what) {
    separate();
    if (failed_) return {};
    const Token token = tokens_.peek();
    range_ = token.range;
    if (token.kind != TokenKind::string) {
        fail(token.range, "Expected the " + what + " in quotes, but found " + described(token) + ".");
        return {};
    }
    tokens_.next();
    return std::string(rawString(token.text));
}

Function ArgumentReader::formula(unsigned allowed, bool keepSliders) {
    separate();
    if (failed_) return {};
    FormulaParser parser(tokens_, names_, std::string(name_.text), "function");
    const std::optional<Function> function = parser.parseFormula(keepSliders);
    range_ = parser.range();
    if (!function) {
        failed_ = true;
        return {};
    }
    if (const unsigned others = variablesOf(*function) & ~allowed) {
        fail(range_, "`" + nameOfVariable(others) + "` has no value in `" + std::string(name_.text) + "`.");
        return {};
    }
    return *function;
}

bool ArgumentReader::flag(const char* word) {
    if (failed_ || !tokens_.peek().is(",") || !tokens_.peek(1).is(word)) return false;
    tokens_.next();
    tokens_.next();
    return true;
}

void ArgumentReader::close() {
    if (!failed_) expect(")", "to close the arguments of `" + std::string(name_.text) + "`");
    if (failed_) tokens_.skipTo(depth_);
}

void ArgumentReader::fail(const SourceRange& range, const std::string& message, const std::string& hint) {
    if (!failed_) tokens_.context().error("bad-value", range, message, hint);
    failed_ = true;
}

void ArgumentReader::warn(const std::string& message, const std::string& hint) {
    if (!failed_) tokens_.context().warning("bad-value", range_, message, hint);
}

}  // namespace isoscope::virtualight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/isosurface_parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/function_parser.h"
#include "core/language/tokens/block_words.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

struct NumberItem {
    const char* word;
    double IsosurfaceSettings::*member;
    ParameterRole role;
    bool positive;
};

constexpr std::array<NumberItem, 3> numberItems{
    {{"threshold", &IsosurfaceSettings::threshold, ParameterRole::threshold, false},
     {"accuracy", &IsosurfaceSettings::accuracy, ParameterRole::accuracy, true},
     {"max_gradient", &IsosurfaceSettings::maxGradient, ParameterRole::maxGradient, true}}};

}  // namespace

bool IsosurfaceParser::parseItem(const std::optional<SourceRange>& modifiers) {
    hasItems_ |= modifiers.has_value();
    const Token word = tokens_.peek();
    if (tokens_.accept("function")) {
        parseFunction();
    } else if (parseOtherItem()) {
        hasItems_ = true;
        if (modifiers && hasFunction_)
            warnOfLateItem(tokens_, *modifiers, word,
                           "wants `" + std::string(word.text) +
                               "` before textures, transformations and other modifiers of an `isosurface`.");
    } else {
        return false;
    }
    lastItem_ = tokens_.lastRange();
    return true;
}

bool IsosurfaceParser::parseOtherItem() {
    if (tokens_.accept("contained_by"))
        parseContainer();
    else if (tokens_.accept("open"))
        settings_.open = true;
    else if (tokens_.accept("max_trace"))
        parseMaxTrace();
    else if (tokens_.accept("all_intersections"))
        settings_.maxTrace = 10;
    else if (tokens_.accept("evaluate"))
        parseEvaluate();
    else if (tokens_.accept("polarity")) {
        // Of POV-Ray 3.8; there it takes a sign or a word.
        settings_.positivePolarity = ExpressionParser(tokens_).parseFloat() > 0;
    } else
        return parseNumberItem();
    return true;
}

bool IsosurfaceParser::parseNumberItem() {
    for (std::size_t i = 0; i < numberItems.size(); ++i) {
        const NumberItem& entry = numberItems[i];
        if (!tokens_.accept(entry.word)) continue;
        given_[i] = true;
        const SourceRange start = tokens_.peek().range;
        const double value = ExpressionParser(tokens_).parseFloat();
        const SourceRange range = rangeSince(start, tokens_);
        if (!std::isfinite(value) || (entry.positive && !(value > 0))) {
            tokens_.context().error("bad-value", range,
                                    "`" + std::string(entry.word) + "` must be " +
                                        (entry.positive ? "a number greater than 0." : "a finite number."));
            return true;
        }
        settings_.*entry.member = value;
        parameters_.addSetting(entry.role, entry.word, value, range);
        return true;
    }
    return false;
}

void IsosurfaceParser::parseFunction() {
    FunctionParser functions(tokens_);
    const SourceRange word = tokens_.lastRange();
    const Token named = tokens_.peek();
    if (hasFunction_)
        warnOfRefusal(tokens_.context(), word, "takes one `function` in an `isosurface`.",
                      "leave one of them out");
    if (hasItems_ && !hasFunction_)
        tokens_.context().warning("function-not-first", word,
                                  "POV-Ray wants `function` first in an `isosurface`.",
                                  "move it in front of the other items");
    const FunctionValue value = functions.parseFormula();
    hasFunction_ = true;
    functionRange_ = functions.bodyRange();
    functionText_ = std::string(tokens_.context().sources.slice(functionRange_));
    written_ = value.written;
    settings_.function = {};
    if (!value.function.valid()) return;
    if (value.function.results.size() != 1 || value.function.argumentCount != 3) {
        tokens_.context().error("wrong-function", rangeSince(word, tokens_),
                                "An isosurface needs a function of x, y and z that gives one number.");
        return;
    }
    settings_.function = value.function;
    if (named.is("("))
        warnOfRefusal(tokens_.context(), named.range,
                      "takes no names of arguments here: they are x, y and z.", "leave them out");
}

void IsosurfaceParser::parseContainer() {
    if (!tokens_.expect("{", "to begin `contained_by`")) return;
    const SourceRange opened = tokens_.lastRange();
    if (tokens_.accept("sphere"))
        parseSphere();
    else if (tokens_.accept("box"))
        parseBox();
    else {
        const Token word = tokens_.peek();
        reportUnknownWord(tokens_.context(), "unexpected-token", word,
                          "Expected `sphere` or `box` in `contained_by`, but found " + describe(word) + ".",
                          "contained_by", [] { return wordsOfBlock("contained_by"); });
        return tokens_.skipBlock();
    }
    if (!tokens_.accept("}")) {
        tokens_.context().error("unexpected-token", tokens_.peek().range,
                                "Expected `}` to close `contained_by`.");
        return tokens_.skipBlock();
    }
    const SourceRange closed = tokens_.lastRange();
    if (opened.file == closed.file) containerRange_ = {opened.file, opened.end, closed.begin};
}

glm::dvec3 IsosurfaceParser::parseCorner(const std::string& name) {
    const SourceRange start = tokens_.peek().range;
    const glm::dvec3 corner = ExpressionParser(tokens_).parseVector();
    parameters_.addContainerNumbers(name, rangeSince(start, tokens_));
    return corner;
}

void IsosurfaceParser::parseSphere() {
    if (!tokens_.expect("{", "to begin `sphere`")) return;
    ContainerSphere sphere;
    sphere.center = parseCorner("center");
    tokens_.accept(",");
    const SourceRange start = tokens_.peek().range;
    sphere.radius = ExpressionParser(tokens_).parseFloat();
    const SourceRange range = rangeSince(start, tokens_);
    parameters_.addContainerNumbers("radius", range);
    if (!(std::abs(sphere.radius) > 0) || !std::isfinite(sphere.radius))
        tokens_.context().error("bad-value", range,
                                "The radius of a container must be a number other than 0.");
    else
        settings_.container = ContainerSphere{sphere.center, std::abs(sphere.radius)};
    if (!tokens_.accept("}")) {
        tokens_.context().error("unexpected-token", tokens_.peek().range, "Expected `}` to close `sphere`.");
        tokens_.skipBlock();
    }
}

void IsosurfaceParser::parseBox() {
    if (!tokens_.expect("{", "to begin `box`")) return;
    const glm::dvec3 first = parseCorner("first corner");
    tokens_.accept(",");
    const glm::dvec3 second = parseCorner("second corner");
    settings_.container = ContainerBox{glm::min(first, second), glm::max(first, second)};
    if (!tokens_.accept("}")) {
        tokens_.context().error("unexpected-token", tokens_.peek().range, "Expected `}` to close `box`.");
        tokens_.skipBlock();
    }
}

void IsosurfaceParser::parseEvaluate() {
    std::array<double, 3> numbers{};
    const SourceRange start = tokens_.lastRange();
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (k > 0) tokens_.accept(",");
        numbers[k] = ExpressionParser(tokens_).parseFloat();
    }
    if (numbers[0] > 0 && numbers[1] >= 1 && numbers[2] > 0 && numbers[2] <= 1)
        settings_.evaluate = numbers;
    else
        tokens_.context().warning(
            "bad-value", rangeSince(start, tokens_),
            "`evaluate` needs a bound above 0, a factor of at least 1 and one between 0 and 1; it is "
            "ignored.");
}

void IsosurfaceParser::parseMaxTrace() {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    if (!(value >= 1 && value <= 10))
        tokens_.context().warning("bad-value", rangeSince(start, tokens_), "`max_trace` must be 1 to 10.");
    settings_.maxTrace = static_cast<int>(std::clamp(std::isfinite(value) ? value : 1.0, 1.0, 10.0));
}

void IsosurfaceParser::keepNames(int number) {
    ParseContext& context = tokens_.context();
    if (number != context.options.namesOfIsosurface) return;
    for (const std::string& name : context.symbols.names())
        context.namesAtIsosurface[name] = *context.symbols.find(name);
}

/// Settings that are left out get sliders too. They would stand behind the last item, since those of the
/// object must come later.
void IsosurfaceParser::offerSettings() {
    for (std::size_t i = 0; i < numberItems.size() && hasFunction_; ++i)
        if (!given_[i])
            parameters_.addImpliedSetting(numberItems[i].role, numberItems[i].word,
                                          settings_.*numberItems[i].member, lastItem_);
}

void IsosurfaceParser::finish(ObjectDescription& description, const SourceRange& start) {
    const int number = tokens_.context().isosurfaceCount++;
    keepNames(number);
    offerSettings();
    if (!hasFunction_) {
        if (!excused_)
            tokens_.context().error("missing-function", start, "An `isosurface` needs a `function { ... }`.");
        return;
    }
    if (!settings_.function.valid()) {
        reportLeftOut(tokens_.context(), start,
                      "The isosurface is not drawn: its function was not understood.");
        return;
    }
    const auto shape = std::make_shared<const Isosurface>(settings_);
    description.shape = shape;
    description.isosurface = IsosurfaceStatement{shape,    description.range, functionRange_, functionText_,
                                                 written_, containerRange_,   number};
}

}  // namespace isoscope

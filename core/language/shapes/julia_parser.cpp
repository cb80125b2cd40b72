// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/isosurface/julia_fractal.h"

namespace isoscope {

namespace {

struct FunctionWord {
    const char* word;
    JuliaFunction function;
};

constexpr std::array<FunctionWord, 17> functionWords{{{"sqr", JuliaFunction::sqr},
                                                      {"cube", JuliaFunction::cube},
                                                      {"exp", JuliaFunction::exp},
                                                      {"reciprocal", JuliaFunction::reciprocal},
                                                      {"sin", JuliaFunction::sin},
                                                      {"asin", JuliaFunction::asin},
                                                      {"sinh", JuliaFunction::sinh},
                                                      {"asinh", JuliaFunction::asinh},
                                                      {"cos", JuliaFunction::cos},
                                                      {"acos", JuliaFunction::acos},
                                                      {"cosh", JuliaFunction::cosh},
                                                      {"acosh", JuliaFunction::acosh},
                                                      {"tan", JuliaFunction::tan},
                                                      {"atan", JuliaFunction::atan},
                                                      {"tanh", JuliaFunction::tanh},
                                                      {"atanh", JuliaFunction::atanh},
                                                      {"ln", JuliaFunction::ln}}};

bool parseFunction(ShapeReader& reader, JuliaSettings& settings) {
    TokenStream& tokens = reader.tokens();
    for (const FunctionWord& entry : functionWords)
        if (tokens.accept(entry.word)) {
            settings.function = entry.function;
            return true;
        }
    if (!tokens.accept("pwr")) return false;
    settings.function = JuliaFunction::pwr;
    tokens.expect("(", "and the two parts of the exponent");
    const double real = reader.number("exponent x");
    settings.exponent = {real, reader.number("exponent y")};
    tokens.expect(")", "to close the exponent");
    return true;
}

bool parseItem(ShapeReader& reader, JuliaSettings& settings) {
    TokenStream& tokens = reader.tokens();
    if (tokens.accept("quaternion")) {
        settings.algebra = JuliaAlgebra::quaternion;
    } else if (tokens.accept("hypercomplex")) {
        settings.algebra = JuliaAlgebra::hypercomplex;
    } else if (tokens.accept("max_iteration")) {
        constexpr int iterationLimit = 10'000;
        settings.maxIteration = reader.count("max_iteration", 1, iterationLimit);
        warnOfLastComma(tokens);
    } else if (tokens.accept("precision")) {
        settings.precision = reader.number("precision");
    } else if (tokens.accept("slice")) {
        settings.slice = reader.quadruple("slice");
        if (settings.slice.w == 0)
            reader.fail(reader.range(),
                        "The fourth component of the slice of a `julia_fractal` must not be 0.");
        settings.sliceDistance = reader.number("slice distance");
    } else {
        return parseFunction(reader, settings);
    }
    return true;
}

ShapePointer parseJuliaFractal(ShapeReader& reader) {
    JuliaSettings settings;
    settings.parameter = reader.quadruple("parameter");
    while (parseItem(reader, settings)) continue;
    const bool simple = settings.function == JuliaFunction::sqr || settings.function == JuliaFunction::cube;
    if (settings.algebra == JuliaAlgebra::quaternion && !simple)
        reader.fail(reader.keywordRange(), "Quaternions know only `sqr` and `cube`.",
                    "write `hypercomplex` for the other functions");
    if (reader.failed() || !reader.finite()) return nullptr;
    return std::make_shared<JuliaFractal>(settings);
}

}  // namespace

std::span<const ShapeParser> juliaParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "julia_fractal",
                    .parse = parseJuliaFractal,
                    .words = "quaternion hypercomplex max_iteration precision slice sqr cube exp",
                    .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/shapes/patches/bicubic_patch.h"

namespace isoscope {

namespace {

ShapePointer parseBicubicPatch(ShapeReader& reader) {
    TokenStream& tokens = reader.tokens();
    std::array<glm::dvec2, 4> corners = BicubicPatch::wholeSquare;
    double type = 0, flatness = 0, uSteps = 0, vSteps = 0;
    for (;;) {
        if (tokens.accept("type")) {
            type = reader.number("type");
            if (type != 0 && type != 1) reader.fail(reader.range(), "The type of a bicubic patch is 0 or 1.");
        } else if (tokens.accept("flatness")) {
            flatness = reader.number("flatness");
        } else if (tokens.accept("u_steps")) {
            uSteps = reader.number("u_steps");
        } else if (tokens.accept("v_steps")) {
            vSteps = reader.number("v_steps");
        } else if (tokens.accept("accuracy")) {
            reader.number("accuracy");
        } else if (tokens.accept("uv_vectors")) {
            for (glm::dvec2& corner : corners) corner = reader.pair("uv");
        } else {
            break;
        }
    }
    BicubicPatch::Points points;
    std::size_t count = 0;
    while (count < points.size() && ExpressionParser(tokens).atExpression()) {
        points[count] = reader.vector("point " + std::to_string(count + 1));
        ++count;
    }
    if (count < points.size())
        reader.fail(rangeSince(reader.keywordRange(), tokens),
                    "A bicubic patch has 16 points, but here are " + std::to_string(count) + ".");
    if (reader.failed() || !reader.finite()) return nullptr;
    const auto steps = [](double value) { return static_cast<int>(std::clamp(std::floor(value), 0.0, 8.0)); };
    return std::make_shared<BicubicPatch>(points, steps(uSteps), steps(vSteps), flatness, corners);
}

}  // namespace

std::span<const ShapeParser> bicubicParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "bicubic_patch",
                    .parse = parseBicubicPatch,
                    .words = "type flatness u_steps v_steps uv_vectors",
                    .ignoresOwnBounds = true},
    };
    return parsers;
}

}  // namespace isoscope

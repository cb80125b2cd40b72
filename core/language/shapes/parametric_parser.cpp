// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/function_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/shape_reader.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/shapes/isosurface/parametric.h"

namespace isoscope {

namespace {

class ParametricReader {
  public:
    explicit ParametricReader(ShapeReader& reader) : reader_(reader), tokens_(reader.tokens()) {}

    ShapePointer parse() {
        for (Function& function : settings_.functions) function = parseFunction();
        if (reader_.failed()) return nullptr;
        settings_.low = reader_.pair("first corner of u and v");
        settings_.high = reader_.pair("second corner of u and v");
        while (parseItem()) continue;
        if (reader_.failed() || !reader_.finite() || leftOut_) return nullptr;
        return std::make_shared<Parametric>(settings_);
    }

  private:
    Function parseFunction() {
        if (!tokens_.accept("function")) {
            reader_.fail(
                tokens_.peek().range,
                "Expected the `function` of a coordinate, but found " + describe(tokens_.peek()) + ".",
                "a `parametric` begins with three functions of u and v, for x, y and z");
            return {};
        }
        const SourceRange word = tokens_.lastRange();
        FunctionValue value = FunctionParser(tokens_).parseFormula();
        if (tokens_.accept(",") && !tokens_.peek().is("function")) warnOfLastComma(tokens_);
        if (!value.function.valid()) {
            reportLeftOut(tokens_.context(), word,
                          "The parametric surface is not drawn: a function of it was "
                          "not understood.");
            leftOut_ = true;
            return {};
        }
        if (value.function.results.size() != 1 || value.function.argumentCount > 3)
            reader_.fail(word, "A parametric surface needs functions of u and v that give one number each.");
        return value.function;
    }

    bool parseItem() {
        if (tokens_.accept("contained_by")) {
            parseContainer();
        } else if (tokens_.accept("accuracy")) {
            settings_.accuracy = reader_.number("accuracy");
        } else if (tokens_.accept("max_gradient")) {
            settings_.maxGradient = reader_.number("max_gradient");
        } else if (tokens_.accept("precompute")) {
            // POV-Ray prepares tables of these coordinates; nothing of it is seen in the picture.
            reader_.count("depth of `precompute`", 1, 20);
            while (tokens_.accept("x") || tokens_.accept("y") || tokens_.accept("z")) tokens_.accept(",");
        } else {
            return false;
        }
        return true;
    }

    void parseContainer() {
        if (!tokens_.expect("{", "to begin `contained_by`")) return;
        const Token kind = tokens_.next();
        if (!kind.is("box") && !kind.is("sphere")) {
            reader_.fail(kind.range,
                         "Expected `sphere` or `box` in `contained_by`, but found " + describe(kind) + ".");
            return tokens_.skipBlock();
        }
        if (tokens_.expect("{", "to begin the container")) {
            if (kind.is("box"))
                parseBox();
            else
                parseSphere();
            tokens_.expect("}", "to close the container");
        }
        tokens_.expect("}", "to close `contained_by`");
    }

    void parseBox() {
        const glm::dvec3 first = reader_.vector("first corner of the container");
        settings_.container = ContainerBox{first, reader_.vector("second corner of the container")};
    }

    void parseSphere() {
        const glm::dvec3 center = reader_.vector("center of the container");
        settings_.container = ContainerSphere{center, reader_.number("radius of the container")};
    }

    ShapeReader& reader_;
    TokenStream& tokens_;
    ParametricSettings settings_;
    bool leftOut_ = false;
};

ShapePointer parseParametric(ShapeReader& reader) { return ParametricReader(reader).parse(); }

}  // namespace

std::span<const ShapeParser> parametricParser() {
    static constexpr std::array parsers{
        ShapeParser{.keyword = "parametric",
                    .parse = parseParametric,
                    .words = "function contained_by accuracy max_gradient precompute"},
    };
    return parsers;
}

}  // namespace isoscope

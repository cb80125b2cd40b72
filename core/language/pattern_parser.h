// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/function/pattern.h"
#include "core/language/function_scope.h"
#include "core/language/color_ramp_parser.h"
#include "core/language/token_stream.h"

namespace isoscope {

/// The block of `pattern { NAME modifiers }` as a function of x, y, z (spec/patterns.md).
class PatternParser {
  public:
    PatternParser(TokenStream& tokens, FunctionScope& scope) : tokens_(tokens), scope_(scope) {}

    /// From the `{` to the `}`; the word `pattern` has been read. The node of the value, or nothing after a
    /// mistake and for patterns that are left out; the block is left behind in both cases.
    std::optional<NodeId> parse();
    /// The same for a pigment: red, green, blue, filter and transmit, or nothing. Plain colours and patterns
    /// with a colour map or a list of colours are understood.
    std::vector<NodeId> parsePigment();

  private:
    bool parseName();
    bool parseSpecialName(const Token& name);
    void parseNameArguments();
    bool parseFractal(const Token& name);
    bool parseMagnet();
    bool parseFunctionPattern();
    bool parseObjectPattern();
    bool parsePigmentPattern();
    bool parsePigmentBody(ColorRamp& ramp, bool& plain);
    bool parseColors(ColorRamp& ramp);
    bool parseModifier();
    bool parseWave(const Token& word);
    bool parseCrackleModifier(const Token& word);
    bool parseFractalModifier(const Token& word);
    bool parseShapeModifier(const Token& word);
    bool parseGeneralModifier(const Token& word);
    FractalColoring parseColoring();
    NodeId build();
    bool leaveOut(const Token& word);

    TokenStream& tokens_;
    FunctionScope& scope_;
    Pattern pattern_;
};

}  // namespace isoscope

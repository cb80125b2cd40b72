// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/pattern.h"
#include "core/language/token_stream.h"

namespace isoscope {

/// The pattern of a `pattern`, `pigment`, `normal` or `texture` block, item by item: its name with what
/// belongs to it, and its modifiers (spec/patterns.md).
class PatternReader {
  public:
    explicit PatternReader(TokenStream& tokens) : tokens_(tokens) {}

    /// Whether the name of a pattern comes next.
    bool atName() const;
    /// Reads it with its arguments. False when it is none or not understood: that has been reported.
    /// `average`, which only maps know, is not read here.
    bool parseName();
    /// Reads a modifier, if one comes next: turbulence, frequency, wave types, warps, transformations...
    bool parseModifier();
    /// Reads over the name of a pattern that is left out, with its arguments.
    void skipLeftOut();

    Pattern pattern;

  private:
    bool parseSpecialName(const Token& name);
    void parseNameArguments();
    bool parseFractal(const Token& name);
    bool parseMagnet();
    bool parseFunctionPattern();
    bool parseObjectPattern();
    bool parsePigmentPattern();
    bool parseWave(const Token& word);
    bool parseCrackleModifier(const Token& word);
    bool parseFractalModifier(const Token& word);
    bool parseShapeModifier(const Token& word);
    bool parseGeneralModifier(const Token& word);
    FractalColoring parseColoring();

    TokenStream& tokens_;
};

/// Whether the word names a pattern that is read over and not simulated (`tiling`, `slope`, ...).
bool isPatternLeftOut(std::string_view word);

}  // namespace isoscope

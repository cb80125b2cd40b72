// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/language/tokens/token_stream.h"

namespace isoscope {

class DirectiveScope;

/// The directives that give names a meaning: `#declare`, `#local`, `#undef` and `#macro`.
class DefinitionReader {
  public:
    /// `directive` is the range of the `#` and its word.
    DefinitionReader(TokenStream& tokens, const SourceRange& directive)
        : tokens_(tokens), directive_(directive) {}

    /// What follows `#declare` or `#local`: `NAME = value;`, `NAME[i] = value;` or `NAME.x = value;`, more of
    /// them behind commas.
    void declare(bool local, DirectiveScope& scope);
    void undefine();

    /// `NAME(parameters)` behind `#macro`.
    void macroHead();
    /// Declares the macro whose head was read; its body ends where `end`, the `#` of its `#end`, begins.
    void defineMacro(const SourceRange& end, bool closed);

  private:
    struct Target;
    bool readTarget(Target& target);
    void assign(const Target& target, Value value, bool local);
    void assignComponent(const Target& target, const Value& value);
    /// True when the value is a number or a vector.
    bool readOne(bool local, DirectiveScope& scope);
    void skipRest();
    /// Up to the next `;`, or the end of the line in which `start` begins.
    void skipLine(const SourceRange& start);
    /// Makes a slider of a literal that a name of the user's own text stands for; the index for the
    /// NumberValue.
    int sliderFor(const std::string& name, double value, const SourceRange& literal);
    bool mayBeSlider(bool local, const Target& target, const SourceRange& literal) const;
    void noteCounter(const std::string& name);
    bool isInLoop() const;

    TokenStream& tokens_;
    SourceRange directive_;
    MacroValue macro_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Calls a macro: reads the arguments and makes its body the text that is read next. An argument that is
/// nothing but a declared name, or an element of a declared array, is handed over by reference; any other by
/// value.
class MacroCaller {
  public:
    explicit MacroCaller(TokenStream& tokens) : tokens_(tokens) {}

    /// The macro that `name` stands for, or null.
    static std::shared_ptr<const MacroValue> find(const SymbolTable& symbols, std::string_view name);

    /// `name` has been taken; its `(` follows.
    void call(const Token& name, const MacroValue& macro);

  private:
    struct Argument {
        std::string reference;              ///< the name that is handed over
        std::shared_ptr<ArrayValue> array;  ///< or the array of the element that is
        std::size_t element = 0;
        Value value;
    };
    bool readArguments(const Token& name, const MacroValue& macro, std::vector<Argument>& arguments);
    bool readReference(Argument& argument);
    Argument readArgument();
    void bind(const MacroValue& macro, std::vector<Argument>& arguments);

    TokenStream& tokens_;
};

}  // namespace isoscope

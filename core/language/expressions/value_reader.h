// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/language/tokens/token_stream.h"

namespace isoscope {

/// Reads a value of any kind: what may stand behind `#declare NAME =`, in a macro's argument, in an array.
class ValueReader {
  public:
    explicit ValueReader(TokenStream& tokens) : tokens_(tokens) {}

    /// Empty after a mistake, which has been reported. When the value is nothing but a number literal, its
    /// range, sign included, is stored in `literal`.
    std::optional<Value> read(std::optional<SourceRange>* literal = nullptr);

  private:
    std::optional<Value> readArray();
    bool readElements(ArrayValue& array, std::size_t dimension, std::size_t& next);
    std::optional<Value> readNamed(const Token& name, const Value& value,
                                   std::optional<SourceRange>* literal);
    /// Takes from the step budget what a copy of the value costs; false when that is spent.
    bool pay(const Value& value);
    std::optional<Value> paid(std::optional<Value> value);

    TokenStream& tokens_;
};

}  // namespace isoscope

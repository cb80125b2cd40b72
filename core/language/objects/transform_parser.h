// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/language/tokens/token_stream.h"
#include "core/shapes/transform.h"

namespace isoscope {

/// The statements that move things: `translate`, `rotate`, `scale`, `matrix` and `transform`.
class TransformParser {
  public:
    explicit TransformParser(TokenStream& tokens) : tokens_(tokens) {}

    /// Reads one of them, if it comes next, and appends it to `transform`; false when something else comes
    /// next.
    bool parseModifier(Transform& transform);
    /// The block of `transform { ... }` behind its `{`, with the `}`: statements, names of declared
    /// transforms, `inverse`.
    Transform parseBlock();

  private:
    Transform parseMatrix();
    Transform parseScale();
    /// Behind the word `transform`: a block or a name.
    Transform parseTransform();
    bool appendDeclared(Transform& transform);

    TokenStream& tokens_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/language/scene_draft.h"
#include "core/scene/camera_statement.h"

namespace isoscope {

/// `camera { ... }`. Left out and reported are mesh cameras, `bokeh`, and a `normal` whose pattern needs a
/// surface.
class CameraParser {
  public:
    /// Lists of the words that may begin an item of the block, for "did you mean".
    static const std::array<const char*, 3> itemWords;

    explicit CameraParser(TokenStream& tokens) : tokens_(tokens) {}

    /// The block with its braces; the word `camera` has been read.
    Camera parse();

  private:
    bool parseItem(CameraStatement& statement);
    bool parseVectorItem(CameraStatement& statement);
    bool parseKind(CameraStatement& statement);
    bool parseCylinder(CameraStatement& statement);
    bool parseBlur(CameraStatement& statement);
    bool parseNormal(CameraStatement& statement);
    bool parseLeftOut();
    bool startFromDeclared(CameraStatement& statement);

    TokenStream& tokens_;
};

}  // namespace isoscope

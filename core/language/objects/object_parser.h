// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/language/objects/object_description.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/scene_draft.h"

namespace isoscope {

class IsosurfaceParser;

/// Object statements: `isosurface`, the shapes of findShapeParser(), CSG, `object`, with their modifiers.
/// Objects that are not drawn yet are skipped and reported; what stands around them is read all the same.
class ObjectParser {
  public:
    ObjectParser(TokenStream& tokens, SceneDraft& draft) : tokens_(tokens), draft_(draft) {}

    /// Whether the word begins an object statement, drawn or not.
    static bool isObject(std::string_view word);
    /// The statement that the next token begins, which may be `looks_like` too. Null when it cannot be drawn;
    /// that has been reported.
    ObjectPointer parse();
    /// A declared object or light by its name alone, without `object`, if that comes next: it takes no
    /// modifiers. Null when it is not drawn.
    std::optional<ObjectPointer> parseName();

  private:
    struct Statement;

    ObjectPointer parseDrawn(const Token& keyword);
    ObjectPointer skipNotDrawn(const Token& keyword);
    void parseContents(Statement& statement);
    void parseShape(Statement& statement, const ShapeParser& parser);
    void parseParts(Statement& statement);
    bool parsePart(Statement& statement);
    void addPart(Statement& statement, const ObjectPointer& part);
    /// A light with what it looks like; the word `light_source` has been read.
    void addLight(Statement& statement);
    /// Counts what `part` adds to the statement; false when that is too much.
    bool grow(Statement& statement, const ObjectDescription& part);
    void parseObjectContents(Statement& statement);
    bool startFromDeclared(Statement& statement);
    /// The name of a declared light, if that comes next.
    bool takeLight(Statement& statement);
    void take(Statement& statement, const ObjectPointer& object);
    ObjectPointer finish(Statement& statement);

    bool parseModifier(Statement& statement);
    bool parseTransform(Statement& statement);
    bool parseTexture(Statement& statement);
    bool parseInterior(Statement& statement);
    bool parseFlag(Statement& statement);
    bool parseWrapping(Statement& statement);
    /// The next object of a WrappingModifier, null when it is not drawn; nothing when none comes.
    std::optional<ObjectPointer> parseClippingObject();
    bool parseIgnored(Statement& statement);

    TokenStream& tokens_;
    SceneDraft& draft_;
};

}  // namespace isoscope

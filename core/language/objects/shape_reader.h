// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "core/language/scene_draft.h"

namespace isoscope {

/// What the parsers of shapes read with: numbers that become sliders and are checked, and the words behind
/// them. The opening brace of the statement has been read; the closing one is left for ObjectParser, with the
/// object modifiers in front of it.
class ShapeReader {
  public:
    ShapeReader(TokenStream& tokens, SceneDraft& draft, const Token& keyword)
        : tokens_(tokens), draft_(draft), keyword_(keyword) {}

    /// A float or vector, and a comma behind it if there is one. `name` is what its sliders are called,
    /// "radius".
    double number(const std::string& name);
    glm::dvec2 pair(const std::string& name);
    glm::dvec3 vector(const std::string& name);
    glm::dvec4 quadruple(const std::string& name);
    /// A whole number; one outside least to most is an error, and the nearer end is the answer.
    int count(const std::string& name, int least, int most);
    /// A comma may stand behind the last of its numbers, in POV-Ray too; it is warned of in other shapes.
    void allowLastCommas() { lastCommas_ = true; }
    /// Whether the word comes next; it is taken, with the `on` or `off` behind it.
    bool flag(const char* word, bool& value);
    /// Takes the `{` of a part of the shape, as TokenStream::expect() does. False without one: then no shape
    /// is made.
    bool opens(const std::string& part);

    /// Reports an error of the statement; no shape is made of it then. Only the first one is told: others may
    /// follow from it.
    void fail(const SourceRange& range, const std::string& message, const std::string& hint = {});
    /// The same as a warning: the shape is made all the same.
    void warn(const SourceRange& range, const std::string& message, const std::string& hint = {});
    /// Whether an error has been reported through this reader.
    bool failed() const { return failed_; }
    /// Whether a number was infinite or NaN; ObjectParser says so.
    bool finite() const { return finite_; }

    /// Textures of parts of the shape, in its own coordinates; Shape::textureShares calls them 1, 2, ...
    std::vector<Material> textures;

    /// For words and blocks that the functions above do not read.
    TokenStream& tokens() { return tokens_; }
    SceneDraft& draft() { return draft_; }
    /// The word that begins the statement, "lathe", and its place.
    std::string keyword() const { return std::string(keyword_.text); }
    const SourceRange& keywordRange() const { return keyword_.range; }
    /// Range of what was read last with one of the functions above.
    const SourceRange& range() const { return range_; }

  private:
    void parseComma();
    /// A vector of `count` components; a float stands for all of them.
    std::array<double, 5> components(const std::string& name, int count);

    TokenStream& tokens_;
    SceneDraft& draft_;
    Token keyword_;
    SourceRange range_;
    bool failed_ = false;
    bool finite_ = true;
    bool lastCommas_ = false;
};

}  // namespace isoscope

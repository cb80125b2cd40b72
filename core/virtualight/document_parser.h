// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/virtualight/names.h"
#include "core/virtualight/primitive_parser.h"
#include "core/virtualight/token_reader.h"

namespace isoscope::virtualight {

/// Statements of a VirtuaLight text: `static`, `Declare`, `Shape [ ... ]`, `Solid [ ... ]`. What the text
/// asks for and this program does not simulate (shaders, cameras, lights) is reported as left out; mistakes
/// are reported and passed over. Never throws.
class DocumentParser {
  public:
    DocumentParser(ParseContext& context, std::uint32_t file);

    /// Reads the whole text, once; what was wrong or left out is in the context's diagnostics.
    Document parse();

  private:
    void parseStatement();
    void parseStatic();
    void parseDeclare();
    std::optional<DeclaredThing> parseDeclared(const Token& name);
    std::optional<DeclaredThing> parsePointOrFormula(const Token& name);
    DeclaredNumber numberWithSlider(const Token& name, double value, const SourceRange& range);
    void declareNode(const Token& name, NodePointer node);
    bool atOther();
    /// Passes over something that is not simulated, says so, and returns its word.
    std::string skipOther();

    NodePointer parseObject();
    NodePointer parseShape();
    bool parseContents(Node& node);
    NodePointer parseSolid();
    NodePointer parseSums();
    NodePointer parseProducts();
    NodePointer parseFactor();
    NodePointer parseNamed();
    NodePointer joined(SetOperation operation, NodePointer first, NodePointer second,
                       const SourceRange& start);

    void parseModifiers(Node& node);
    bool parseModifier(Node& node);
    bool parseTransform(Node& node);
    bool parseSolver(Node& node);
    void parseBound(Node& node, const Token& word);
    void parseRenderBound(Node& node, const Token& word);
    void parseSubdivision(Node& node, const Token& word);
    void closeStructure(const Token& word, std::size_t depth);
    NodePointer finished(Node node);

    ParseContext& context_;
    TokenReader tokens_;
    Names names_;
    Document document_;
};

}  // namespace isoscope::virtualight

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/language/scene_draft.h"
#include "core/language/textures/pattern_reader.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/scene/surface_normal.h"

namespace isoscope {

using NormalPointer = std::shared_ptr<const SurfaceNormal>;

/// `normal { ... }` with its patterns, `normal_map` and `slope_map`. A normal that is not simulated
/// (`projection`) leaves the surface smooth and is named in leftOut().
class NormalParser {
  public:
    /// Entries of maps and lists begin from `defaults`, the normal of #default.
    explicit NormalParser(TokenStream& tokens, NormalPointer defaults = nullptr)
        : tokens_(tokens), reader_(tokens), defaults_(std::move(defaults)) {}

    /// The block with its braces, beginning from `start` (null: a smooth surface); the word `normal` has been
    /// read.
    NormalPointer parse(const NormalPointer& start);
    /// The block of `normal_map` or `slope_map`, to be declared: a normal without a pattern.
    NormalPointer parseMap(std::string_view word);
    /// What was read and is not simulated, by the words of the language.
    const std::vector<std::string>& leftOut() const { return leftOut_; }

  private:
    void start(const SurfaceNormal& normal);
    void parseBody(std::string_view end);
    bool parseItem();
    bool parsePattern();
    void parseAmount();
    SurfaceNormal& settings();
    SurfaceNormal& patterned();
    void parseBumpMap();
    bool parseSetting();
    bool parseListItem();
    bool parseMaps();
    void parseNormalMap();
    void parseSlopeMap();
    bool closeMap(std::string_view what);
    NormalPointer result();

    TokenStream& tokens_;
    PatternReader reader_;
    NormalPointer defaults_;
    std::optional<SurfaceNormal> normal_;
    bool ownEntries_ = false;
    bool failed_ = false;  ///< whether something in the block was not understood
    ItemOrder order_{"normal"};
    std::vector<std::string> leftOut_;
};

}  // namespace isoscope

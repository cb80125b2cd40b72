// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/scene_draft.h"
#include "core/language/textures/pattern_reader.h"
#include "core/language/tokens/povray_refusals.h"

namespace isoscope {

/// `pigment { ... }`: a colour, or a pattern with its map. Patterns that are not simulated stand as one
/// colour, the mean of those that the map names, and SolidPigment::standsFor says what it was.
class PigmentParser {
  public:
    explicit PigmentParser(TokenStream& tokens) : tokens_(tokens), reader_(tokens) {}

    /// The block with its braces, beginning from `start`; the word `pigment` has been read.
    Pigment parse(const Pigment& start);
    /// The block of `color_map`, `pigment_map` and the like with its braces, to be declared: a pigment
    /// without a pattern.
    Pigment parseMap(std::string_view word);
    /// Whether there was a mistake; it has been reported.
    bool failed() const { return failed_; }

    /// Whether the word begins a map of pigments or colours.
    static bool isMap(std::string_view word);

  private:
    void start(const Pigment& pigment);
    void parseBody(std::string_view end);
    bool parseItem();
    bool startFromDeclared();
    bool parsePattern();
    bool parseColorSetting();
    bool parseColor();
    bool parseOpenList();
    bool parseListItem();
    bool parseOther();
    bool parseMapBlock(bool colors);
    bool parseMapEntry(bool colors);
    void parseColorEntry();
    bool mapFailed();
    bool isList() const { return mapped_ && mapped_->kind == MapKind::list; }
    Pigment result();

    TokenStream& tokens_;
    PatternReader reader_;
    SolidPigment solid_;
    std::optional<MappedPigment> mapped_;
    bool listsColors_ = false;  ///< the last entry of its list is a colour
    bool ownEntries_ = false;   ///< the entries are of this block, not of the pigment that it began from
    ItemOrder order_{"pigment"};
    std::string leftOut_;     ///< the pattern that is not simulated
    bool onSurface_ = false;  ///< `uv_mapping`
    bool plain_ = false;      ///< begun from a colour, or a declared pigment of one
    bool fixed_ = false;      ///< begun from a declared pigment with `uv_mapping`
    bool failed_ = false;
};

/// What is not simulated of a pigment, by the words of the language; empty when all is.
std::vector<std::string> notSimulatedIn(const Pigment& pigment);

/// The pigment moved along with its object.
Pigment moved(const Pigment& pigment, const Transform& transform);

}  // namespace isoscope

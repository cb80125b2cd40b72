// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/function/patterns/pattern.h"
#include "core/language/tokens/token_stream.h"
#include "core/texture/tables/density_table.h"

namespace isoscope {

/// The pattern of a `pattern`, `pigment`, `normal` or `texture` block, item by item: its name with what
/// belongs to it, and its modifiers (docs/povray/patterns.md).
class PatternReader {
  public:
    explicit PatternReader(TokenStream& tokens) : tokens_(tokens) {}

    /// Whether the name of a pattern comes next.
    bool atName() const;
    /// Reads it with its arguments. False when it is none or not understood: that has been reported.
    /// `average`, which only maps know, is not read here.
    bool parseName();
    /// Whether the name has left a block open, `object { Shape`, whose list of entries and `}` come next.
    bool opensList() const { return opensList_; }
    /// Whether the values of the pattern count the entries of a list, which stands in place of a map.
    bool countsEntries() const;
    /// To be called before an entry of such a list, which has `before` of them: warns where POV-Ray takes
    /// none.
    void noteEntry(std::size_t before);
    /// Reads a modifier, if one comes next: turbulence, frequency, wave types, warps, transformations...
    bool parseModifier();
    /// Reads over the name of a pattern that is left out, with its arguments.
    void skipLeftOut();

    /// `interpolate`, which may follow behind `density_file`, or behind the amount of a normal with it.
    bool parseInterpolation();

    Pattern pattern;

  private:
    void parseNoiseGenerator();
    bool parseSpecialName(const Token& name);
    void parseNameArguments();
    bool parseFractal(const Token& name);
    /// A whole number; POV-Ray refuses those beyond, which is told.
    int parseChoice(const std::string& name, int first, int last);
    void parseTiling();
    bool parseMagnet();
    bool parseFunctionPattern();
    bool parseObjectPattern();
    bool parsePigmentPattern();
    bool parseSlope();
    void parseSlopeRange(SlopeSettings::Range& range);
    bool parseImagePattern();
    bool parseDensityFile();
    std::shared_ptr<const DensityVolume> readVolume(const std::string& name, const SourceRange& range);
    void useVolume(DensityTable::Interpolation interpolation);
    bool parseWave(const Token& word);
    bool parseCrackleModifier(const Token& word);
    bool parseFractalModifier(const Token& word);
    bool parsePavementModifier(const Token& word);
    bool parseShapeModifier(const Token& word);
    bool parseGeneralModifier(const Token& word);
    FractalColoring parseColoring();

    TokenStream& tokens_;
    bool opensList_ = false;
    bool isObject_ = false;                        ///< whether the pattern is an `object`
    bool isVolume_ = false;                        ///< whether the pattern is a `density_file`
    std::shared_ptr<const DensityVolume> volume_;  ///< of it, where it could be read
};

/// Whether the word names a pattern that is read over and not simulated (`projection`).
bool isPatternLeftOut(std::string_view word);

}  // namespace isoscope

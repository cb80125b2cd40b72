// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/normal_parser.h"

#include <algorithm>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/textures/image_map_parser.h"
#include "core/language/textures/map_position.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/povray_refusals.h"
#include "core/language/tokens/unknown_name.h"
#include "core/texture/own_colors.h"

namespace isoscope {

namespace {

/// Patterns with a formula of their own for normals.
NormalKind kindOf(PatternKind pattern) {
    switch (pattern) {
        case PatternKind::bumps: return NormalKind::bumps;
        case PatternKind::dents: return NormalKind::dents;
        case PatternKind::quilted: return NormalKind::quilted;
        case PatternKind::ripples: return NormalKind::ripples;
        case PatternKind::waves: return NormalKind::waves;
        case PatternKind::wrinkles: return NormalKind::wrinkles;
        default: return NormalKind::pattern;
    }
}

}  // namespace

void NormalParser::start(const SurfaceNormal& normal) {
    normal_ = normal;
    reader_.pattern = normal.pattern;
    ownEntries_ = false;
}

NormalPointer NormalParser::parse(const NormalPointer& start) {
    if (start) this->start(*start);
    if (tokens_.expect("{", "to begin `normal`")) {
        parseBody("}");
        // An empty one holds no more than settings, too.
        if (!failed_) settings();
    }
    return result();
}

NormalPointer NormalParser::result() {
    if (!normal_) return nullptr;
    normal_->pattern = reader_.pattern;
    const std::size_t length = ownColors(normal_->pattern.kind).size();
    if (normal_->mapKind == MapKind::list && ownEntries_ && normal_->entries.size() < length)
        warnOfRefusal(tokens_.context(), tokens_.lastRange(),
                      "ends in a crash where a list has fewer normals than the pattern, " +
                          std::to_string(length) + ".",
                      "write as many");
    if (!normal_->entries.empty())
        normal_->kind = NormalKind::map;
    else if (normal_->kind == NormalKind::map)
        normal_->kind = kindOf(normal_->pattern.kind);
    normal_->size = 1;
    normal_->depth = 1;
    for (const SurfaceNormal::Entry& entry : normal_->entries) {
        normal_->size += entry.normal ? entry.normal->size : 1;
        normal_->depth = std::max(normal_->depth, entry.normal ? entry.normal->depth + 1 : 1);
    }
    if (normal_->size <= MappedPigment::sizeLimit && normal_->depth <= MappedPigment::depthLimit)
        return std::make_shared<const SurfaceNormal>(std::move(*normal_));
    tokens_.context().error("too-large", tokens_.lastRange(),
                            "This normal is made of more than " + std::to_string(MappedPigment::sizeLimit) +
                                " normals, or they are nested more than " +
                                std::to_string(MappedPigment::depthLimit) + " deep.");
    return nullptr;
}

void NormalParser::parseBody(std::string_view end) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) return tokens_.skipBlock();
    while (!tokens_.peek().is(end)) {
        if (parseItem()) continue;
        failed_ = true;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end || token.is("}")) {
            tokens_.expect(end, "to close `normal`");
            return;
        }
        passUnknownItem(tokens_, "normal", end);
    }
    tokens_.next();
}

bool NormalParser::parseItem() {
    if (tokens_.peek().kind == TokenKind::end) return false;
    const Token word = tokens_.peek();
    const auto noted = [&](ItemOrder::Item item) {
        order_.note(tokens_.context(), word, item);
        return true;
    };
    if (const std::optional<NormalPointer> declared = takeDeclared<NormalPointer>(tokens_)) {
        if (*declared)
            start(**declared);
        else
            failed_ = true;
        parseAmount();
        return noted(ItemOrder::Item::name);
    }
    if (parsePattern()) return noted(ItemOrder::Item::start);
    if (parseListItem()) return noted(ItemOrder::Item::list);
    if (!parseSetting() && !parseMaps() && !reader_.parseModifier()) return false;
    return noted(word.is("uv_mapping") ? ItemOrder::Item::mapping : ItemOrder::Item::other);
}

bool NormalParser::parsePattern() {
    const Token name = tokens_.peek();
    if (tokens_.accept("bump_map")) {
        parseBumpMap();
        return true;
    }
    if (tokens_.accept("facets")) {
        patterned().kind = NormalKind::facets;
        // Their cells are those of crackle, with its metric.
        reader_.pattern.kind = PatternKind::crackle;
        normal_->mapKind = MapKind::blend;
        parseAmount();
        return true;
    }
    const bool leftOut = isPatternLeftOut(name.text);
    if (!leftOut && !reader_.atName()) return false;
    patterned();
    const bool average = tokens_.accept("average");
    if (leftOut || (!average && !reader_.parseName())) {
        if (leftOut) reader_.skipLeftOut();
        ExpressionParser expressions(tokens_);
        tokens_.accept(",");
        if (expressions.atExpression()) expressions.parseFloat();
        leftOut_.emplace_back(leftOut ? name.text : std::string_view("normal"));
        normal_->amount = 0;
        return true;
    }
    const bool opensList = !average && reader_.opensList();
    normal_->mapKind = average ? MapKind::average : reader_.countsEntries() ? MapKind::list : MapKind::blend;
    normal_->kind = kindOf(reader_.pattern.kind);
    if (opensList) {
        while (parseListItem()) continue;
        closeMap("object");
        return true;
    }
    parseAmount();
    reader_.parseInterpolation();
    return true;
}

/// The number that may stand behind a pattern or a name.
void NormalParser::parseAmount() {
    ExpressionParser expressions(tokens_);
    tokens_.accept(",");
    if (!expressions.atExpression()) return;
    const double amount = expressions.parseFloat();
    settings().amount = amount;
    if (tokens_.accept(",")) warnOfLastComma(tokens_);
}

void NormalParser::parseBumpMap() {
    patterned().amount = 1;
    if (!tokens_.expect("{", "to begin `bump_map`")) return;
    ImageMapParser images(tokens_);
    bool understood = images.parseFile();
    while (understood && !tokens_.peek().is("}")) {
        const Token word = tokens_.peek();
        if (tokens_.accept("bump_size"))
            normal_->amount = ExpressionParser(tokens_).parseFloat();
        else
            understood = images.parseSetting();
        if (!understood)
            tokens_.context().error("unknown-item", word.range,
                                    describe(word) + " is not understood in `bump_map`.");
    }
    if (!understood) return tokens_.skipBlock();
    tokens_.next();
    normal_->image = images.read();
    normal_->kind = normal_->image ? NormalKind::image : NormalKind::pattern;
    if (!normal_->image) normal_->amount = 0;
}

/// The normal that settings are of, which may have no pattern yet.
SurfaceNormal& NormalParser::settings() {
    if (!normal_) normal_.emplace().flat = true;
    return *normal_;
}

SurfaceNormal& NormalParser::patterned() {
    if (!normal_) normal_.emplace();
    normal_->flat = false;
    return *normal_;
}

bool NormalParser::parseSetting() {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("bump_size")) {
        const double amount = expressions.parseFloat();
        if (leftOut_.empty()) settings().amount = amount;
    } else if (tokens_.accept("accuracy")) {
        const double accuracy = expressions.parseFloat();
        if (accuracy > 0) settings().accuracy = accuracy;
    } else if (normal_ && normal_->kind == NormalKind::facets && tokens_.accept("size")) {
        normal_->facets.size = expressions.parseFloat();
    } else if (normal_ && normal_->kind == NormalKind::facets && tokens_.accept("coords")) {
        normal_->facets.coords = expressions.parseFloat();
    } else if (tokens_.accept("no_bump_scale")) {
        const bool off = expressions.parseBareFlag("no_bump_scale");
        settings().scaled = !off;
    } else if (tokens_.accept("uv_mapping")) {
        const bool set = expressions.parseBareFlag("uv_mapping");
        settings().onSurface = set;
    } else {
        return false;
    }
    return true;
}

/// A normal behind `checker` and the like.
bool NormalParser::parseListItem() {
    if (!normal_ || normal_->mapKind != MapKind::list || !tokens_.peek().is("normal")) return false;
    reader_.noteEntry(ownEntries_ ? normal_->entries.size() : 0);
    tokens_.next();
    if (!ownEntries_) normal_->entries.clear();
    ownEntries_ = true;
    NormalParser inner(tokens_, defaults_);
    const NormalPointer entry = inner.parse(defaults_);
    leftOut_.insert(leftOut_.end(), inner.leftOut_.begin(), inner.leftOut_.end());
    normal_->entries.push_back({static_cast<double>(normal_->entries.size()), entry});
    tokens_.accept(",");
    return true;
}

bool NormalParser::parseMaps() {
    const Token word = tokens_.peek();
    if (!word.is("normal_map") && !word.is("slope_map")) return false;
    tokens_.next();
    const bool lists = normal_ && normal_->mapKind == MapKind::list;
    if (lists || (word.is("normal_map") && normal_ && normal_->kind == NormalKind::facets))
        warnOfRefusal(tokens_.context(), word.range,
                      "takes no `" + std::string(word.text) + "` behind " +
                          (lists ? "a pattern with a list." : "`facets`."),
                      "leave it out");
    patterned();
    if (word.is("normal_map"))
        parseNormalMap();
    else
        parseSlopeMap();
    return true;
}

NormalPointer NormalParser::parseMap(std::string_view word) {
    normal_.emplace();
    if (word == "normal_map")
        parseNormalMap();
    else
        parseSlopeMap();
    return result();
}

void NormalParser::parseNormalMap() {
    normal_->entries.clear();
    normal_->slopes.clear();
    if (!tokens_.expect("{", "to begin `normal_map`")) return;
    if (const auto declared = takeDeclared<NormalPointer>(tokens_))
        if (*declared) normal_->entries = (*declared)->entries;
    while (tokens_.accept("[")) {
        const double position = parseMapPosition(tokens_, normal_->mapKind == MapKind::average);
        NormalParser inner(tokens_, defaults_);
        if (defaults_) inner.start(*defaults_);
        inner.parseBody("]");
        leftOut_.insert(leftOut_.end(), inner.leftOut_.begin(), inner.leftOut_.end());
        normal_->entries.push_back({position, inner.result()});
    }
    closeMap("normal_map");
}

void NormalParser::parseSlopeMap() {
    normal_->entries.clear();
    normal_->slopes.clear();
    if (!tokens_.expect("{", "to begin `slope_map`")) return;
    if (const auto declared = takeDeclared<NormalPointer>(tokens_))
        if (*declared) normal_->slopes = (*declared)->slopes;
    ExpressionParser expressions(tokens_);
    while (tokens_.accept("[")) {
        SlopeEntry entry;
        entry.position = expressions.parseFloat();
        tokens_.accept(",");
        const glm::dvec3 heightAndSlope = expressions.parseVector();
        entry.height = heightAndSlope.x;
        entry.slope = heightAndSlope.y;
        normal_->slopes.push_back(entry);
        if (!tokens_.expect("]", "to close the entry of the slope map")) break;
    }
    closeMap("slope_map");
}

bool NormalParser::closeMap(std::string_view what) {
    if (tokens_.accept("}")) return true;
    tokens_.context().error(
        "unexpected-token", tokens_.peek().range,
        "Expected `[` or `}` in `" + std::string(what) + "`, but found " + describe(tokens_.peek()) + ".");
    tokens_.skipBlock();
    return false;
}

}  // namespace isoscope

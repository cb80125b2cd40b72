// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/pigment_parser.h"

#include <algorithm>
#include <array>

#include "core/language/expressions/declared_value.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/image_map_parser.h"
#include "core/language/textures/color_start.h"
#include "core/language/textures/map_position.h"
#include "core/language/textures/warp_parser.h"
#include "core/language/tokens/nesting_guard.h"
#include "core/language/tokens/unknown_name.h"

namespace isoscope {

namespace {

const MappedPigment* mappedOf(const Pigment& pigment) {
    const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&pigment);
    return mapped ? mapped->get() : nullptr;
}

Color meanColor(const Pigment& pigment) {
    const MappedPigment* mapped = mappedOf(pigment);
    if (!mapped) return std::get<SolidPigment>(pigment).color;
    if (mapped->entries.empty()) return {0.5, 0.5, 0.5, 0, 0};
    Color sum;
    for (const MappedPigment::Entry& entry : mapped->entries) sum = sum + meanColor(entry.pigment);
    return sum * (1.0 / static_cast<double>(mapped->entries.size()));
}

void addOnce(std::vector<std::string>& list, const std::string& word) {
    if (std::find(list.begin(), list.end(), word) == list.end()) list.push_back(word);
}

}  // namespace

std::vector<std::string> notSimulatedIn(const Pigment& pigment) {
    std::vector<std::string> list;
    if (const auto* solid = std::get_if<SolidPigment>(&pigment)) {
        if (!solid->standsFor.empty()) list.push_back(solid->standsFor);
        return list;
    }
    const MappedPigment& mapped = *mappedOf(pigment);
    for (const std::string& word : mapped.notSimulated) addOnce(list, word);
    for (const MappedPigment::Entry& entry : mapped.entries) {
        for (const std::string& word : notSimulatedIn(entry.pigment)) addOnce(list, word);
    }
    return list;
}

Pigment moved(const Pigment& pigment, const Transform& transform) {
    const MappedPigment* mapped = mappedOf(pigment);
    if (!mapped || transform.identity()) return pigment;
    auto copy = std::make_shared<MappedPigment>(*mapped);
    copy->pattern.warps.emplace_back(transformWarp(transform));
    return copy;
}

bool PigmentParser::isMap(std::string_view word) {
    static constexpr std::array<std::string_view, 4> maps{"color_map", "colour_map", "pigment_map",
                                                          "density_map"};
    return std::ranges::find(maps, word) != maps.end();
}

void PigmentParser::start(const Pigment& pigment) {
    mapped_.reset();
    leftOut_.clear();
    ownEntries_ = false;
    onSurface_ = false;
    if (const MappedPigment* mapped = mappedOf(pigment)) {
        mapped_ = *mapped;
        onSurface_ = mapped->onSurface;
        reader_.pattern = mapped->pattern;
    } else {
        solid_ = std::get<SolidPigment>(pigment);
    }
}

Pigment PigmentParser::parse(const Pigment& start) {
    this->start(start);
    if (tokens_.expect("{", "to begin `pigment`"))
        parseBody("}");
    else
        failed_ = true;
    return result();
}

Pigment PigmentParser::result() {
    if (!mapped_) return solid_;
    mapped_->pattern = reader_.pattern;
    mapped_->onSurface = onSurface_;
    mapped_->size = 1;
    mapped_->depth = 1;
    for (const MappedPigment::Entry& entry : mapped_->entries) {
        const MappedPigment* inner = mappedOf(entry.pigment);
        mapped_->size += inner ? inner->size : 1;
        mapped_->depth = std::max(mapped_->depth, inner ? inner->depth + 1 : 1);
    }
    if (mapped_->size > MappedPigment::sizeLimit || mapped_->depth > MappedPigment::depthLimit) {
        tokens_.context().error("too-large", tokens_.lastRange(),
                                "This pigment is made of more than " +
                                    std::to_string(MappedPigment::sizeLimit) +
                                    " pigments, or they are nested more than " +
                                    std::to_string(MappedPigment::depthLimit) + " deep.");
        failed_ = true;
        return SolidPigment{{0.5, 0.5, 0.5}, {}};
    }
    auto pigment = std::make_shared<const MappedPigment>(std::move(*mapped_));
    if (leftOut_.empty()) return pigment;
    return SolidPigment{meanColor(pigment), leftOut_};
}

void PigmentParser::parseBody(std::string_view end) {
    const NestingGuard guard(tokens_);
    if (!guard.ok()) {
        failed_ = true;
        return tokens_.skipBlock();
    }
    while (!tokens_.peek().is(end)) {
        if (parseItem()) continue;
        const Token token = tokens_.peek();
        failed_ = true;
        if (token.kind == TokenKind::end || token.is("}")) {
            tokens_.expect(end, "to close `pigment`");
            return;
        }
        passUnknownItem(tokens_, "pigment", end);
    }
    tokens_.next();
}

bool PigmentParser::parseItem() {
    if (tokens_.peek().kind == TokenKind::end) return false;
    const Token word = tokens_.peek();
    const auto noted = [&](ItemOrder::Item item) {
        order_.note(tokens_.context(), word, item);
        return true;
    };
    if (startFromDeclared()) return noted(ItemOrder::Item::name);
    if (parsePattern() || parseColor()) return noted(ItemOrder::Item::start);
    if (parseListItem()) return noted(ItemOrder::Item::list);
    if (parseColorSetting()) return noted(ItemOrder::Item::other);
    if (!parseOther()) return false;
    return noted(word.is("uv_mapping") ? ItemOrder::Item::mapping : ItemOrder::Item::other);
}

bool PigmentParser::startFromDeclared() {
    const std::optional<Pigment> declared = takeDeclared<Pigment>(tokens_);
    if (!declared) return false;
    start(*declared);
    fixed_ = onSurface_;
    plain_ = !mapped_;
    return true;
}

bool PigmentParser::parsePattern() {
    if (isPatternLeftOut(tokens_.peek().text)) {
        leftOut_ = std::string(tokens_.peek().text);
        reader_.skipLeftOut();
        if (!mapped_) mapped_.emplace();
        return true;
    }
    if (tokens_.accept("image_map")) {
        ImageMapParser images(tokens_);
        if (!mapped_) mapped_.emplace();
        mapped_->image = images.parse();
        for (const std::string& word : images.leftOut()) addOnce(mapped_->notSimulated, word);
        if (!mapped_->image) leftOut_ = "image_map";
        return true;
    }
    if (!reader_.atName()) return false;
    if (mapped_) mapped_->image = nullptr;
    const bool average = tokens_.accept("average");
    if (!average && !reader_.parseName()) {
        failed_ = true;
        leftOut_ = "pattern";
    }
    leftOut_ = failed_ ? leftOut_ : std::string();
    const bool opensList = !average && reader_.opensList();
    if (tokens_.accept(",") && !opensList) warnOfLastComma(tokens_);
    const MapKind kind = average                   ? MapKind::average
                         : reader_.countsEntries() ? MapKind::list
                                                   : MapKind::blend;
    if (!mapped_) mapped_.emplace();
    // Entries of another sort of map mean nothing here.
    const bool lists = (mapped_->kind == MapKind::list) != (kind == MapKind::list);
    if (lists) mapped_->entries.clear();
    mapped_->kind = kind;
    return !opensList || parseOpenList();
}

/// The colours and pigments of `object { Shape A, B }`, as the pattern's own list.
bool PigmentParser::parseOpenList() {
    while (!tokens_.accept("}")) {
        if (parseListItem()) continue;
        tokens_.context().error("unknown-item", tokens_.peek().range,
                                describe(tokens_.peek()) + " is not understood in `object`.");
        failed_ = true;
        tokens_.skipBlock();
        break;
    }
    return true;
}

bool PigmentParser::parseColorSetting() {
    if (tokens_.accept("quick_color") || tokens_.accept("quick_colour")) {
        if (!isWithoutColor(tokens_)) ExpressionParser(tokens_).parseColor();
        return true;
    }
    const Token token = tokens_.peek();
    if (!mapped_ && (token.is("filter") || token.is("transmit"))) {
        tokens_.next();
        (token.is("filter") ? solid_.color.filter : solid_.color.transmit) =
            ExpressionParser(tokens_).parseFloat();
        return true;
    }
    return false;
}

bool PigmentParser::parseColor() {
    if (isList() || !atColor(tokens_)) return false;
    warnOfBareVector(tokens_);
    mapped_.reset();
    leftOut_.clear();
    solid_ = {ExpressionParser(tokens_).parseColor(), {}};
    plain_ = true;
    return true;
}

/// A colour, pigment or density behind `checker` and the like.
bool PigmentParser::parseListItem() {
    if (!isList()) return false;
    const auto add = [this](Pigment pigment) {
        if (!ownEntries_) mapped_->entries.clear();
        ownEntries_ = true;
        mapped_->entries.push_back({static_cast<double>(mapped_->entries.size()), std::move(pigment)});
        tokens_.accept(",");
    };
    const bool isColor = atColor(tokens_) || tokens_.peek().kind == TokenKind::number;
    if (!isColor && !tokens_.peek().is("pigment") && !tokens_.peek().is("density")) return false;
    const std::size_t before = ownEntries_ ? mapped_->entries.size() : 0;
    reader_.noteEntry(before);
    if (before > 0 && isColor != listsColors_)
        warnOfRefusal(tokens_.context(), tokens_.peek().range,
                      "wants colours alone or pigments alone behind this pattern.",
                      "write the colours as `pigment { ... }`");
    listsColors_ = isColor;
    // As in POV-Ray, numbers are greys here.
    if (isColor) {
        add(SolidPigment{ExpressionParser(tokens_).parseColor(), {}});
        return true;
    }
    tokens_.next();
    PigmentParser inner(tokens_);
    add(inner.parse(SolidPigment{}));
    failed_ |= inner.failed_;
    return true;
}

bool PigmentParser::parseOther() {
    const Token word = tokens_.peek();
    // As in POV-Ray, what is declared to lie on the surface cannot be moved any more.
    if (Transform ignored; fixed_ && TransformParser(tokens_).parseModifier(ignored)) return true;
    if (isMap(word.text)) {
        tokens_.next();
        if (plain_ || isList())
            warnOfRefusal(tokens_.context(), word.range,
                          "takes no `" + std::string(word.text) + "` behind " +
                              (plain_ ? "a colour." : "a pattern with a list."),
                          "leave it out");
        if (!mapped_) mapped_.emplace();
        mapped_->entries.clear();
        ownEntries_ = true;
        return parseMapBlock(word.is("color_map") || word.is("colour_map"));
    }
    if (tokens_.accept("uv_mapping")) {
        ExpressionParser expressions(tokens_);
        onSurface_ = atColor(tokens_) || expressions.parseBareFlag("uv_mapping");
        return true;
    }
    return reader_.parseModifier();
}

Pigment PigmentParser::parseMap(std::string_view word) {
    mapped_.emplace();
    parseMapBlock(word == "color_map" || word == "colour_map");
    return result();
}

/// Always true: after a mistake, which is reported, the block is left behind.
bool PigmentParser::parseMapBlock(bool colors) {
    if (!tokens_.expect("{", "to begin the map")) return mapFailed();
    while (!tokens_.accept("}")) {
        if (const std::optional<Pigment> declared = takeDeclared<Pigment>(tokens_)) {
            if (const MappedPigment* map = mappedOf(*declared)) mapped_->entries = map->entries;
            continue;
        }
        if (parseMapEntry(colors)) continue;
        const Token token = tokens_.peek();
        if (token.kind == TokenKind::end) {
            tokens_.expect("}", "to close the map");
            return mapFailed();
        }
        tokens_.context().error(
            "unknown-item", token.range,
            "Expected `[`, a position and a colour here, but found " + describe(token) + ".");
        tokens_.skipBlock();
        return mapFailed();
    }
    if (mapped_->entries.empty())
        warnOfRefusal(tokens_.context(), tokens_.lastRange(), "wants an entry in a map.",
                      "write `[0 rgb 0]` into it");
    return true;
}

bool PigmentParser::mapFailed() {
    failed_ = true;
    return true;
}

bool PigmentParser::parseMapEntry(bool colors) {
    if (!tokens_.accept("[")) return false;
    const double position = parseMapPosition(tokens_, !colors && mapped_->kind == MapKind::average);
    mapped_->entries.push_back({position, SolidPigment{}});
    if (colors) {
        parseColorEntry();
        return true;
    }
    PigmentParser inner(tokens_);
    inner.parseBody("]");
    mapped_->entries.back().pigment = inner.result();
    failed_ |= inner.failed_;
    return true;
}

/// `color]`, or of the old form `position color color]`.
void PigmentParser::parseColorEntry() {
    ExpressionParser expressions(tokens_);
    if (!atColor(tokens_) && tokens_.peek().kind == TokenKind::number) {
        const SourceRange range = tokens_.peek().range;
        const std::optional<Value> value = expressions.parseValue();
        if (const auto* end = value ? std::get_if<NumberValue>(&value->data) : nullptr) {
            if (tokens_.accept(",")) warnOfLastComma(tokens_);
            mapped_->entries.back().pigment = SolidPigment{expressions.parseColor(), {}};
            if (tokens_.accept(",")) warnOfLastComma(tokens_);
            if (!tokens_.peek().is("color") && !tokens_.peek().is("colour"))
                warnOfMissing(tokens_.context(), tokens_.peek().range,
                              "wants `color` in front of the second colour of an entry.", "color");
            mapped_->entries.push_back({end->value, SolidPigment{expressions.parseColor(), {}}});
        } else if (const auto* color = value ? std::get_if<VectorValue>(&value->data) : nullptr) {
            const auto& c = color->components;
            mapped_->entries.back().pigment = SolidPigment{{c[0], c[1], c[2], c[3], c[4]}, {}};
        } else {
            if (value) tokens_.context().error("not-a-color", range, "Expected a colour here.");
            failed_ = true;
        }
    } else {
        warnOfBareVector(tokens_);
        mapped_->entries.back().pigment = SolidPigment{expressions.parseColor(), {}};
    }
    if (tokens_.expect("]", "to close the entry of the colour map")) return;
    failed_ = true;
    while (tokens_.peek().kind != TokenKind::end && !tokens_.peek().is("]") && !tokens_.peek().is("}"))
        tokens_.next();
    tokens_.accept("]");
}

}  // namespace isoscope

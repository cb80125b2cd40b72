// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/block_words.h"

#include <map>
#include <set>
#include <span>
#include <sstream>

#include "core/language/camera_parser.h"
#include "core/language/light_parser.h"
#include "core/language/objects/shape_parser.h"
#include "core/language/objects/wrapping_modifier.h"
#include "core/language/statement_description.h"
#include "core/language/textures/finish_parser.h"
#include "core/language/textures/interior_parser.h"

namespace isoscope {

namespace {

// Lists of words, as they are easiest to read and to compare with the parsers.
constexpr const char* ofObjects =
    "texture pigment normal finish material interior interior_texture no_shadow no_image no_reflection "
    "no_radiosity hollow double_illuminate hierarchy uv_mapping photons "
    "radiosity sturm ";
constexpr const char* patterns =
    "agate aoi average boxed bozo brick bumps cells checker crackle cubic cylindrical density_file dents "
    "facets function gradient granite hexagon image_map image_pattern julia leopard magnet mandel marble "
    "object onion pavement pigment_pattern planar quilted radial ripples slope spherical spiral1 spiral2 "
    "spotted square tiling triangular waves wood wrinkles ";
constexpr const char* ofPatterns =
    "agate_turb brick_size control0 control1 exponent exterior interpolate mortar turbulence octaves lambda "
    "omega frequency phase noise_generator warp ramp_wave triangle_wave sine_wave scallop_wave cubic_wave "
    "poly_wave ";

using Words = std::vector<std::string>;

/// What puts a shape around an object.
const std::string& wrappings() {
    static const std::string list = [] {
        std::string joined;
        for (const WrappingModifier& modifier : wrappingModifiers())
            joined += std::string(modifier.keyword) + " ";
        return joined;
    }();
    return list;
}

/// What begins an object, in the order of the alphabet.
const std::string& objects() {
    static const std::string list = [] {
        std::set<std::string_view> keywords{"difference",   "intersection", "isosurface", "light_group",
                                            "light_source", "merge",        "object",     "union"};
        for (const ShapeParser& parser : shapeParsers()) keywords.insert(parser.keyword);
        std::string joined;
        for (const std::string_view keyword : keywords) joined += std::string(keyword) + " ";
        return joined;
    }();
    return list;
}

void add(Words& words, std::string_view list) {
    std::istringstream stream{std::string(list)};
    for (std::string word; stream >> word;) words.push_back(word);
}

Words listed(std::span<const char* const> lists) {
    Words words;
    for (const char* list : lists)
        if (list) add(words, list);
    return words;
}
Words listed(std::initializer_list<std::string_view> lists) {
    Words words;
    for (const std::string_view list : lists) add(words, list);
    return words;
}

/// What objects have of their own, besides what all have.
std::string_view ownWords(std::string_view object) {
    if (const ShapeParser* parser = findShapeParser(object)) return parser->words;
    static const std::map<std::string_view, std::string_view> lists{
        {"isosurface",
         "function contained_by threshold accuracy max_gradient max_trace all_intersections open evaluate"},
        {"object", objects()},
        {"merge", objects()},
        {"union", objects()},
        {"light_group", "global_lights"},
        {"intersection", "cutaway_textures"},
        {"difference", "cutaway_textures"}};
    const auto found = lists.find(object);
    return found == lists.end() ? "" : found->second;
}

std::map<std::string, Words, std::less<>> makeBlocks() {
    std::map<std::string, Words, std::less<>> blocks;
    for (const std::string& object : listed({objects()})) {
        const bool combines = object == "union" || object == "merge" || object == "intersection" ||
                              object == "difference" || object == "light_group";
        blocks[object] = listed({ownWords(object), ofObjects, wrappings(), transformWords,
                                 combines ? std::string_view(objects()) : std::string_view(),
                                 combines ? "cutaway_textures split_union" : ""});
    }
    blocks[""] = listed({objects(), "background camera default"});
    blocks["contained_by"] = listed({"sphere box"});
    blocks["pigment"] = listed({colorWords, patterns, ofPatterns, transformWords,
                                "color_map colour_map pigment_map image_map quick_color uv_mapping"});
    blocks["normal"] = listed({patterns, ofPatterns, transformWords,
                               "bump_map bump_size accuracy normal_map slope_map uv_mapping no_bump_scale"});
    blocks["texture"] = listed({patterns, ofPatterns, transformWords,
                                "pigment normal finish texture texture_map tiles material_map uv_mapping"});
    blocks["material"] = listed({transformWords, "texture interior interior_texture pigment normal finish"});
    // The words of the others stand beside their parsers.
    blocks["camera"] = listed(CameraParser::itemWords);
    blocks["light_source"] = listed(LightParser::itemWords);
    blocks["finish"] = listed(FinishParser::itemWords);
    blocks["interior"] = listed(InteriorParser::itemWords);
    for (const StatementDescription* statement : statementDescriptions) {
        blocks[std::string(statement->word)] = listed(statement->itemWords);
        blocks[""].emplace_back(statement->word);
    }
    blocks["#default"] = listed({"texture pigment normal finish camera radiosity"});
    return blocks;
}

}  // namespace

const std::vector<std::string>& wordsOfBlock(std::string_view block) {
    static const auto blocks = makeBlocks();
    static const Words all = [] {
        std::set<std::string> words;
        for (const auto& [name, list] : blocks) words.insert(list.begin(), list.end());
        return Words(words.begin(), words.end());
    }();
    const auto found = blocks.find(block);
    return found == blocks.end() ? all : found->second;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/block_words.h"

#include <map>
#include <set>
#include <span>
#include <sstream>

#include "core/language/camera_parser.h"
#include "core/language/light_parser.h"
#include "core/language/statement_description.h"
#include "core/language/textures/finish_parser.h"
#include "core/language/textures/interior_parser.h"

namespace isoscope {

namespace {

// Lists of words, as they are easiest to read and to compare with the parsers.
constexpr const char* ofObjects =
    "texture pigment normal finish material interior interior_texture no_shadow no_image no_reflection "
    "no_radiosity inverse hollow double_illuminate hierarchy clipped_by bounded_by uv_mapping photons "
    "radiosity sturm ";
constexpr const char* objects =
    "bicubic_patch blob box cone cubic cylinder difference disc height_field intersection isosurface "
    "julia_fractal lathe light_group light_source merge mesh mesh2 object parametric plane poly polygon "
    "polynomial prism quadric quartic smooth_triangle sor sphere sphere_sweep superellipsoid text torus "
    "triangle union ";
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

void add(Words& words, const char* list) {
    std::istringstream stream(list);
    for (std::string word; stream >> word;) words.push_back(word);
}

Words listed(std::span<const char* const> lists) {
    Words words;
    for (const char* list : lists)
        if (list) add(words, list);
    return words;
}
Words listed(std::initializer_list<const char*> lists) {
    return listed(std::span(lists.begin(), lists.size()));
}

/// What objects have of their own, besides what all have.
const char* ownWords(std::string_view object) {
    static const std::map<std::string_view, const char*> lists{
        {"isosurface",
         "function contained_by threshold accuracy max_gradient max_trace all_intersections open evaluate"},
        {"parametric", "function contained_by accuracy max_gradient precompute"},
        {"blob", "sphere cylinder component threshold"},
        {"mesh", "triangle smooth_triangle inside_vector"},
        {"mesh2",
         "vertex_vectors normal_vectors uv_vectors texture_list face_indices normal_indices uv_indices "
         "inside_vector"},
        {"height_field", "function png jpeg gif tga pgm ppm tiff bmp sys smooth water_level"},
        {"julia_fractal", "quaternion hypercomplex max_iteration precision slice sqr cube exp"},
        {"bicubic_patch", "type flatness u_steps v_steps uv_vectors"},
        {"lathe", "linear_spline quadratic_spline cubic_spline bezier_spline"},
        {"prism", "linear_spline quadratic_spline cubic_spline bezier_spline linear_sweep conic_sweep open"},
        {"sphere_sweep", "linear_spline cubic_spline b_spline tolerance"},
        {"cylinder", "open"},
        {"cone", "open"},
        {"sor", "open"},
        {"text", "ttf internal"},
        {"object", objects},
        {"clipped_by", objects},
        {"bounded_by", objects},
        {"merge", objects},
        {"union", objects},
        {"light_group", "global_lights"},
        {"intersection", "cutaway_textures"},
        {"difference", "cutaway_textures"}};
    const auto found = lists.find(object);
    return found == lists.end() ? "" : found->second;
}

std::map<std::string, Words, std::less<>> makeBlocks() {
    std::map<std::string, Words, std::less<>> blocks;
    for (const std::string& object : listed({objects})) {
        const bool combines = object == "union" || object == "merge" || object == "intersection" ||
                              object == "difference" || object == "light_group";
        blocks[object] = listed({ownWords(object), ofObjects, transformWords, combines ? objects : "",
                                 combines ? "cutaway_textures split_union" : ""});
    }
    blocks[""] = listed({objects, "background camera default"});
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

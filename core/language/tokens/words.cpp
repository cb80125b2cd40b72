// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/tokens/words.h"

#include <algorithm>
#include <array>

#include "core/function/operation.h"

namespace isoscope {

namespace {

using enum WordUse;
constexpr WordUse number = keyword | constant | functionConstant;
constexpr WordUse framed = number | predeclared;
constexpr WordUse value = keyword | constant;
constexpr WordUse sceneFunction = keyword | expressionFunction;
constexpr WordUse bodyFunction = keyword | elementaryFunction;
constexpr WordUse bothFunctions = sceneFunction | bodyFunction;

/// The words of which more is known than that they are keywords; the functions that are operations stand in
/// operationTable.
constexpr auto described = std::to_array<Word>({
    {"alpha", keyword | color},
    {"asc", sceneFunction, "asc(S)"},
    {"bitwise_and", sceneFunction, "bitwise_and(A, B)"},
    {"bitwise_or", sceneFunction, "bitwise_or(A, B)"},
    {"bitwise_xor", sceneFunction, "bitwise_xor(A, B)"},
    {"blue", keyword | color},
    {"break", directive},
    {"case", directive},
    {"cells", keyword, {}, 350},
    {"chr", sceneFunction, "chr(A)"},
    {"clock", number},
    {"clock_delta", framed},
    {"clock_on", number},
    {"color", keyword | color},
    {"colour", keyword | color},
    {"concat", sceneFunction, "concat(S1, S2)"},
    {"datetime", sceneFunction, "datetime(DAYS, FORMAT)"},
    {"debug", directive},
    {"declare", directive},
    {"default", directive},
    {"defined", sceneFunction, "defined(NAME)"},
    {"degrees", bothFunctions, "degrees(A)"},
    {"dimension_size", sceneFunction, "dimension_size(ARRAY, N)"},
    {"dimensions", sceneFunction, "dimensions(ARRAY)"},
    {"else", directive},
    {"elseif", directive, {}, 370},
    {"end", directive},
    {"error", directive},
    {"false", value},
    {"fclose", directive},
    {"file_exists", sceneFunction, "file_exists(FILE)"},
    {"filter", keyword | color},
    {"final_clock", framed},
    {"final_frame", framed},
    {"fopen", directive},
    {"for", directive, {}, 370},
    {"frame_number", framed},
    {"function", keyword, {}, 350},
    {"green", keyword | color},
    {"if", directive},
    {"ifdef", directive},
    {"ifndef", directive},
    {"image_height", framed},
    {"image_width", framed},
    {"include", directive},
    {"initial_clock", framed},
    {"initial_frame", framed},
    {"input_file_name", value | predeclared},
    {"inside", sceneFunction, "inside(OBJECT, V)"},
    {"isosurface", keyword, {}, 350},
    {"lemon", keyword | shape, {}, 380},
    {"local", directive},
    {"macro", directive},
    {"max_extent", sceneFunction, "max_extent(OBJECT)"},
    {"media", keyword},
    {"mesh2", keyword | shape, {}, 350},
    {"mesh_camera", keyword, {}, 370},
    {"min_extent", sceneFunction, "min_extent(OBJECT)"},
    {"mm_per_unit", keyword, {}, 370},
    {"no", value},
    {"noise_generator", keyword, {}, 350},
    {"now", value},
    {"off", value},
    {"on", value},
    {"ovus", keyword | shape, {}, 370},
    {"parametric", keyword | shape, {}, 350},
    {"pavement", keyword, {}, 370},
    {"photons", keyword | notSimulated, {}, 350},
    {"pi", number},
    {"radians", bothFunctions, "radians(A)"},
    {"radiosity", keyword | notSimulated},
    {"rand", sceneFunction, "rand(S)"},
    {"range", directive},
    {"read", keyword | directive},
    {"red", keyword | color},
    {"render", directive},
    {"rgb", keyword | color},
    {"rgbf", keyword | color},
    {"rgbft", keyword | color},
    {"rgbt", keyword | color},
    {"seed", sceneFunction, "seed(A)"},
    {"sphere_sweep", keyword | shape, {}, 350},
    {"srgb", keyword | color, {}, 370},
    {"srgbf", keyword | color, {}, 370},
    {"srgbft", keyword | color, {}, 370},
    {"srgbt", keyword | color, {}, 370},
    {"statistics", directive},
    {"str", sceneFunction, "str(A, L, P)"},
    {"strcmp", sceneFunction, "strcmp(S1, S2)"},
    {"strlen", sceneFunction, "strlen(S)"},
    {"strlwr", sceneFunction, "strlwr(S)"},
    {"strupr", sceneFunction, "strupr(S)"},
    {"substr", sceneFunction, "substr(S, P, L)"},
    {"subsurface", keyword | notSimulated, {}, 370},
    {"switch", directive},
    {"t", value},
    {"tau", value, {}, 380},
    {"tiling", keyword, {}, 370},
    {"trace", sceneFunction, "trace(OBJECT, V, V)"},
    {"transmit", keyword | color},
    {"true", value},
    {"u", value},
    {"undef", directive},
    {"v", value},
    {"val", sceneFunction, "val(S)"},
    {"vaxis_rotate", sceneFunction, "vaxis_rotate(V1, V2, A)"},
    {"vcross", sceneFunction, "vcross(V1, V2)"},
    {"vdot", sceneFunction, "vdot(V1, V2)"},
    {"version", keyword | directive | constant},
    {"vlength", sceneFunction, "vlength(V)"},
    {"vnormalize", sceneFunction, "vnormalize(V)"},
    {"vrotate", sceneFunction, "vrotate(V, V)"},
    {"vstr", sceneFunction, "vstr(N, V, S, L, P)"},
    {"vturbulence", sceneFunction, "vturbulence(L, O, N, V)"},
    {"warning", directive},
    {"while", directive},
    {"write", keyword | directive},
    {"x", value},
    {"y", value},
    {"yes", value},
    {"z", value},
});

/// Keywords that begin a shape.
constexpr std::string_view shapes = R"(
bicubic_patch blob box cone cubic cylinder disc height_field julia_fractal lathe mesh plane poly polygon
polynomial prism quadric quartic smooth_triangle sor sphere superellipsoid text torus triangle
)";

/// The other keywords.
constexpr std::string_view others = R"(
aa_level aa_threshold absorption accuracy adaptive adc_bailout agate agate_turb albedo all all_intersections
altitude always_sample ambient ambient_light angle aoi aperture append arc_angle area_illumination area_light
array ascii assumed_gamma autostop average b_spline background bezier_spline black_hole blur_samples bmp bokeh
bounded_by boxed bozo brick brick_size brightness brilliance bump_map bump_size bumps camera caustics charset
checker circular clipped_by collect color_map colour_map component composite confidence conic_sweep
conserve_energy contained_by control0 control1 coords count crackle crand cube cubic_spline cubic_wave
cutaway_textures cylindrical density density_file density_map dents deprecated df3 difference diffuse
direction dispersion dispersion_samples dist_exp distance double_illuminate eccentricity emission error_bound
evaluate expand_thresholds exponent exr exterior extinction face_indices facets fade_color fade_colour
fade_distance fade_power falloff falloff_angle finish fisheye flatness flip focal_point fog fog_alt fog_offset
fog_type form frequency fresnel gamma gather gif global_lights global_settings gradient granite gray
gray_threshold hdr hexagon hf_gray_16 hierarchy hollow hypercomplex iff image_map image_pattern importance
inside_vector interior interior_texture internal interpolate intersection intervals inverse ior irid
irid_wavelength jitter jpeg julia lambda leopard light_group light_source linear_spline linear_sweep load_file
location look_at looks_like low_error_factor magnet major_radius mandel map_type marble material material_map
matrix max_gradient max_intersections max_iteration max_sample max_trace max_trace_level maximum_reuse
media_attenuation media_interaction merge metallic method metric minimum_reuse mortar natural_spline
nearest_count no_bump_scale no_image no_radiosity no_reflection no_shadow normal normal_indices normal_map
normal_vectors number_of_waves object octaves offset omega omnimax once onion open orient orientation
orthographic panoramic parallel pass_through pattern perspective pgm phase phong phong_size pigment
pigment_map pigment_pattern planar png point_at poly_wave pot ppm precision precompute premultiplied
pretrace_end pretrace_start projected_through pwr quadratic_spline quaternion quick_color quick_colour quilted
radial radius rainbow ramp_wave ratio reciprocal recursion_limit reflection reflection_exponent refraction
repeat right ripples rotate roughness samples save_file scale scallop_wave scattering shadowless sine_wave
sint16be sint16le sint32be sint32le sint8 size sky sky_sphere slice slope slope_map smooth solid spacing
specular spherical spiral1 spiral2 spline split_union spotlight spotted sqr square steps strength sturm sys
target texture texture_list texture_map tga thickness threshold tiff tightness tile2 tiles tolerance toroidal
transform translate translucency triangle_wave triangular ttf turb_depth turbulence type u_steps uint16be
uint16le uint8 ultra_wide_angle union up use_alpha use_color use_colour use_index utf8 uv_indices uv_mapping
uv_vectors v_steps variance vertex_vectors warp water_level waves width wood wrinkles xyz
)";

consteval bool isBlank(char c) { return c == ' ' || c == '\n'; }

consteval std::size_t countOf(std::string_view list) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < list.size(); ++i) count += isBlank(list[i]) && !isBlank(list[i - 1]);
    return count;
}

/// Operations of one name, `select`, have one row with a form of call.
constexpr bool isFunction(const OperationFacts& facts) { return facts.form != CallForm::none; }

constexpr std::size_t wordCount =
    described.size() + countOf(shapes) + countOf(others) + std::ranges::count_if(operationTable, isFunction);

consteval Word* addWords(std::string_view list, WordUse uses, Word* next) {
    for (std::size_t begin = 0; begin < list.size(); ++begin) {
        std::size_t end = begin;
        while (!isBlank(list[end])) ++end;
        if (end > begin) *next++ = {list.substr(begin, end - begin), uses, {}, 0};
        begin = end;
    }
    return next;
}

consteval std::array<Word, wordCount> sortedWords() {
    std::array<Word, wordCount> all{};
    auto* next = std::copy(described.begin(), described.end(), all.data());
    for (const OperationFacts& facts : operationTable)
        if (isFunction(facts))
            *next++ = {facts.word(), facts.form == CallForm::loop ? bodyFunction : bothFunctions, facts.call,
                       0};
    next = addWords(shapes, keyword | shape, next);
    addWords(others, keyword, next);
    std::ranges::sort(all, {}, &Word::text);
    return all;
}

constexpr std::array<Word, wordCount> table = sortedWords();
static_assert(std::ranges::adjacent_find(table, {}, &Word::text) == table.end(), "a word stands here twice");

/// A place of the index for a word that is not empty. Four of its characters tell most words apart.
constexpr std::size_t indexSize = 4096;
constexpr std::size_t placeOf(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
    const unsigned size = static_cast<unsigned>(text.size());
    const unsigned mixed = at(0) + at(size / 2) * 37 + at(size - 1) * 1009 + at(size / 4) * 2741 + size * 619;
    return mixed % indexSize;
}

/// One more than a word's number in the table, at its place or behind it where that was taken; 0: none.
constexpr std::array<std::uint16_t, indexSize> index = [] {
    std::array<std::uint16_t, indexSize> places{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        std::size_t place = placeOf(table[i].text);
        while (places[place] != 0) place = (place + 1) % indexSize;
        places[place] = static_cast<std::uint16_t>(i + 1);
    }
    return places;
}();

}  // namespace

std::span<const Word> words() { return table; }

const Word* findWord(std::string_view text) {
    if (text.empty()) return nullptr;
    for (std::size_t place = placeOf(text); index[place] != 0; place = (place + 1) % indexSize) {
        const Word& word = table[index[place] - 1u];
        if (word.text == text) return &word;
    }
    return nullptr;
}

}  // namespace isoscope

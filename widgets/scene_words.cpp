// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene_words.h"

#include <QMap>

#include "core/function/builtin.h"
#include "widgets/function_snippet.h"

namespace isoscope {
namespace {

const char directiveWords[] =
    "#break #case #debug #declare #default #else #elseif #end #error #fclose #fopen #for #if #ifdef #ifndef "
    "#include #local #macro #range #read #render #statistics #switch #undef #version #warning #while #write";

const char keywordWords[] =
    "aa_level aa_threshold absorption accuracy adaptive adc_bailout agate agate_turb all all_intersections "
    "altitude always_sample ambient ambient_light angle aperture arc_angle area_light array assumed_gamma "
    "autostop average b_spline background bezier_spline bicubic_patch black_hole blob blue blur_samples "
    "bounded_by box boxed bozo brick brick_size brightness brilliance bump_map bump_size bumps camera caustics "
    "cells charset checker circular clipped_by clock clock_delta clock_on collect color color_map colour "
    "colour_map component composite cone confidence conic_sweep conserve_energy contained_by control0 control1 "
    "coords count crackle crand cube cubic cubic_spline cubic_wave cutaway_textures cylinder cylindrical "
    "density density_file density_map dents dF3 df3 difference diffuse direction disc dispersion "
    "dispersion_samples dist_exp distance eccentricity emission error_bound evaluate exponent exterior "
    "extinction face_indices facets fade_color fade_colour fade_distance fade_power falloff falloff_angle false "
    "file_exists filter final_clock final_frame finish fisheye flatness flip focal_point fog fog_alt fog_offset "
    "fog_type form frame_number frequency fresnel function gather gif global_lights global_settings gradient "
    "granite gray gray_threshold green h_angle height_field hexagon hf_gray_16 hierarchy hollow hypercomplex "
    "iff image_height image_map image_pattern image_width initial_clock initial_frame inside_vector interior "
    "interior_texture internal interpolate intersection intervals inverse ior irid irid_wavelength isosurface "
    "jitter jpeg julia julia_fractal lambda lathe leopard light_group light_source linear_spline linear_sweep "
    "location look_at looks_like low_error_factor magnet major_radius mandel map_type marble material "
    "material_map matrix max_extent max_gradient max_intersections max_iteration max_sample max_trace "
    "max_trace_level media media_attenuation media_interaction merge mesh mesh2 mesh_camera metallic method "
    "metric min_extent minimum_reuse mm_per_unit mortar natural_spline nearest_count no no_bump_scale no_image "
    "no_radiosity no_reflection no_shadow noise_generator normal normal_indices normal_map normal_vectors "
    "number_of_waves object octaves off offset omega omnimax on once onion open orient orientation "
    "orthographic panoramic parallel parametric pass_through pattern perspective pgm phase phong phong_size "
    "photons pi pigment pigment_map pigment_pattern planar plane png point_at poly poly_wave polygon pot ppm "
    "precision precompute pretrace_end pretrace_start prism projected_through quadratic_spline quadric quartic "
    "quaternion quick_color quick_colour quilted radial radiosity radius rainbow ramp_wave ratio reciprocal "
    "recursion_limit red reflection reflection_exponent refraction repeat rgb rgbf rgbft rgbt right ripples "
    "rotate roughness samples save_file scale scallop_wave scattering shadowless sign sine_wave size sky "
    "sky_sphere slice slope slope_map smooth smooth_triangle solid sor spacing specular sphere sphere_sweep "
    "spherical spiral1 spiral2 spline split_union spotlight spotted srgb srgbf srgbft srgbt sturm "
    "subsurface superellipsoid sys t tangent target text texture texture_list texture_map tga thickness "
    "threshold tiff tightness tile2 tiles tolerance toroidal torus transform translate translucency transmit "
    "triangle triangle_wave true ttf turb_depth turbulence type u u_steps ultra_wide_angle union up use_alpha "
    "use_color use_colour use_index utf8 uv_indices uv_mapping uv_vectors v v_angle v_steps variance vertex_vectors "
    "warp water_level waves width wood wrinkles x y yes z";

/// Functions of the language itself; the numbered ones come from builtins().
const char* const languageFunctions[] = {
    "abs(A)", "acos(A)", "acosh(A)", "asc(S)", "asin(A)", "asinh(A)", "atan(A)", "atan2(A, B)", "atanh(A)",
    "bitwise_and(A, B)", "bitwise_or(A, B)", "bitwise_xor(A, B)", "ceil(A)", "chr(A)", "concat(S1, S2)",
    "cos(A)", "cosh(A)", "cube(A)", "defined(NAME)", "degrees(A)", "dimensions(ARRAY)",
    "dimension_size(ARRAY, N)", "div(A, B)", "exp(A)", "floor(A)", "inside(OBJECT, V)", "int(A)", "ln(A)",
    "log(A)", "max(A, B)", "min(A, B)", "mod(A, B)", "now", "pow(A, B)", "prod(I, A, B, F)", "radians(A)",
    "rand(S)", "seed(A)", "select(A, B, C)", "sin(A)", "sinh(A)", "sqr(A)", "sqrt(A)", "str(A, L, P)",
    "strcmp(S1, S2)", "strlen(S)", "strlwr(S)", "strupr(S)", "substr(S, P, L)", "sum(I, A, B, F)", "tan(A)",
    "tanh(A)", "trace(OBJECT, V, V)", "val(S)", "vaxis_rotate(V1, V2, A)", "vcross(V1, V2)", "vdot(V1, V2)",
    "vlength(V)", "vnormalize(V)", "vrotate(V, V)", "vstr(N, V, S, L, P)", "vturbulence(L, O, N, V)"};

struct Words {
    QHash<QByteArray, WordKind> kinds;
    QMap<QString, QString> tips;
    QStringList sorted;

    Words() {
        for (const QByteArray& word : QByteArray(directiveWords).split(' ')) kinds[word] = WordKind::directive;
        for (const QByteArray& word : QByteArray(keywordWords).split(' ')) kinds[word] = WordKind::keyword;
        for (const QString tip : languageFunctions) addFunction(tip.section('(', 0, 0), tip);
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty()) addFunction(QString::fromStdString(builtin.name), signature(builtin));
        for (auto it = kinds.cbegin(); it != kinds.cend(); ++it) sorted << QString::fromLatin1(it.key());
        sorted.sort();
    }

    void addFunction(const QString& name, const QString& tip) {
        kinds[name.toLatin1()] = WordKind::function;
        tips[name] = tip;
    }
};

const Words& words() {
    static const Words all;
    return all;
}

}  // namespace

WordKind wordKind(const QByteArray& word) { return words().kinds.value(word, WordKind::unknown); }

const QStringList& sceneWords() { return words().sorted; }

QString callTip(const QString& word) { return words().tips.value(word); }

}  // namespace isoscope

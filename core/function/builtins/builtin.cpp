// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/builtins/builtin.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "core/function/builtins/builtin_formulas.h"
#include "core/function/builtins/builtin_table.h"
#include "core/function/patterns/pattern.h"

namespace isoscope {

namespace {

constexpr int highestId = 78;

std::string shortest(double value) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

const char* const ball = "sqrt(x*x + y*y + z*z) - 1";

/// "f_bozo(3*x, 3*y, 3*z)" for a scale of 3.
std::string scaledCall(const Builtin& builtin, double scale) {
    std::string call = sampleCall(builtin);
    if (scale == 1) return call;
    const std::string factor = shortest(scale) + "*", plain = "(x, y, z";
    return call.replace(call.find(plain), plain.size(), "(" + factor + "x, " + factor + "y, " + factor + "z");
}

Showing showingOf(const Builtin& builtin, const BuiltinFacts::Shown& shown) {
    Showing showing{builtin.invert ? "-" + sampleCall(builtin) : sampleCall(builtin),
                    builtin.container,
                    builtin.threshold,
                    builtin.maxGradient,
                    {}};
    const double relief = shown.relief;
    if (shown.paints) {
        showing = {ball, "sphere 0 1.1", 0, 1, scaledCall(builtin, shown.scale)};
    } else if (relief != 0) {
        showing.expression = std::string(ball) + (relief < 0 ? " + " : " - ") + shortest(std::abs(relief)) +
                             "*" + scaledCall(builtin, shown.scale);
        showing.container = "sphere 0 " + shortest(1.05 + std::max(0.0, relief));
        showing.threshold = 0;
    } else if (*shown.expression) {
        showing.expression = shown.expression;
        showing.threshold = 0;
    }
    if (*shown.container) showing.container = shown.container;
    if (shown.maxGradient != 0) showing.maxGradient = shown.maxGradient;
    return showing;
}

Builtin fromFacts(const BuiltinFacts& facts) {
    Builtin builtin;
    builtin.name = facts.name;
    builtin.id = facts.id;
    for (const BuiltinFacts::Parameter& p : facts.parameters)
        if (p.name) builtin.parameters.push_back({p.name, p.defaultValue, p.minimum, p.maximum});
    builtin.pointArguments = facts.pointArguments;
    builtin.formula = facts.formula;
    builtin.threshold = facts.threshold;
    builtin.container = facts.container;
    builtin.maxGradient = facts.maxGradient;
    builtin.invert = facts.invert;
    builtin.kind = facts.kind;
    builtin.showing = showingOf(builtin, facts.shown);
    return builtin;
}

const std::vector<Builtin>& table() {
    static const std::vector<Builtin> builtins = [] {
        std::vector<Builtin> all;
        for (const auto facts : {patternFacts(), firstNumberedFacts(), lastNumberedFacts()})
            std::transform(facts.begin(), facts.end(), std::back_inserter(all), fromFacts);
        std::sort(all.begin(), all.end(), [](const Builtin& a, const Builtin& b) {
            return a.id != b.id ? a.id < b.id : a.name < b.name;
        });
        return all;
    }();
    return builtins;
}

const std::array<Formula, highestId + 1>& numberedFormulas() {
    static const std::array<Formula, highestId + 1> formulas = [] {
        std::array<Formula, highestId + 1> all{};
        for (const auto family : {latheFormulas(), algebraicFormulas(), shapedFormulas(), gaussianFormulas(),
                                  distanceFormulas(), helicalFormulas(), fractalFormulas()})
            for (const NumberedFormula& entry : family)
                all[static_cast<std::size_t>(entry.id)] = entry.formula;
        return all;
    }();
    return formulas;
}

Pattern patternOf(PatternKind kind) {
    Pattern pattern;
    pattern.kind = kind;
    return pattern;
}

Pattern gradientAlong(std::array<double, 3> direction) {
    Pattern pattern = patternOf(PatternKind::gradient);
    pattern.gradient = direction;
    return pattern;
}

/// The pattern functions of functions.inc, all with default settings.
const Pattern* namedPattern(std::string_view name) {
    static const std::map<std::string_view, Pattern> patterns{
        {"f_agate", patternOf(PatternKind::agate)},
        {"f_boxed", patternOf(PatternKind::boxed)},
        {"f_bozo", patternOf(PatternKind::bozo)},
        {"f_brick", patternOf(PatternKind::brick)},
        {"f_bumps", patternOf(PatternKind::bumps)},
        {"f_checker", patternOf(PatternKind::checker)},
        {"f_crackle", patternOf(PatternKind::crackle)},
        {"f_cylindrical", patternOf(PatternKind::cylindrical)},
        {"f_dents", patternOf(PatternKind::dents)},
        {"f_gradientX", gradientAlong({1, 0, 0})},
        {"f_gradientY", gradientAlong({0, 1, 0})},
        {"f_gradientZ", gradientAlong({0, 0, 1})},
        {"f_granite", patternOf(PatternKind::granite)},
        {"f_hexagon", patternOf(PatternKind::hexagon)},
        {"f_leopard", patternOf(PatternKind::leopard)},
        {"f_mandel", patternOf(PatternKind::mandel)},
        {"f_marble", patternOf(PatternKind::marble)},
        {"f_onion", patternOf(PatternKind::onion)},
        {"f_planar", patternOf(PatternKind::planar)},
        {"f_radial", patternOf(PatternKind::radial)},
        {"f_ripples", patternOf(PatternKind::ripples)},
        {"f_spherical", patternOf(PatternKind::spherical)},
        {"f_spiral1", patternOf(PatternKind::spiral1)},
        {"f_spiral2", patternOf(PatternKind::spiral2)},
        {"f_spotted", patternOf(PatternKind::spotted)},
        {"f_waves", patternOf(PatternKind::waves)},
        {"f_wood", patternOf(PatternKind::wood)},
        {"f_wrinkles", patternOf(PatternKind::wrinkles)},
    };
    const auto found = patterns.find(name);
    return found == patterns.end() ? nullptr : &found->second;
}

/// Functions that functions.inc derives from others.
Expression buildDerived(std::string_view name, std::span<const Expression> a, int noiseGenerator) {
    if (name == "f_snoise3d") return 2 * noise(a[0].number(noiseGenerator), a[0], a[1], a[2]) - 1;
    const Expression wave = a[1] * sin(std::numbers::pi * a[0] * a[2]);
    return name == "f_scallop_wave" ? abs(wave) : wave;
}

}  // namespace

std::span<const Builtin> builtins() { return table(); }

const Builtin* findBuiltin(std::string_view name) {
    static const std::map<std::string_view, const Builtin*> byName = [] {
        std::map<std::string_view, const Builtin*> names;
        for (const Builtin& builtin : table())
            if (!builtin.name.empty()) names[builtin.name] = &builtin;
        return names;
    }();
    const auto found = byName.find(name);
    return found == byName.end() ? nullptr : found->second;
}

const Builtin* findBuiltin(int id) {
    if (id < 0) return nullptr;
    const auto found =
        std::find_if(table().begin(), table().end(), [&](const Builtin& b) { return b.id == id; });
    return found == table().end() ? nullptr : &*found;
}

Expression buildBuiltin(const Builtin& builtin, std::span<const Expression> arguments, int noiseGenerator) {
    if (builtin.id >= 0)
        return numberedFormulas()[static_cast<std::size_t>(builtin.id)](
            {arguments[0], arguments[1], arguments[2], arguments.subspan(3), noiseGenerator});
    const Pattern* pattern = namedPattern(builtin.name);
    if (!pattern) return buildDerived(builtin.name, arguments, noiseGenerator);
    const Expression value = buildPattern(*pattern, arguments[0], arguments[1], arguments[2], noiseGenerator);
    // f_hexagon paints the three entries of its pattern in greys.
    return pattern->kind == PatternKind::hexagon ? value / 2 : value;
}

std::string sampleCall(const Builtin& builtin) {
    std::string call = builtin.name.empty() ? "internal(" + std::to_string(builtin.id) + ")" : builtin.name;
    call += "(x, y, z";
    // The wave functions are shown over the point itself.
    if (builtin.pointArguments == 3)
        for (const BuiltinParameter& parameter : builtin.parameters)
            call += ", " + shortest(parameter.defaultValue);
    return call + (builtin.name == "f_hexagon" ? ").red" : ")");
}

bool isStructural(const Builtin& builtin, int index) {
    const auto at = static_cast<std::size_t>(index);
    if (index < 0 || at >= builtin.parameters.size()) return false;
    static constexpr std::array<std::string_view, 5> names{"Octaves", "Number of Tubes", "Cross Section Type",
                                                           "SOR Switch", "Noise Generator"};
    return std::find(names.begin(), names.end(), builtin.parameters[at].name) != names.end();
}

}  // namespace isoscope

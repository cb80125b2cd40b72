// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/textures/pattern_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "core/function/patterns/pavement.h"
#include "core/function/patterns/tilings.h"
#include "core/language/directives/asset_file.h"
#include "core/language/expressions/expression_parser.h"
#include "core/language/functions/function_parser.h"
#include "core/language/functions/function_scope.h"
#include "core/language/objects/transform_parser.h"
#include "core/language/textures/image_map_parser.h"
#include "core/language/textures/object_pattern.h"
#include "core/language/textures/pigment_parser.h"
#include "core/language/textures/warp_parser.h"
#include "core/texture/tables/density_table.h"
#include "core/texture/tables/image_table.h"
#include "core/texture/own_colors.h"
#include "core/texture/pigment_function.h"
#include "core/texture/surface_needs.h"

namespace isoscope {

namespace {

const std::map<std::string_view, PatternKind> kinds{
    {"agate", PatternKind::agate},       {"boxed", PatternKind::boxed},
    {"bozo", PatternKind::bozo},         {"brick", PatternKind::brick},
    {"bumps", PatternKind::bumps},       {"cells", PatternKind::cells},
    {"checker", PatternKind::checker},   {"crackle", PatternKind::crackle},
    {"cubic", PatternKind::cubic},       {"cylindrical", PatternKind::cylindrical},
    {"dents", PatternKind::dents},       {"gradient", PatternKind::gradient},
    {"granite", PatternKind::granite},   {"hexagon", PatternKind::hexagon},
    {"leopard", PatternKind::leopard},   {"marble", PatternKind::marble},
    {"onion", PatternKind::onion},       {"planar", PatternKind::planar},
    {"quilted", PatternKind::quilted},   {"radial", PatternKind::radial},
    {"ripples", PatternKind::ripples},   {"spherical", PatternKind::spherical},
    {"spiral1", PatternKind::spiral1},   {"spiral2", PatternKind::spiral2},
    {"spotted", PatternKind::spotted},   {"square", PatternKind::square},
    {"waves", PatternKind::waves},       {"wood", PatternKind::wood},
    {"tiling", PatternKind::tiling},     {"triangular", PatternKind::triangular},
    {"pavement", PatternKind::pavement}, {"wrinkles", PatternKind::wrinkles},
};

std::array<double, 3> components(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

int wholeNumber(double value, int minimum, int maximum) {
    if (!(value >= minimum)) return minimum;
    return value >= maximum ? maximum : static_cast<int>(value);
}

bool isFractal(PatternKind kind) {
    return kind == PatternKind::mandel || kind == PatternKind::julia || kind == PatternKind::magnetMandel ||
           kind == PatternKind::magnetJulia;
}

}  // namespace

bool PatternReader::atName() const {
    static constexpr std::array<std::string_view, 11> special{
        "mandel",          "julia",   "magnet", "function", "object",      "image_pattern",
        "pigment_pattern", "average", "slope",  "aoi",      "density_file"};
    const Token& token = tokens_.peek();
    return token.kind == TokenKind::word &&
           (kinds.contains(token.text) ||
            std::find(special.begin(), special.end(), token.text) != special.end());
}

bool isPatternLeftOut(std::string_view word) {
    static constexpr std::array<std::string_view, 2> names{"facets", "projection"};
    return std::find(names.begin(), names.end(), word) != names.end();
}

void PatternReader::skipLeftOut() {
    tokens_.next();
    if (tokens_.accept("{")) tokens_.skipBlock();
}

bool PatternReader::countsEntries() const { return isDiscrete(pattern.kind) || isObject_; }

void PatternReader::noteEntry(std::size_t before) {
    const SourceRange& range = tokens_.peek().range;
    const std::size_t most = ownColors(isObject_ ? PatternKind::function : pattern.kind).size();
    if (isObject_ && !opensList_)
        warnOfRefusal(tokens_.context(), range,
                      "wants the entries of an `object` pattern inside of its braces.", "move them there");
    else if (before == most)
        warnOfRefusal(tokens_.context(), range,
                      "takes " + std::to_string(most) + " entries behind this pattern.",
                      "leave the others out");
}

bool PatternReader::parseName() {
    const Token name = tokens_.peek();
    opensList_ = false;
    isObject_ = false;
    volume_ = nullptr;
    isVolume_ = false;
    const auto kind = kinds.find(name.text);
    if (kind == kinds.end()) return parseSpecialName(name);
    tokens_.next();
    pattern.kind = kind->second;
    parseNameArguments();
    return true;
}

void PatternReader::parseNameArguments() {
    ExpressionParser expressions(tokens_);
    if (pattern.kind == PatternKind::gradient) pattern.gradient = components(expressions.parseVector());
    if (pattern.kind == PatternKind::spiral1 || pattern.kind == PatternKind::spiral2)
        pattern.arms = wholeNumber(expressions.parseFloat(), -10'000, 10'000);
    if (pattern.kind == PatternKind::tiling) parseTiling();
}

bool PatternReader::parseSpecialName(const Token& name) {
    if (parseFractal(name)) return true;
    if (tokens_.accept("magnet")) return parseMagnet();
    if (tokens_.accept("function")) return parseFunctionPattern();
    if (tokens_.accept("object")) return parseObjectPattern();
    if (tokens_.accept("pigment_pattern")) return parsePigmentPattern();
    if (tokens_.accept("slope")) return parseSlope();
    if (tokens_.accept("image_pattern")) return parseImagePattern();
    if (tokens_.accept("density_file")) return parseDensityFile();
    if (tokens_.accept("aoi")) {
        pattern.kind = PatternKind::aoi;
        return true;
    }
    tokens_.context().error("unknown-pattern", name.range, "Expected the name of a pattern here.");
    return false;
}

bool PatternReader::parseFractal(const Token& name) {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("mandel")) {
        pattern.kind = PatternKind::mandel;
    } else if (tokens_.accept("julia")) {
        pattern.kind = PatternKind::julia;
        const glm::dvec3 point = expressions.parseVector();
        pattern.juliaPoint = {point.x, point.y};
        tokens_.accept(",");
    } else {
        return false;
    }
    const double iterations = expressions.parseFloat();
    pattern.iterations = wholeNumber(iterations, 0, fractalIterationLimit);
    if (iterations > fractalIterationLimit)
        tokens_.context().warning("bad-value", tokens_.lastRange(),
                                  "`" + std::string(name.text) + "` is computed with at most " +
                                      std::to_string(fractalIterationLimit) + " iterations.");
    return true;
}

int PatternReader::parseChoice(const std::string& name, int first, int last) {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    if (!(value >= first && value < last + 1))
        warnOfRefusal(tokens_.context(), rangeSince(start, tokens_),
                      "wants " + std::to_string(first) + " to " + std::to_string(last) + " for " + name + ".",
                      "write " + std::to_string(first));
    return wholeNumber(value, first, last);
}

void PatternReader::parseTiling() {
    pattern.tiling = parseChoice("the number of a `tiling`", 1, rhombTiling);
}

bool PatternReader::parseMagnet() {
    pattern.magnetType = parseChoice("the type of `magnet`", 1, 2);
    const Token name = tokens_.peek();
    if (!parseFractal(name)) {
        tokens_.context().error("unknown-pattern", name.range,
                                "Expected `mandel` or `julia` behind `magnet`.");
        if (name.kind == TokenKind::word) tokens_.next();
        return false;
    }
    pattern.kind = pattern.kind == PatternKind::mandel ? PatternKind::magnetMandel : PatternKind::magnetJulia;
    return true;
}

bool PatternReader::parseFunctionPattern() {
    const FunctionValue value = FunctionParser(tokens_).parseFormula();
    if (!value.function.valid()) return false;
    pattern.kind = PatternKind::function;
    pattern.function = value.function;
    if (value.function.argumentCount == 3 && value.function.results.size() == 1) return true;
    tokens_.context().error("wrong-function", tokens_.lastRange(),
                            "A pattern needs a function of x, y and z that gives one number.");
    return false;
}

bool PatternReader::parseObjectPattern() {
    const SourceRange range = tokens_.peek().range;
    const std::optional<Function> inside = parseInsideFunction(tokens_);
    if (!inside) {
        tokens_.context().report(
            {Severity::leftOut,
             "left-out",
             range,
             "This object cannot be used as a pattern: what is inside of it is not known.",
             {},
             {}});
        return false;
    }
    pattern.kind = PatternKind::function;
    pattern.function = *inside;
    // Its numbers count, too.
    pattern.frequency = 0;
    isObject_ = true;
    opensList_ = !tokens_.accept("}");
    return true;
}

bool PatternReader::parsePigmentPattern() {
    const SourceRange range = tokens_.lastRange();
    const Pigment pigment = PigmentParser(tokens_).parse(SolidPigment{});
    if (needsSurface(pigment)) {
        reportLeftOut(tokens_.context(), range,
                      "`slope`, `aoi` and `uv_mapping` are not simulated in `pigment_pattern`.");
        return false;
    }
    FunctionScope scope({});
    const PatternPoint point{scope.expression(*scope.find("x")), scope.expression(*scope.find("y")),
                             scope.expression(*scope.find("z"))};
    const NodeId gray =
        grayOf(pigmentColor(pigment, point, {tokens_.context().noiseGenerator, Pattern().numberOfWaves}))
            .node();
    if (scope.overflowed()) return false;
    pattern.kind = PatternKind::function;
    pattern.function = scope.finish({gray});
    return true;
}

/// `slope DIRECTION`, or in braces with what may follow it.
bool PatternReader::parseSlope() {
    pattern.kind = PatternKind::slope;
    pattern.slope = {};
    ExpressionParser expressions(tokens_);
    if (!tokens_.accept("{")) {
        pattern.slope.direction = components(expressions.parseVector());
        return true;
    }
    pattern.slope.direction = components(expressions.parseVector());
    parseSlopeRange(pattern.slope.slopes);
    if (tokens_.accept("altitude")) {
        pattern.slope.altitude = components(expressions.parseVector());
        parseSlopeRange(pattern.slope.altitudes);
    }
    if (tokens_.accept("}")) return true;
    tokens_.context().error("unexpected-token", tokens_.peek().range, "Expected `}` to close `slope`.");
    tokens_.skipBlock();
    return false;
}

void PatternReader::parseSlopeRange(SlopeSettings::Range& range) {
    ExpressionParser expressions(tokens_);
    if (!tokens_.accept(",")) return;
    range.low = expressions.parseFloat();
    if (tokens_.accept(",")) range.high = expressions.parseFloat();
}

bool PatternReader::parseImagePattern() {
    ImageMapParser images(tokens_);
    const std::shared_ptr<const ImageMap> image = images.parse();
    if (!image) return false;
    // Without any alpha POV-Ray takes red for it.
    const ImageChannel channel = !images.usesAlpha().value_or(false) ? ImageChannel::patternGray
                                 : image->hasAlpha                   ? ImageChannel::storedTransparency
                                                                     : ImageChannel::storedRed;
    FunctionScope scope({});
    const PatternPoint point{scope.expression(*scope.find("x")), scope.expression(*scope.find("y")),
                             scope.expression(*scope.find("z"))};
    const Expression value = imageValue(image, channel, point);
    pattern.kind = PatternKind::function;
    pattern.function = scope.finish({value.node()});
    return true;
}

bool PatternReader::parseDensityFile() {
    isVolume_ = true;
    tokens_.accept("df3");
    const SourceRange start = tokens_.peek().range;
    const std::string name = ExpressionParser(tokens_).parseString();
    volume_ = readVolume(name, rangeSince(start, tokens_));
    if (volume_) useVolume(DensityTable::Interpolation::none);
    parseInterpolation();
    return volume_ != nullptr;
}

std::shared_ptr<const DensityVolume> PatternReader::readVolume(const std::string& name,
                                                               const SourceRange& range) {
    const auto file = findAsset(tokens_.context(), name, range);
    if (!file) {
        tokens_.context().error("no-file", range, file.whyNot("There is no file `" + name + "`."), file.hint);
        return nullptr;
    }
    // Each mention reads the file.
    constexpr std::size_t bytesPerStep = 16;
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(*file, failed);
    if (!tokens_.charge(failed ? 0 : static_cast<std::size_t>(size) / bytesPerStep, range)) return nullptr;
    std::string problem;
    std::shared_ptr<const DensityVolume> volume = readDensityFile(*file, problem);
    if (!volume)
        tokens_.context().error("bad-file", range, "The file `" + name + "` is not used: " + problem + ".");
    return volume;
}

void PatternReader::useVolume(DensityTable::Interpolation interpolation) {
    CrackleSettings settings;
    settings.table = std::make_shared<const DensityTable>(volume_, interpolation);
    FunctionGraph graph;
    const NodeId value = graph.crackle(settings, graph.variable(0), graph.variable(1), graph.variable(2));
    pattern.kind = PatternKind::function;
    pattern.function = isoscope::finish(std::move(graph), {value}, 3);
}

bool PatternReader::parseInterpolation() {
    if (!isVolume_ || !tokens_.accept("interpolate")) return false;
    const double kind = ExpressionParser(tokens_).parseFloat();
    if (!volume_) return true;
    useVolume(kind >= 2   ? DensityTable::Interpolation::cubic
              : kind >= 1 ? DensityTable::Interpolation::linear
                          : DensityTable::Interpolation::none);
    return true;
}

bool PatternReader::parseWave(const Token& word) {
    static const std::map<std::string_view, WaveForm> waves{
        {"ramp_wave", WaveForm::ramp},   {"triangle_wave", WaveForm::triangle},
        {"sine_wave", WaveForm::sine},   {"scallop_wave", WaveForm::scallop},
        {"cubic_wave", WaveForm::cubic}, {"poly_wave", WaveForm::poly},
    };
    const auto wave = waves.find(word.text);
    if (wave == waves.end()) return false;
    tokens_.next();
    pattern.wave = wave->second;
    ExpressionParser expressions(tokens_);
    if (wave->second == WaveForm::poly && expressions.atExpression())
        pattern.waveExponent = expressions.parseFloat();
    return true;
}

bool PatternReader::parseCrackleModifier(const Token& word) {
    const std::string_view name = word.text;
    if (pattern.kind != PatternKind::crackle ||
        (name != "form" && name != "metric" && name != "offset" && name != "solid"))
        return false;
    tokens_.next();
    ExpressionParser expressions(tokens_);
    if (name == "form") pattern.crackle.form = components(expressions.parseVector());
    if (name == "metric") pattern.crackle.metric = expressions.parseFloat();
    if (name == "offset") pattern.crackle.offset = expressions.parseFloat();
    if (name == "solid") pattern.crackle.solid = true;
    return true;
}

FractalColoring PatternReader::parseColoring() {
    ExpressionParser expressions(tokens_);
    FractalColoring coloring;
    coloring.type = parseChoice("the colouring of a fractal", 0, 6);
    tokens_.accept(",");
    coloring.factor = expressions.parseFloat();
    return coloring;
}

bool PatternReader::parseFractalModifier(const Token& word) {
    if (!isFractal(pattern.kind)) return false;
    if (tokens_.accept("exponent"))
        pattern.exponent = wholeNumber(ExpressionParser(tokens_).parseFloat(), 0, 100);
    else if (tokens_.accept("exterior"))
        pattern.exterior = parseColoring();
    else if (tokens_.accept("interior"))
        pattern.interior = parseColoring();
    else
        return false;
    return !word.text.empty();
}

bool PatternReader::parseShapeModifier(const Token& word) {
    struct Entry {
        const char* name;
        PatternKind kind;
        double Pattern::*member;
    };
    static constexpr std::array<Entry, 4> entries{
        {{"agate_turb", PatternKind::agate, &Pattern::agateTurbulence},
         {"mortar", PatternKind::brick, &Pattern::mortar},
         {"control0", PatternKind::quilted, &Pattern::control0},
         {"control1", PatternKind::quilted, &Pattern::control1}}};
    for (const Entry& entry : entries)
        if (entry.kind == pattern.kind && word.is(entry.name)) {
            tokens_.next();
            pattern.*entry.member = ExpressionParser(tokens_).parseFloat();
            return true;
        }
    if (pattern.kind != PatternKind::brick || !tokens_.accept("brick_size")) return false;
    pattern.brickSize = components(ExpressionParser(tokens_).parseVector());
    return true;
}

bool PatternReader::parseGeneralModifier(const Token& word) {
    ExpressionParser expressions(tokens_);
    if (tokens_.accept("turbulence"))
        pattern.turbulence = components(expressions.parseVector());
    else if (tokens_.accept("octaves"))
        pattern.octaves = wholeNumber(expressions.parseFloat(), 1, 10);
    else if (tokens_.accept("lambda"))
        pattern.lambda = expressions.parseFloat();
    else if (tokens_.accept("omega"))
        pattern.omega = expressions.parseFloat();
    else if (tokens_.accept("frequency"))
        pattern.frequency = expressions.parseFloat();
    else if (tokens_.accept("phase"))
        pattern.phase = expressions.parseFloat();
    else if (tokens_.accept("noise_generator"))
        parseNoiseGenerator();
    else
        return false;
    return word.kind == TokenKind::word;
}

void PatternReader::parseNoiseGenerator() {
    const SourceRange start = tokens_.peek().range;
    const double value = ExpressionParser(tokens_).parseFloat();
    pattern.noiseGenerator = wholeNumber(value, 0, 3);
    if (!(value > -1 && value < 4))
        warnOfRefusal(tokens_.context(), rangeSince(start, tokens_), "wants 0 to 3 for a `noise_generator`.",
                      "write 2");
}

/// POV-Ray looks at the three numbers when all of them are known; they mostly follow one another.
bool PatternReader::parsePavementModifier(const Token& word) {
    if (pattern.kind != PatternKind::pavement) return false;
    PavementChoice& choice = pattern.pavement;
    const auto parseNumber = [&] { return wholeNumber(ExpressionParser(tokens_).parseFloat(), -1000, 1000); };
    const auto parseChoice = [&] {
        if (tokens_.accept("number_of_sides"))
            choice.sides = parseNumber();
        else if (tokens_.accept("number_of_tiles"))
            choice.tiles = parseNumber();
        else if (tokens_.accept("pattern"))
            choice.layout = parseNumber();
        else
            return false;
        return true;
    };
    if (parseChoice()) {
        while (parseChoice()) continue;
        const PavementChoice possible = nearestPavement(choice);
        if (possible != choice)
            warnOfRefusal(tokens_.context(), rangeSince(word.range, tokens_), "has no such `pavement`.",
                          "write number_of_sides " + std::to_string(possible.sides) + " number_of_tiles " +
                              std::to_string(possible.tiles) + " pattern " + std::to_string(possible.layout));
        return true;
    }
    if (!tokens_.accept("exterior") && !tokens_.accept("interior") && !tokens_.accept("form")) return false;
    const int rounding = parseNumber();
    if (rounding == 1 || rounding == 2)
        reportLeftOut(
            tokens_.context(), rangeSince(word.range, tokens_),
            "`exterior`, `interior` and `form` of `pavement` are not simulated: its corners are sharp.");
    return true;
}

bool PatternReader::parseModifier() {
    Transform transform;
    if (TransformParser(tokens_).parseModifier(transform)) {
        pattern.warps.emplace_back(transformWarp(transform));
        return true;
    }
    const Token word = tokens_.peek();
    if (tokens_.accept("warp")) {
        const std::optional<PatternWarp> warp = WarpParser(tokens_).parse();
        if (warp) pattern.warps.push_back(*warp);
        return warp.has_value();
    }
    return parseWave(word) || parseCrackleModifier(word) || parseFractalModifier(word) ||
           parsePavementModifier(word) || parseShapeModifier(word) || parseGeneralModifier(word);
}

}  // namespace isoscope

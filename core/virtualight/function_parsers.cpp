// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives that functions or images describe.
#include "core/language/directives/asset_file.h"
#include "core/shapes/patches/surface_grid.h"
#include "core/virtualight/polynomial_expansion.h"
#include "core/virtualight/primitive_parser.h"

namespace isoscope::virtualight {

namespace {

constexpr int fieldStepLimit = 2048;
constexpr unsigned inSpace = 1u << variableX | 1u << variableY | 1u << variableZ;
constexpr unsigned onSurface = 1u << variableU | 1u << variableV;
constexpr unsigned atPoint = 1u << pointX | 1u << pointY | 1u << pointZ;

}  // namespace

Primitive parseImplicitSurface(ArgumentReader& arguments) {
    ImplicitShape surface;
    const Function function = arguments.formula(inSpace, true);
    if (function.valid()) surface.function = withArguments(function, {variableX, variableY, variableZ}, 3);
    return surface;
}

Primitive parsePolynomialSurface(ArgumentReader& arguments) {
    const Function function = arguments.formula(inSpace, false);
    if (!function.valid()) return PolynomialShape();
    PolynomialExpansion expansion =
        expandPolynomial(withArguments(function, {variableX, variableY, variableZ}, 3));
    ParseContext& context = arguments.tokens().context();
    context.functionCopies += expansion.work;
    if (context.functionCopies > copyLimit)
        arguments.tokens().cut("too-large", arguments.range(),
                               "Reading stops here: the polynomials of this text take too much work.");
    if (!expansion.problem.empty())
        arguments.fail(arguments.range(), expansion.problem, "other functions can be an ImplicitSurface");
    return expansion.polynomial;
}

Primitive parseParametricSurface(ArgumentReader& arguments) {
    ParametricShape surface;
    for (Function& function : surface.functions) {
        const Function read = arguments.formula(onSurface, false);
        if (read.valid()) function = withArguments(read, {variableU, variableV}, 2);
    }
    return surface;
}

Primitive parseImplicitPlanarHeightField(ArgumentReader& arguments) {
    ImplicitPlanarField field;
    field.low.x = arguments.number("least x");
    field.high.x = arguments.number("greatest x");
    field.low.y = arguments.number("least z");
    field.high.y = arguments.number("greatest z");
    if (!arguments.failed() && (field.low.x >= field.high.x || field.low.y >= field.high.y))
        arguments.fail(arguments.range(),
                       "The limits of a height field go from the lesser to the greater one.",
                       "their order is xmin, xmax, zmin, zmax");
    const Function read =
        arguments.formula(1u << variableX | 1u << variableZ | 1u << pointX | 1u << pointZ, false);
    if (read.valid()) {
        // Po is the point of the plane whose height is asked for.
        FunctionGraph graph;
        std::array<NodeId, variableCount> inputs{};
        for (NodeId& input : inputs) input = graph.constant(0);
        inputs[variableX] = inputs[pointX] = graph.variable(0);
        inputs[variableZ] = inputs[pointZ] = graph.variable(1);
        const NodeId result = graph.inlineCall(read, inputs);
        field.height = finish(std::move(graph), {result}, 2);
    }
    field.xSteps = arguments.count("number of steps in x", 1, fieldStepLimit);
    field.zSteps = arguments.count("number of steps in z", 1, fieldStepLimit);
    field.smooth = arguments.flag("SmoothNormal");
    return field;
}

Primitive parseImplicitSphericalHeightField(ArgumentReader& arguments) {
    ImplicitSphericalField field;
    field.radius = arguments.positive("radius");
    field.scale = arguments.number("scale");
    const Function read = arguments.formula(onSurface | atPoint, false);
    if (read.valid()) field.offset = withArguments(read, {variableU, variableV, pointX, pointY, pointZ}, 5);
    field.uSteps = arguments.count("number of steps in u", 3, fieldStepLimit);
    field.vSteps = arguments.count("number of steps in v", 2, fieldStepLimit);
    field.smooth = arguments.flag("SmoothNormal");
    return field;
}

namespace {

void readImage(ArgumentReader& arguments, ImageField& field) {
    field.name = arguments.text("file name of the image");
    const SourceRange range = arguments.range();
    field.smooth = arguments.flag("SmoothNormal");
    if (arguments.failed()) return;
    const auto file = findAsset(arguments.tokens().context(), field.name, range);
    if (!file)
        return arguments.fail(range,
                              file.whyNot("The image \"" + field.name +
                                          "\" was not found beside the scene or in the library paths."));
    std::string problem;
    std::optional<Raster> raster = readRaster(*file, problem);
    if (!raster)
        return arguments.fail(range, "The image \"" + field.name + "\" cannot be used: " + problem + ".");
    const auto points = static_cast<std::size_t>(raster->width) * static_cast<std::size_t>(raster->height);
    if (raster->width < 2 || raster->height < 2 || points > SurfaceGrid::pointLimit)
        return arguments.fail(range, "The image of a height field has at least 2 by 2 and at most " +
                                         std::to_string(SurfaceGrid::pointLimit) + " pixels.");
    field.raster = std::move(*raster);
}

}  // namespace

Primitive parsePlanarHeightField(ArgumentReader& arguments) {
    ImageField field;
    readImage(arguments, field);
    return field;
}

Primitive parseSphericalHeightField(ArgumentReader& arguments) {
    ImageField field;
    field.spherical = true;
    field.radius = arguments.positive("radius");
    field.scale = arguments.number("scale");
    readImage(arguments, field);
    return field;
}

}  // namespace isoscope::virtualight

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/virtualight/vocabulary.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/function/operation.h"

namespace isoscope::virtualight {

namespace {

using Kind = VocabularyWord::Kind;

constexpr auto words = std::to_array<VocabularyWord>({
    {"Declare", Kind::statement, ""},
    {"Shape", Kind::statement, ""},
    {"Solid", Kind::statement, ""},
    {"static", Kind::statement, ""},
    {"BicubicPatch", Kind::shape, "BicubicPatch(basis, usteps, vsteps, 16 points)"},
    {"Blobby", Kind::shape, "Blobby(threshold, components)"},
    {"Box", Kind::shape, "Box(corner1, corner2)"},
    {"Cone", Kind::shape, "Cone(base, base radius, apex, apex radius)"},
    {"Cylinder", Kind::shape, "Cylinder(bottom, top, radius)"},
    {"Disk", Kind::shape, "Disk(center, normal, radius)"},
    {"ExtrudedSurface", Kind::shape, "ExtrudedSurface(method, count, direction, {x, y}, ...)"},
    {"ImplicitPlanarHeightField", Kind::shape,
     "ImplicitPlanarHeightField(xmin, xmax, zmin, zmax, F, xsteps, zsteps)"},
    {"ImplicitSphericalHeightField", Kind::shape,
     "ImplicitSphericalHeightField(radius, scale, F, usteps, vsteps)"},
    {"ImplicitSurface", Kind::shape, "ImplicitSurface(F)"},
    {"NURBS", Kind::shape, "NURBS(nu, uorder, [uknots], nv, vorder, [vknots], [points])"},
    {"Paraboloid", Kind::shape, "Paraboloid(base, top, radius)"},
    {"ParametricSurface", Kind::shape, "ParametricSurface(Fx, Fy, Fz)"},
    {"PlanarHeightField", Kind::shape, "PlanarHeightField(file)"},
    {"Polygon", Kind::shape, "Polygon(count, points)"},
    {"PolynomialSurface", Kind::shape, "PolynomialSurface(F)"},
    {"Ring", Kind::shape, "Ring(center, normal, radius, hole radius)"},
    {"Sphere", Kind::shape, "Sphere(center, radius)"},
    {"SphericalHeightField", Kind::shape, "SphericalHeightField(radius, scale, file)"},
    {"Superquadric", Kind::shape, "Superquadric(h, w)"},
    {"SurfaceOfRevolution", Kind::shape, "SurfaceOfRevolution(method, count, axis, {x, y}, ...)"},
    {"Torus", Kind::shape, "Torus(center, axis, major radius, minor radius)"},
    {"TriangularPatch", Kind::shape, "TriangularPatch(v1, n1, v2, n2, v3, n3)"},
    {"Bound", Kind::modifier, "Bound(corner1, corner2)"},
    {"FerrariSolver", Kind::modifier, ""},
    {"RenderBound", Kind::modifier, "RenderBound(umin, umax, vmin, vmax)"},
    {"Rotate", Kind::modifier, "Rotate(x, y, z)"},
    {"Scale", Kind::modifier, "Scale(x, y, z)"},
    {"ShapeSubdivision", Kind::modifier, "ShapeSubdivision(u, v)"},
    {"ShapeSubdivisions", Kind::modifier, "ShapeSubdivisions(u, v)"},
    {"SmoothNormal", Kind::modifier, ""},
    {"SturmSolver", Kind::modifier, ""},
    {"Translate", Kind::modifier, "Translate(x, y, z)"},
    {"UV", Kind::modifier, ""},
    {"VietaSolver", Kind::modifier, ""},
    {"BEZIER", Kind::constant, ""},
    {"BSPLINE", Kind::constant, ""},
    {"CATMULLROM", Kind::constant, ""},
    {"CONDITIONAL", Kind::constant, ""},
    {"CurrentFrame", Kind::constant, ""},
    {"HERMITE", Kind::constant, ""},
    {"OFF", Kind::constant, ""},
    {"ON", Kind::constant, ""},
    {"PI", Kind::constant, ""},
    {"PI_TWO", Kind::constant, ""},
    {"POLYNOMIAL", Kind::constant, ""},
    {"Po", Kind::constant, ""},
    {"STRAIGHT", Kind::constant, ""},
    {"phi", Kind::constant, ""},
    {"theta", Kind::constant, ""},
    {"u", Kind::constant, ""},
    {"v", Kind::constant, ""},
    {"x", Kind::constant, ""},
    {"y", Kind::constant, ""},
    {"z", Kind::constant, ""},
    {"degrees", Kind::function, "degrees(A)"},
    {"radians", Kind::function, "radians(A)"},
});

}  // namespace

std::span<const VocabularyWord> vocabulary() {
    static const auto all = [] {
        std::vector<VocabularyWord> list(words.begin(), words.end());
        for (const OperationFacts& facts : operationTable)
            if (facts.common && !facts.call.empty())
                list.push_back({facts.word(), Kind::function, facts.call});
        std::ranges::sort(std::ranges::find(list, Kind::function, &VocabularyWord::kind), list.end(), {},
                          &VocabularyWord::word);
        return list;
    }();
    return all;
}

}  // namespace isoscope::virtualight

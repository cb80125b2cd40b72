// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/language/objects/shape_reader.h"
#include "core/shapes/shape.h"

namespace isoscope {

/// Reads what one kind of shape has of its own, up to its object modifiers. Null when it cannot be drawn; the
/// reason has been reported.
using ShapeParser = ShapePointer (*)(ShapeReader&);

/// The parser of a shape that begins with `keyword`; null for other words. CSG, `object` and `isosurface` are
/// no shapes in this sense: ObjectParser reads them itself.
ShapeParser findShapeParser(std::string_view keyword);

/// Each reads the shape that it is named for (docs/povray/primitives.md); callers look them up by
/// findShapeParser. Null, too, where a number is infinite or NaN (ShapeReader::finite).
ShapePointer parseSphere(ShapeReader& reader);
ShapePointer parseBox(ShapeReader& reader);
ShapePointer parsePlane(ShapeReader& reader);
ShapePointer parseCylinder(ShapeReader& reader);
ShapePointer parseCone(ShapeReader& reader);
ShapePointer parseTorus(ShapeReader& reader);
ShapePointer parseDisc(ShapeReader& reader);
ShapePointer parseQuadric(ShapeReader& reader);
ShapePointer parseCubic(ShapeReader& reader);
ShapePointer parseQuartic(ShapeReader& reader);
ShapePointer parsePoly(ShapeReader& reader);
ShapePointer parsePolynomial(ShapeReader& reader);
ShapePointer parseTriangle(ShapeReader& reader);
ShapePointer parseSmoothTriangle(ShapeReader& reader);
ShapePointer parsePolygon(ShapeReader& reader);
ShapePointer parseHeightField(ShapeReader& reader);
ShapePointer parseText(ShapeReader& reader);
ShapePointer parseBicubicPatch(ShapeReader& reader);
ShapePointer parseJuliaFractal(ShapeReader& reader);
ShapePointer parseLathe(ShapeReader& reader);
ShapePointer parseSphereSweep(ShapeReader& reader);
ShapePointer parseSuperellipsoid(ShapeReader& reader);
ShapePointer parseBlob(ShapeReader& reader);
ShapePointer parseMesh(ShapeReader& reader);
ShapePointer parseMesh2(ShapeReader& reader);
ShapePointer parseParametric(ShapeReader& reader);
ShapePointer parsePrism(ShapeReader& reader);
ShapePointer parseSurfaceOfRevolution(ShapeReader& reader);

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/virtualight/argument_reader.h"

namespace isoscope::virtualight {

/// A primitive as it was read.
struct ParsedPrimitive {
    Primitive primitive;
    SourceRange functionRange;  ///< of an ImplicitSurface: its expression
};

/// The 23 primitives, `Name(arguments)`.
class PrimitiveParser {
  public:
    /// Whether it is the name of a primitive, case included.
    static bool isPrimitive(std::string_view name);
    /// The primitive whose name a mistyped one is close to, or "".
    static std::string closestName(std::string_view name);
    /// The name is the next token. Nothing after a mistake, which has been reported; the arguments have been
    /// passed over all the same.
    static std::optional<ParsedPrimitive> parse(TokenReader& tokens, const Names& names);
};

/// The parsers of single primitives, between their brackets (docs/povray/virtualight.md, section 2). After a
/// mistake ArgumentReader::failed() is true and what they return is not to be used.
Primitive parseSphere(ArgumentReader& arguments);
Primitive parseBox(ArgumentReader& arguments);
Primitive parseCone(ArgumentReader& arguments);
Primitive parseCylinder(ArgumentReader& arguments);
Primitive parseDisk(ArgumentReader& arguments);
Primitive parseRing(ArgumentReader& arguments);
Primitive parseTorus(ArgumentReader& arguments);
Primitive parseParaboloid(ArgumentReader& arguments);
Primitive parseSuperquadric(ArgumentReader& arguments);
Primitive parsePolygon(ArgumentReader& arguments);
Primitive parseTriangularPatch(ArgumentReader& arguments);
Primitive parseBlobby(ArgumentReader& arguments);
Primitive parseExtrudedSurface(ArgumentReader& arguments);
Primitive parseSurfaceOfRevolution(ArgumentReader& arguments);
Primitive parseBicubicPatch(ArgumentReader& arguments);
Primitive parseNurbs(ArgumentReader& arguments);
Primitive parseImplicitSurface(ArgumentReader& arguments);
Primitive parsePolynomialSurface(ArgumentReader& arguments);
Primitive parseParametricSurface(ArgumentReader& arguments);
Primitive parseImplicitPlanarHeightField(ArgumentReader& arguments);
Primitive parseImplicitSphericalHeightField(ArgumentReader& arguments);
Primitive parsePlanarHeightField(ArgumentReader& arguments);
Primitive parseSphericalHeightField(ArgumentReader& arguments);

}  // namespace isoscope::virtualight

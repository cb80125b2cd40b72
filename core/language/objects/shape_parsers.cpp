// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/objects/shape_parsers.h"

#include <algorithm>
#include <array>

namespace isoscope {

namespace {

struct Entry {
    std::string_view keyword;
    ShapeParser parse;
};

constexpr std::array entries{
    Entry{"bicubic_patch", parseBicubicPatch},
    Entry{"blob", parseBlob},
    Entry{"box", parseBox},
    Entry{"cone", parseCone},
    Entry{"cubic", parseCubic},
    Entry{"cylinder", parseCylinder},
    Entry{"disc", parseDisc},
    Entry{"height_field", parseHeightField},
    Entry{"julia_fractal", parseJuliaFractal},
    Entry{"lathe", parseLathe},
    Entry{"mesh", parseMesh},
    Entry{"mesh2", parseMesh2},
    Entry{"parametric", parseParametric},
    Entry{"plane", parsePlane},
    Entry{"poly", parsePoly},
    Entry{"polygon", parsePolygon},
    Entry{"polynomial", parsePolynomial},
    Entry{"prism", parsePrism},
    Entry{"quadric", parseQuadric},
    Entry{"quartic", parseQuartic},
    Entry{"smooth_triangle", parseSmoothTriangle},
    Entry{"sor", parseSurfaceOfRevolution},
    Entry{"sphere", parseSphere},
    Entry{"sphere_sweep", parseSphereSweep},
    Entry{"superellipsoid", parseSuperellipsoid},
    Entry{"text", parseText},
    Entry{"torus", parseTorus},
    Entry{"triangle", parseTriangle},
};

}  // namespace

ShapeParser findShapeParser(std::string_view keyword) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.keyword == keyword; });
    return found == entries.end() ? nullptr : found->parse;
}

}  // namespace isoscope

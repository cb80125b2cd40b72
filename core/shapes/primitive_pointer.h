// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

namespace isoscope {

class Blob;
class Box;
class Cone;
class Disc;
class Isosurface;
class Plane;
class Poly;
class Quadric;
class Sphere;
class Superellipsoid;
class Torus;

/// A primitive by its class, for code that can say more about it than Shape does: its formula, its text in
/// another notation. Nothing for shapes about which no such code exists. Valid as long as the shape.
using PrimitivePointer = std::variant<std::monostate, const Blob*, const Box*, const Cone*, const Disc*,
                                      const Isosurface*, const Plane*, const Poly*, const Quadric*,
                                      const Sphere*, const Superellipsoid*, const Torus*>;

}  // namespace isoscope

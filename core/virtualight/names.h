// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/function/function_graph.h"
#include "core/virtualight/document.h"

namespace isoscope::virtualight {

/// A number with the slider of its literal, if it has one (ParseContext::parameters).
struct DeclaredNumber {
    double value = 0;
    int parameter = -1;
};

/// Something that is not simulated: a shader, a camera. Naming it is no error.
struct DeclaredOther {
    std::string keyword;
};

/// What a name of a VirtuaLight text can stand for: a number, an expression of the variables (kept as it is),
/// a point, a primitive that was declared alone, a Shape or Solid.
using DeclaredThing =
    std::variant<DeclaredNumber, Function, glm::dvec3, std::shared_ptr<const Node>, DeclaredOther>;

/// The variables of expressions and their numbers as arguments of functions. `theta` and `phi` are other
/// names of u and v; Po is the point of intersection.
enum Variable : unsigned { variableX, variableY, variableZ, variableU, variableV, pointX, pointY, pointZ };
constexpr int variableCount = 8;

/// The names in force.
class Names {
  public:
    /// With the constants of the program and of its file statics.vib.
    Names();

    /// What the name stands for, or null; valid until the name is declared anew.
    const DeclaredThing* find(std::string_view name) const;
    /// Sets or replaces the name, constants too.
    void declare(const std::string& name, DeclaredThing thing) { names_[name] = std::move(thing); }
    /// A known name close to a mistyped one, or "".
    std::string closest(std::string_view name) const;

  private:
    std::map<std::string, DeclaredThing, std::less<>> names_;
};

}  // namespace isoscope::virtualight

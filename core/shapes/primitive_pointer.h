// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <typeinfo>

namespace isoscope {

/// A primitive by its class, for code that can say more about it than Shape does: its formula, its text in
/// another notation. Nothing for shapes about which no such code exists. Who asks names the classes that he
/// knows; there is no list of all. Valid as long as the shape.
class PrimitivePointer {
  public:
    /// No primitive.
    PrimitivePointer() = default;
    /// The class is the one by which the shape is named here: Shape::primitive() returns `this`.
    template <class Primitive>
    PrimitivePointer(const Primitive* shape) : shape_(shape), class_(&typeid(Primitive)) {}

    /// The shape if it was named by this class; else null.
    template <class Primitive>
    const Primitive* as() const {
        return class_ != nullptr && *class_ == typeid(Primitive) ? static_cast<const Primitive*>(shape_)
                                                                 : nullptr;
    }

    /// Calls `visitor` with a reference to the shape if it was named by one of these classes; whether it was.
    template <class... Primitives, class Visitor>
    bool visit(const Visitor& visitor) const {
        const auto matches = [&](const auto* shape) {
            if (shape != nullptr) visitor(*shape);
            return shape != nullptr;
        };
        return (matches(as<Primitives>()) || ...);
    }

  private:
    const void* shape_ = nullptr;
    const std::type_info* class_ = nullptr;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <array>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/function/function_graph.h"
#include "core/function/written_work.h"
#include "core/scene/camera.h"
#include "core/scene/light_source.h"
#include "core/scene/material.h"
#include "core/scene/scene.h"
#include "core/scene/surface_normal.h"
#include "core/shapes/transform.h"
#include "core/text/source_text.h"

namespace isoscope {

struct ObjectDescription;
class Spline;
struct Value;

/// A float of the scene language.
struct NumberValue {
    double value = 0;
    /// Index of the SceneParameter whose literal this number is, unchanged by any arithmetic; -1 otherwise.
    int parameter = -1;
};

/// A vector (2 to 5 components) or a colour (5: red, green, blue, filter, transmit).
struct VectorValue {
    std::array<double, 5> components{};
    int count = 3;
    bool color = false;
};

/// A function with the names of its parameters, as `#declare F = function(a, b) { ... }` made it.
struct FunctionValue {
    Function function;
    std::vector<std::string> parameterNames;
    std::string name;                            ///< of a built-in, else empty
    std::shared_ptr<const WrittenWork> written;  ///< of an expression; null for what is made otherwise
};

/// An array of the scene language, shared by the names that refer to it, as a macro's parameter does;
/// copyOf() makes another.
struct ArrayValue {
    std::vector<int> dimensions;  ///< the number of elements along each
    std::vector<Value> elements;  ///< row by row; unset elements hold std::monostate
};

/// A statement that is known to the language but not to this program ("photons { ... }"); declared so that
/// naming it again is no error.
struct OpaqueValue {
    std::string keyword;
};

/// A macro: the piece of text between its parameter list and its `#end`.
struct MacroValue {
    std::string name;
    std::vector<std::string> parameterNames;
    SourceRange body;
};

/// A value of many bytes, kept elsewhere and shared by its copies: an array has room for any value in each of
/// its elements, and most hold numbers.
template <class T>
class Kept {
  public:
    Kept(T value) : value_(std::make_shared<const T>(std::move(value))) {}
    const T& operator*() const { return *value_; }

  private:
    std::shared_ptr<const T> value_;
};

/// What a statement that describes itself (StatementDescription) has made of its block, of any type.
class BlockValue {
  public:
    /// `kind` is what messages call it ("a fog"); it is kept as it is.
    template <class T>
    BlockValue(const char* kind, T value)
        : kind_(kind), value_(std::make_shared<const std::any>(std::move(value))) {}
    /// "a fog".
    const char* kind() const { return kind_; }
    /// The value, or null where it is of another type.
    template <class T>
    const T* as() const {
        return std::any_cast<T>(value_.get());
    }

  private:
    const char* kind_;
    std::shared_ptr<const std::any> value_;
};

/// What an identifier can stand for.
struct Value {
    std::variant<std::monostate, NumberValue, VectorValue, std::string, FunctionValue, Kept<Transform>,
                 Pigment, Kept<Finish>, Kept<Material>, Kept<Camera>, Kept<LightSource>,
                 std::shared_ptr<const ObjectDescription>, std::shared_ptr<ArrayValue>, OpaqueValue,
                 std::shared_ptr<const MacroValue>, std::shared_ptr<const Spline>,
                 std::shared_ptr<const SurfaceNormal>, std::shared_ptr<const Interior>, BlockValue>
        data;
};

/// Whether T is one of the alternatives of the variant; only the type of the pointer counts.
template <class T, class... Alternatives>
constexpr bool isAmong(const std::variant<Alternatives...>*) {
    return (std::is_same_v<T, Alternatives> || ...);
}

/// The T that the value is, kept elsewhere, in a BlockValue, or neither; null when it is anything else.
template <class T>
const T* valueAs(const Value& value) {
    if constexpr (isAmong<Kept<T>>(static_cast<decltype(Value::data)*>(nullptr))) {
        const auto* kept = std::get_if<Kept<T>>(&value.data);
        return kept ? &**kept : nullptr;
    } else if constexpr (isAmong<T>(static_cast<decltype(Value::data)*>(nullptr))) {
        return std::get_if<T>(&value.data);
    } else {
        const auto* block = std::get_if<BlockValue>(&value.data);
        return block ? block->as<T>() : nullptr;
    }
}

/// What a value is, for messages: "a float", "a vector", "a texture".
std::string kindOf(const Value& value);

/// The value with arrays duplicated, as `#declare B = A;` needs it: changing an element of one does not
/// change the other.
Value copyOf(const Value& value);
/// How much a copy takes: the elements of arrays and of the arrays in them, and the characters of strings.
struct ValueSize {
    std::size_t elements = 0;
    std::size_t characters = 0;
};
/// Zeros for a value that is neither array nor string.
ValueSize sizeOf(const Value& value);

}  // namespace isoscope

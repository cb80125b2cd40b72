// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/value.h"

namespace isoscope {

namespace {

struct KindName {
    std::string operator()(std::monostate) const { return "nothing"; }
    std::string operator()(const NumberValue&) const { return "a float"; }
    std::string operator()(const VectorValue& v) const { return v.color ? "a color" : "a vector"; }
    std::string operator()(const std::string&) const { return "a string"; }
    std::string operator()(const FunctionValue&) const { return "a function"; }
    std::string operator()(const Kept<Transform>&) const { return "a transform"; }
    std::string operator()(const Pigment&) const { return "a pigment"; }
    std::string operator()(const Kept<Finish>&) const { return "a finish"; }
    std::string operator()(const Kept<Material>&) const { return "a texture"; }
    std::string operator()(const Kept<Camera>&) const { return "a camera"; }
    std::string operator()(const Kept<LightSource>&) const { return "a light source"; }
    std::string operator()(const std::shared_ptr<const ObjectDescription>&) const { return "an object"; }
    std::string operator()(const std::shared_ptr<ArrayValue>&) const { return "an array"; }
    std::string operator()(const OpaqueValue& v) const { return "a `" + v.keyword + "`"; }
    std::string operator()(const std::shared_ptr<const MacroValue>&) const { return "a macro"; }
    std::string operator()(const std::shared_ptr<const Spline>&) const { return "a spline"; }
    std::string operator()(const std::shared_ptr<const SurfaceNormal>&) const { return "a normal"; }
    std::string operator()(const std::shared_ptr<const Interior>&) const { return "an interior"; }
    std::string operator()(const BlockValue& v) const { return v.kind(); }
};

}  // namespace

std::string kindOf(const Value& value) { return std::visit(KindName{}, value.data); }

Value copyOf(const Value& value) {
    const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value.data);
    if (!array) return value;
    auto copy = std::make_shared<ArrayValue>();
    copy->dimensions = (*array)->dimensions;
    copy->elements.reserve((*array)->elements.size());
    for (const Value& element : (*array)->elements) copy->elements.push_back(copyOf(element));
    return {copy};
}

ValueSize sizeOf(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value.data)) return {0, text->size()};
    const auto* array = std::get_if<std::shared_ptr<ArrayValue>>(&value.data);
    if (!array) return {};
    ValueSize size{(*array)->elements.size(), 0};
    for (const Value& element : (*array)->elements) {
        const ValueSize part = sizeOf(element);
        size.elements += part.elements;
        size.characters += part.characters;
    }
    return size;
}

}  // namespace isoscope

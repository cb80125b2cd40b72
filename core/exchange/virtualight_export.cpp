// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/virtualight_export.h"

#include <map>

#include "core/exchange/output_guard.h"
#include "core/exchange/png.h"
#include "core/exchange/pov_export.h"
#include "core/exchange/virtualight_shapes.h"
#include "core/text/number_format.h"
#include "core/text/whole_file.h"
#include "core/virtualight/scene_reader.h"

namespace isoscope {

namespace {

using virtualight::Document;
using virtualight::NodePointer;
using virtualight::SetOperation;
using virtualight::ShapeModifiers;
using virtualight::TransformStep;
using ObjectNode = virtualight::Node;

/// Writes the objects of a document.
class Exporter {
  public:
    Exporter(std::span<const double> parameterTable, HeightImages& images)
        : parameterTable_(parameterTable), images_(images) {}

    std::string statements(const Document& document) {
        std::string text;
        for (const NodePointer& node : document.declared) {
            const std::string object = objectText(*node, {});
            if (object.empty()) continue;
            // Names written before are overruled, as in the text that was read.
            text += "#declare " + nameOf(*node) + " =\n" + object + "\n";
            declared_[nameOf(*node)] = node.get();
        }
        for (const NodePointer& node : document.shown) {
            const std::string object = reference(*node, {});
            text += object.empty() ? "// " + node->keyword + ": left out, it has no equivalent.\n"
                                   : object + "\n";
        }
        return text;
    }

  private:
    /// POV-Ray's own words cannot be declared.
    static std::string nameOf(const ObjectNode& node) { return "vl_" + node.name; }

    /// The object by its name, where it has one and nothing from around it changes it.
    std::string reference(const ObjectNode& node, const ShapeModifiers& outer) {
        if (!node.name.empty() && node.modifiers.within(outer) == node.modifiers) {
            const auto found = declared_.find(nameOf(node));
            if (found != declared_.end() && found->second == &node) return "object { " + nameOf(node) + " }";
        }
        return objectText(node, outer);
    }

    std::string objectText(const ObjectNode& node, const ShapeModifiers& outer) {
        const ShapeModifiers modifiers = node.modifiers.within(outer);
        std::string text = node.primitive
                               ? povrayPrimitive(*node.primitive, modifiers, parameterTable_, images_)
                               : partsText(node, modifiers);
        if (text.empty()) return {};
        return text + transformText(node) + " }";
    }

    std::string partsText(const ObjectNode& node, const ShapeModifiers& modifiers) {
        std::vector<std::string> parts;
        for (const NodePointer& part : node.parts) {
            parts.push_back(reference(*part, modifiers));
            if (parts.back().empty()) return {};
        }
        const char* word = "union";
        if (node.operation == SetOperation::merge) word = "merge";
        if (node.operation == SetOperation::intersection) word = "intersection";
        if (node.operation == SetOperation::difference) word = "difference";
        std::string text = std::string(word) + " {\n";
        const bool clipping = node.operation == SetOperation::clipping;
        for (std::size_t i = 0; i < parts.size(); ++i)
            text += clipping && i > 0 ? "  clipped_by { " + parts[i] + " }\n" : "  " + parts[i] + "\n";
        if (node.operation == SetOperation::inverse) text += "  inverse";
        if (node.modifiers.bound) {
            const auto& [low, high] = *node.modifiers.bound;
            text += "  clipped_by { box { " + povrayVector(low) + ", " + povrayVector(high) + " } }\n";
        }
        return text;
    }

    static std::string transformText(const ObjectNode& node) {
        std::string text;
        for (const TransformStep& step : node.transforms) {
            const bool rotates = step.kind == TransformStep::Kind::rotate;
            const bool moves = step.kind == TransformStep::Kind::translate;
            glm::dvec3 numbers = step.numbers;
            for (int axis = 0; axis < 3 && !rotates && !moves; ++axis)
                if (numbers[axis] == 0) numbers[axis] = 1;
            text += std::string(rotates ? " rotate "
                                : moves ? " translate "
                                        : " scale ") +
                    povrayVector(numbers);
        }
        return text;
    }

    std::span<const double> parameterTable_;
    HeightImages& images_;
    std::map<std::string, const ObjectNode*> declared_;
};

}  // namespace

std::vector<std::filesystem::path> VirtualightExport::imagesBeside(const std::filesystem::path& file) const {
    std::vector<std::filesystem::path> places;
    for (const auto& [name, image] : images.images) places.push_back(file.parent_path() / name);
    return places;
}

std::string VirtualightExport::write(const std::filesystem::path& file) const {
    for (const auto& [name, image] : images.images) {
        const std::filesystem::path place = file.parent_path() / name;
        if (const std::string reason = writeWhole(place, encodeHeightPng(image)); !reason.empty())
            return place.string() + " cannot be written: " + reason;
    }
    const std::string reason = writeWhole(file, markedExport(text));
    return reason.empty() ? reason : file.string() + " cannot be written: " + reason;
}

VirtualightExport exportVirtualight(const ParseResult& parsed, const Camera& camera,
                                    const std::string& stem) {
    const std::string source((*parsed.sources)[0].text());
    const Document document = virtualight::readDocument(source, parsed.options);
    const Scene& scene = *parsed.scene;
    VirtualightExport result;
    result.images.stem = stem;
    result.text =
        "// Made from a VirtuaLight text.\n#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
        "#default { pigment { rgb " +
        shortestNumber(virtualight::plainColor.red) + " } }\n" + cameraBlock(camera) + "\n";
    for (const LightSource& light : scene.lights)
        result.text += "light_source { " + povrayVector(light.location) + ", rgb 1 }\n";
    result.text += Exporter(*scene.parameterTable, result.images).statements(document);
    return result;
}

VirtualightExport virtualightObjects(const ParseResult& parsed, const std::string& stem) {
    const std::string source((*parsed.sources)[0].text());
    const Document document = virtualight::readDocument(source, parsed.options);
    VirtualightExport result;
    if (document.shown.empty()) return result;
    result.images.stem = stem;
    result.text = "// Made from a VirtuaLight text.\n" +
                  Exporter(*parsed.scene->parameterTable, result.images).statements(document);
    return result;
}

}  // namespace isoscope

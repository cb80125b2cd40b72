// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/scene_variant.h"

#include <map>

#include "core/shapes/composition.h"

namespace isoscope {

namespace {

/// Copies shapes that contain isosurfaces; those that do not are kept. Shared shapes stay shared.
class VariantBuilder {
  public:
    explicit VariantBuilder(const SettingsChange& change) : change_(change) {}

    ShapePointer variant(const ShapePointer& shape) {
        if (!shape) return shape;
        const auto [known, isNew] = variants_.try_emplace(shape.get(), shape);
        if (!isNew) return known->second;
        ShapePointer result = build(shape);
        return variants_[shape.get()] = result;
    }

  private:
    ShapePointer build(const ShapePointer& shape) {
        if (const auto isosurface = asIsosurface(shape)) {
            IsosurfaceSettings settings = isosurface->settings();
            change_(*isosurface, settings);
            return std::make_shared<Isosurface>(std::move(settings));
        }
        const auto partVariant = [this](const ShapePointer& part) { return variant(part); };
        return withChanged(shape, partVariant, partVariant);
    }

    const SettingsChange& change_;
    std::map<const Shape*, ShapePointer> variants_;
};

}  // namespace

std::shared_ptr<const Scene> sceneVariant(const Scene& scene, const SettingsChange& change) {
    auto result = std::make_shared<Scene>(scene);
    VariantBuilder builder(change);
    for (SceneObject& object : result->objects) object.shape = builder.variant(object.shape);
    for (SceneIsosurface& isosurface : result->isosurfaces)
        isosurface.shape = asIsosurface(builder.variant(isosurface.shape));
    return result;
}

}  // namespace isoscope

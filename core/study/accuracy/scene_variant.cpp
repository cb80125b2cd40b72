// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/scene_variant.h"

#include <map>

#include "core/shapes/combined/bounded_shape.h"
#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/csg.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"

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
        if (const auto* isosurface = dynamic_cast<const Isosurface*>(shape.get())) {
            IsosurfaceSettings settings = isosurface->settings();
            change_(*isosurface, settings);
            return std::make_shared<Isosurface>(std::move(settings));
        }
        if (const auto* placed = dynamic_cast<const PlacedShape*>(shape.get())) {
            const ShapePointer inner = variant(placed->shape());
            if (inner == placed->shape()) return shape;
            return std::make_shared<PlacedShape>(inner, placed->transform(), placed->material());
        }
        if (const auto* inverse = dynamic_cast<const InverseShape*>(shape.get())) {
            const ShapePointer inner = variant(inverse->shape());
            return inner == inverse->shape() ? shape : std::make_shared<InverseShape>(inner);
        }
        if (const auto* clipped = dynamic_cast<const ClippedShape*>(shape.get())) {
            const ShapePointer inner = variant(clipped->shape());
            std::vector<ShapePointer> clips = clipped->clips();
            if (!replaceAll(clips) && inner == clipped->shape()) return shape;
            return std::make_shared<ClippedShape>(inner, std::move(clips));
        }
        if (const auto* bounded = dynamic_cast<const BoundedShape*>(shape.get())) {
            const ShapePointer inner = variant(bounded->shape());
            std::vector<ShapePointer> limits = bounded->limits();
            if (!replaceAll(limits) && inner == bounded->shape()) return shape;
            return std::make_shared<BoundedShape>(inner, std::move(limits));
        }
        if (const auto* csg = dynamic_cast<const Csg*>(shape.get())) {
            std::vector<ShapePointer> parts = csg->parts();
            if (!replaceAll(parts)) return shape;
            // The parts of a difference are wrapped already: an intersection with them is the same.
            const bool isDifference = csg->operation() == CsgOperation::difference;
            return std::make_shared<Csg>(isDifference ? CsgOperation::intersection : csg->operation(),
                                         std::move(parts));
        }
        return shape;
    }

    bool replaceAll(std::vector<ShapePointer>& shapes) {
        bool changed = false;
        for (ShapePointer& shape : shapes) {
            const ShapePointer next = variant(shape);
            changed = changed || next != shape;
            shape = next;
        }
        return changed;
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
        isosurface.shape = std::dynamic_pointer_cast<const Isosurface>(builder.variant(isosurface.shape));
    return result;
}

}  // namespace isoscope

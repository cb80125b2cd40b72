// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <new>
#include <utility>

#include "core/mesh/mesh_colors.h"
#include "core/shapes/composition.h"

namespace isoscope {

namespace {

/// Of a triangle with its share of points, normals and colours, and of a copy while it is put behind others.
constexpr std::size_t bytesOfPlaced = 100;

class Placing {
  public:
    explicit Placing(const Scene& scene) {
        for (const SceneIsosurface& isosurface : scene.isosurfaces)
            ranges_.emplace(isosurface.shape.get(), isosurface.range);
    }

    void place(const SceneObject& object) {
        object_ = &object;
        visit(object.shape, Transform(), object.material, false);
    }
    std::vector<PlacedIsosurface> take() { return std::move(placed_); }

  private:
    /// `outer` leads from the shape's coordinates to the world.
    void visit(const ShapePointer& shape, const Transform& outer, MaterialId material, bool cut) {
        if (!shape) return;
        if (auto isosurface = asIsosurface(shape)) {
            const auto range = ranges_.find(isosurface.get());
            placed_.push_back({std::move(isosurface), outer, material,
                               range != ranges_.end() ? range->second : object_->range, cut});
            return;
        }
        const Composition made = shape->composition();
        const Transform inner = made.transform != nullptr ? made.transform->then(outer) : outer;
        using Kind = Composition::Kind;
        const bool alone = made.kind == Kind::wrapped || made.kind == Kind::union_ || made.parts.size() < 2;
        const bool cutHere = cut || !alone || made.kind == Kind::complement || made.limitsCut;
        for (const ShapePointer& part : made.parts)
            visit(part, inner, made.material != noMaterial ? made.material : material, cutHere);
    }

    std::map<const Isosurface*, SourceRange> ranges_;
    const SceneObject* object_ = nullptr;
    std::vector<PlacedIsosurface> placed_;
};

/// How much a map lengthens at most: the largest singular value, from powers of the matrix.
double stretchOf(const Transform& transform) {
    const glm::dmat3 turn(transform.forward());
    const glm::dmat3 square = glm::transpose(turn) * turn;
    glm::dvec3 direction(0.6, 0.7, 0.8);
    for (int step = 0; step < 60; ++step) {
        const glm::dvec3 next = square * direction;
        const double length = glm::length(next);
        if (!(length > 0) || !std::isfinite(length)) return 1;
        direction = next / length;
    }
    return std::sqrt(glm::length(square * direction)) * (1 + 1e-6);
}

void scaleLengths(MeshReport& report, double factor) {
    report.tolerance *= factor;
    report.distance *= factor;
    report.widestDoubtful *= factor;
}

class SceneMesher {
  public:
    SceneMesher(const Scene& scene, const SceneMeshSettings& settings, const std::stop_token& stop)
        : scene_(scene), settings_(settings), stop_(stop) {}

    /// False where there is a problem.
    bool add(const PlacedIsosurface& surface, const std::function<void(double)>& progress) {
        const double stretch = stretchOf(surface.transform);
        MeshSettings own;
        own.tolerance = settings_.tolerance / stretch;
        own.cellLimit = settings_.cellLimit;
        own.bytesOfTriangle = settings_.bytesOfTriangle;
        const std::size_t each = bytesOfPlaced + settings_.bytesOfTriangle;
        const std::size_t taken = each * result_.mesh.triangles.size();
        own.memory = settings_.memory - std::min(taken, settings_.memory);
        own.threads = settings_.threads;
        const std::pair<const Isosurface*, double> key{surface.shape.get(), own.tolerance};
        if (last_.first != key) {
            last_.first = key;
            last_.second = meshIsosurface(*surface.shape, *scene_.parameterTable, own, progress, stop_);
        }
        if (taken + each * last_.second.mesh.triangles.size() > settings_.memory)
            last_.second.tooLarge = true;
        if (last_.second.tooLarge) return fail(tooLargeText(settings_.memory));
        if (!last_.second.problem.empty()) return fail(last_.second.problem);
        IsosurfaceMesh made = last_.second;
        scaleLengths(made.report, stretch);
        made.mesh.transform(surface.transform.forward());
        if (settings_.colors)
            made.mesh.colors = meshColors(scene_, surface.material, made.mesh.points,
                                          made.mesh.pointNormals(), settings_.threads, stop_);
        if (stop_.stop_requested()) return fail("stopped");
        result_.parts.push_back(made.report);
        result_.report.add(made.report);
        if (!made.mesh.triangles.empty()) result_.mesh.append(made.mesh);
        return true;
    }

    bool fail(std::string problem) {
        result_ = {};
        result_.problem = std::move(problem);
        return false;
    }

    SceneMesh finish() {
        if (!result_.problem.empty()) return std::move(result_);
        if (result_.mesh.triangles.empty()) {
            result_.problem = "there is no surface in the container";
            return std::move(result_);
        }
        result_.report.form = formOf(result_.mesh);
        return std::move(result_);
    }

  private:
    const Scene& scene_;
    const SceneMeshSettings& settings_;
    std::stop_token stop_;
    SceneMesh result_;
    /// Copies of one isosurface follow each other and share their mesh.
    std::pair<std::pair<const Isosurface*, double>, IsosurfaceMesh> last_;
};

}  // namespace

std::vector<PlacedIsosurface> placedIsosurfaces(const Scene& scene) {
    Placing placing(scene);
    for (const SceneObject& object : scene.objects)
        if (object.visible) placing.place(object);
    return placing.take();
}

SceneMesh meshScene(const Scene& scene, const std::vector<PlacedIsosurface>& surfaces,
                    const SceneMeshSettings& settings, const std::function<void(double)>& progress,
                    const std::stop_token& stop) {
    try {
        SceneMesher mesher(scene, settings, stop);
        if (surfaces.empty()) mesher.fail("the scene has no isosurface");
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const auto share = [&](double done) {
                if (progress)
                    progress((static_cast<double>(i) + done) / static_cast<double>(surfaces.size()));
            };
            if (!mesher.add(surfaces[i], share)) break;
        }
        return mesher.finish();
    } catch (const std::bad_alloc&) {
        SceneMesh failed;
        failed.problem = "there is not enough memory for so fine a mesh";
        return failed;
    }
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/compile_materials.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/texture/film_function.h"
#include "core/texture/normal_function.h"
#include "core/texture/pigment_function.h"
#include "core/texture/transparency.h"
#include "core/texture/warped_material.h"

namespace isoscope {

namespace {

/// Materials beyond are shown without their parts: no text may use up the memory.
constexpr std::size_t materialLimit = 500'000;

class MaterialCompiler {
  public:
    explicit MaterialCompiler(Scene& scene)
        : scene_(scene), settings_{scene.settings.noiseGenerator, scene.settings.numberOfWaves} {}

    bool compileAll(std::span<Material* const> others) {
        // Parts are added at the end and get their turn.
        for (std::size_t id = 0; id < scene_.materials.size(); ++id) {
            scene_.materials[id].transparent = mayLetLightThrough(scene_.materials[id]);
            compile(id);
        }
        for (Material* other : others) compilePlain(*other);
        if (scene_.camera.normal) scene_.camera.normalTape = normal(scene_.camera.normal);
        return complete_;
    }

  private:
    struct CompiledMap {
        std::shared_ptr<const Tape> tape;
        std::vector<Material> entries;
    };
    struct CompiledPigment {
        std::shared_ptr<const Tape> tape;
        SolidPigment solid;
    };

    void compile(std::size_t id) {
        if (const auto map = scene_.materials[id].map) return compileMap(id, map);
        if (!scene_.materials[id].below.empty()) return separateLayers(id);
        compilePlain(scene_.materials[id]);
    }

    void compilePlain(Material& material) {
        material.finish = plainFinish(std::move(material.finish));
        if (const auto* mapped = std::get_if<std::shared_ptr<const MappedPigment>>(&material.pigment)) {
            const CompiledPigment& compiled = pigment(*mapped);
            material.pigmentTape = compiled.tape;
            material.image = (*mapped)->image;
            if (!compiled.tape) material.pigment = compiled.solid;
        }
        if (material.normal && !material.normal->flat) material.normalTape = normal(material.normal);
        if (material.finish.irid != 0 && material.finish.iridTurbulence != 0)
            material.filmTape = compiled(filmFunction(material.finish, settings_.noiseGenerator));
    }

    void compileMap(std::size_t id, const std::shared_ptr<const MappedTexture>& pointer) {
        const MappedTexture& map = *pointer;
        if (scene_.materials.size() + map.entries.size() > materialLimit) return leaveOut();
        const auto [found, isNew] = maps_.try_emplace(pointer);
        CompiledMap& compiledMap = found->second;
        if (isNew) {
            const std::vector<PatternWarp> warps = allWarps(map.pattern);
            for (const MappedTexture::Entry& entry : map.entries)
                compiledMap.entries.push_back(warped(entry.material, warps));
            if (map.kind == MapKind::blend || map.kind == MapKind::list)
                compiledMap.tape = compiled(patternFunction(map.pattern, settings_, map.onSurface));
        }
        const Transform outer = scene_.materials[id].mapTransform;
        std::vector<MaterialId> parts;
        for (const Material& entry : compiledMap.entries)
            parts.push_back(add(moved(entry, outer), scene_.materials[id]));
        scene_.materials[id].mapTape = compiledMap.tape;
        scene_.materials[id].parts = std::move(parts);
    }

    void separateLayers(std::size_t id) {
        std::vector<Material> below = std::move(scene_.materials[id].below);
        scene_.materials[id].below.clear();
        if (scene_.materials.size() + below.size() > materialLimit) return leaveOut();
        const Material whole = scene_.materials[id];
        std::vector<MaterialId> parts{add(whole, whole)};
        // A map cannot be a layer, as in POV-Ray; its first entry stands for it.
        for (Material& layer : below) {
            while (layer.map) layer = Material(std::as_const(layer).map->entries.front().material);
            parts.push_back(add(std::move(layer), whole));
        }
        scene_.materials[id].parts = std::move(parts);
    }

    void leaveOut() { complete_ = false; }

    /// A part of another one.
    MaterialId add(Material material, const Material& whole) {
        material.interior = whole.interior;
        material.lightGroup = whole.lightGroup;
        material.doubleIlluminate = whole.doubleIlluminate;
        if (!material.surface) material.surface = whole.surface;
        scene_.materials.push_back(std::move(material));
        return static_cast<MaterialId>(scene_.materials.size() - 1);
    }

    const CompiledPigment& pigment(const std::shared_ptr<const MappedPigment>& mapped) {
        const auto [found, isNew] = pigments_.try_emplace(mapped);
        CompiledPigment& result = found->second;
        if (!isNew) return result;
        const Function function = pigmentFunction(mapped, settings_);
        complete_ &= function.valid();
        result.solid.color = {0.5, 0.5, 0.5, 0, 0};
        if (!function.valid()) return result;
        const FunctionGraph& graph = *function.graph;
        if (!mapped->image && std::all_of(function.results.begin(), function.results.end(),
                                          [&](NodeId node) { return graph.isConstant(node); })) {
            const auto constant = [&](std::size_t k) { return graph.value(function.results[k]); };
            result.solid.color = {constant(0), constant(1), constant(2), constant(3), constant(4)};
        } else {
            result.tape = Tape::compile(function);
        }
        return result;
    }

    std::shared_ptr<const Tape> normal(const std::shared_ptr<const SurfaceNormal>& normal) {
        const auto [found, isNew] = normals_.try_emplace(normal);
        if (isNew) found->second = compiled(normalFunction(*normal, settings_));
        return found->second;
    }

    std::shared_ptr<const Tape> compiled(const Function& function) {
        complete_ &= function.valid();
        return function.valid() ? Tape::compile(function) : nullptr;
    }

    Scene& scene_;
    PatternSettings settings_;
    std::map<std::shared_ptr<const MappedPigment>, CompiledPigment> pigments_;
    std::map<std::shared_ptr<const SurfaceNormal>, std::shared_ptr<const Tape>> normals_;
    std::map<std::shared_ptr<const MappedTexture>, CompiledMap> maps_;
    bool complete_ = true;
};

}  // namespace

bool compileMaterials(Scene& scene, std::span<Material* const> others) {
    return MaterialCompiler(scene).compileAll(others);
}

}  // namespace isoscope

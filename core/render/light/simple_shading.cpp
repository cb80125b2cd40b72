// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/simple_shading.h"

// foreach_target.h includes this very file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/light/simple_shading.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "core/render/light/light_arrival.h"
#include "core/render/light/surface_light-inl.h"
#include "core/render/light/transmission.h"

#ifndef ISOSCOPE_RENDER_PLAIN_LIGHT_ONCE
#define ISOSCOPE_RENDER_PLAIN_LIGHT_ONCE
namespace isoscope {

/// What is painted, and with what.
struct PlainPainting {
    std::span<const glm::dvec3> lights;
    std::span<const SimpleSurface> surfaces;
    const RayBatch& rays;
    const HitBatch& hits;
    LinearColor* pixels;
    Verdict* verdicts;

    const SimpleSurface& surface(MaterialId id) const {
        const auto index = static_cast<std::size_t>(id);
        return id >= 0 && index < surfaces.size() ? surfaces[index] : surfaces.back();
    }
};

}  // namespace isoscope
#endif

HWY_BEFORE_NAMESPACE();
namespace isoscope::HWY_NAMESPACE {
namespace {

using Mask = hn::Mask<Doubles>;
using Floats = hn::Rebind<float, Doubles>;

/// As returned() for a matte surface; the normal is turned to the viewer.
HWY_INLINE Triple returnedEvenly(const Lighting& lighting, const Triple& facing, const Triple& light) {
    const Vector cosine = dot(facing, light);
    const Vector lit = hn::IfThenElseZero(positive(cosine), cosine);
    return times(constant(lighting.pigment), hn::Mul(constant(lighting.finish.diffuse), lit));
}

/// As aimAt() and findReturned() one after the other.
template <bool matte>
HWY_INLINE Triple shineOf(const SimpleSurface& surface, std::span<const glm::dvec3> lights,
                          const Triple& point, const Triple& normal, const Triple& view) {
    const Triple facing =
        times(normal, hn::IfThenElse(positive(dot(normal, view)), constant(-1), constant(1)));
    Triple shine = constant(surface.shine);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const Lighting& lighting = surface.lightings[k];
        const Triple arm = minus(constant(lights[k]), point);
        const Vector distance = hn::Sqrt(dot(arm, arm));
        const Triple unit = times(arm, hn::Div(constant(1), distance));
        const auto apart = positive(distance);
        const Triple toLight{hn::IfThenElseZero(apart, unit.x), hn::IfThenElseZero(apart, unit.y),
                             hn::IfThenElseZero(apart, unit.z)};
        Triple white;
        if constexpr (matte)
            white = returnedEvenly(lighting, facing, toLight);
        else
            white = returned(lighting, constant(lighting.pigment), constant(lighting.tint), normal, view,
                             toLight, constant(lighting.finish.iridThickness));
        const Triple arriving = constant(lighting.light);
        shine = plus(shine, {returnedLight(white.x, arriving.x), returnedLight(white.y, arriving.y),
                             returnedLight(white.z, arriving.z)});
    }
    return shine;
}

/// Between 0 and 1; NaN becomes 0.
HWY_INLINE hn::Vec<Floats> clipped(Vector value) {
    const Vector some = hn::IfThenElseZero(positive(value), value);
    return hn::DemoteTo(Floats(), hn::Min(some, constant(1)));
}

/// The rays in the lanes of `which`, of those from ray i on. `together`: they are all, of samples that follow
/// each other.
HWY_INLINE void put(const Triple& shine, Mask which, bool together, std::size_t i,
                    const PlainPainting& painting) {
    const Floats floats;
    const auto red = clipped(shine.x), green = clipped(shine.y), blue = clipped(shine.z);
    const std::uint32_t* const samples = painting.rays.samples() + i;
    if (together) {
        hn::StoreInterleaved3(red, green, blue, floats, painting.pixels[samples[0]].data());
        return;
    }
    HWY_ALIGN float channels[3][hn::MaxLanes(Floats())];
    hn::Store(red, floats, channels[0]);
    hn::Store(green, floats, channels[1]);
    hn::Store(blue, floats, channels[2]);
    forEachLane(which, [&](std::size_t lane) {
        painting.pixels[samples[lane]] = {channels[0][lane], channels[1][lane], channels[2][lane]};
    });
}

HWY_INLINE void noteHit(Verdict& verdict) {
    if (verdict <= Verdict::certifiedMiss) verdict = Verdict::certifiedHit;
}

HWY_INLINE void noteHits(Mask met, bool together, std::size_t i, const PlainPainting& painting) {
    const std::uint32_t* const samples = painting.rays.samples() + i;
    if (together && hn::Lanes(Doubles()) == 8) {
        static_assert(sizeof(Verdict) == 1 && static_cast<int>(Verdict::certifiedHit) == 0 &&
                      static_cast<int>(Verdict::certifiedMiss) == 1);
        std::uint64_t eight;
        std::memcpy(&eight, painting.verdicts + samples[0], sizeof eight);
        if ((eight & 0xfefefefefefefefe) == 0) {
            std::memset(painting.verdicts + samples[0], 0, sizeof eight);
            return;
        }
    }
    if (together)
        for (std::size_t lane = 0; lane < hn::Lanes(Doubles()); ++lane)
            noteHit(painting.verdicts[samples[0] + lane]);
    else
        forEachLane(met, [&](std::size_t lane) { noteHit(painting.verdicts[samples[lane]]); });
}

/// Those of the lanes of `met` that have the same material as the first of them, which is set; whole vectors
/// must not be read beyond `count` rays.
HWY_INLINE Mask sameMaterial(Mask met, const MaterialId* materials, std::size_t count, MaterialId& id) {
    constexpr std::size_t lanes = hn::MaxLanes(Doubles());
    id = materials[hn::FindKnownFirstTrue(Doubles(), met)];
    const hn::Rebind<MaterialId, Doubles> ids;
    if (count >= lanes && hn::AllTrue(ids, hn::Eq(hn::LoadU(ids, materials), hn::Set(ids, id)))) return met;
    HWY_ALIGN double flags[lanes] = {};
    for (std::size_t lane = 0; lane < std::min(lanes, count); ++lane)
        flags[lane] = materials[lane] == id ? 1 : 0;
    return hn::And(met, positive(hn::Load(Doubles(), flags)));
}

void paintAll(const PlainPainting& painting) {
    const std::array<const double*, 3> origins = painting.rays.origins(),
                                       directions = painting.rays.directions();
    const HitBatch& hits = painting.hits;
    const std::array<const double*, 3> normals{hits[HitBatch::normalX], hits[HitBatch::normalY],
                                               hits[HitBatch::normalZ]};
    const std::uint32_t* const samples = painting.rays.samples();
    constexpr std::size_t lanes = hn::MaxLanes(Doubles());
    for (std::size_t i = 0; i < hits.size(); i += lanes) {
        const Vector t = hn::LoadU(Doubles(), hits[HitBatch::t] + i);
        const Mask met =
            hn::And(hn::FirstN(Doubles(), hits.size() - i), hn::Lt(t, constant(HitBatch::never)));
        if (hn::AllFalse(Doubles(), met)) continue;
        const Triple view = load(directions, i), normal = load(normals, i);
        const Triple point = plus(load(origins, i), times(view, t));
        const bool together = hn::AllTrue(Doubles(), met) && samples[i + lanes - 1] - samples[i] == lanes - 1;
        noteHits(met, together, i, painting);
        for (Mask rest = met; !hn::AllFalse(Doubles(), rest);) {
            MaterialId id;
            const Mask same = sameMaterial(rest, hits.materials() + i, hits.size() - i, id);
            const SimpleSurface& surface = painting.surface(id);
            const Triple shine = surface.matte
                                     ? shineOf<true>(surface, painting.lights, point, normal, view)
                                     : shineOf<false>(surface, painting.lights, point, normal, view);
            put(shine, same, together && hn::AllTrue(Doubles(), same), i, painting);
            rest = hn::AndNot(same, rest);
        }
    }
}

}  // namespace
}  // namespace isoscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isoscope {

HWY_EXPORT(paintAll);

namespace {

/// More would take more memory than they save time.
constexpr std::size_t mostLightings = 4096;

bool isPlain(const LightSource& light) {
    return light.kind == LightKind::point && spreadsEvenly(light) && !light.area;
}

bool isPlain(const Material& material) {
    return !material.patterned() && !material.transparent && !material.filmTape;
}

bool isMatte(const Lighting& lighting) {
    const Finish& finish = lighting.finish;
    return !lighting.highlights && !lighting.patterned && !lighting.doubled && !lighting.bent &&
           finish.brilliance == 1 && finish.diffuseBack <= 0 && finish.irid == 0;
}

bool isPlain(const Scene& scene, const RenderPlan& plan) {
    const auto isKnown = [](const PlannedStage& stage) {
        return stage.kind == StageKind::primaryRays || stage.kind == StageKind::background ||
               stage.kind == StageKind::directLight;
    };
    return std::all_of(plan.stages.begin(), plan.stages.end(), isKnown) && plan.stages.size() == 3 &&
           scene.lightGroups.size() <= 1 &&
           scene.lights.size() * (scene.materials.size() + 1) <= mostLightings &&
           std::all_of(scene.lights.begin(), scene.lights.end(),
                       [](const LightSource& light) { return isPlain(light); }) &&
           std::all_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& material) { return isPlain(material); });
}

}  // namespace

std::optional<SimpleShading> SimpleShading::of(const Scene& scene, const RenderPlan& plan) {
    if (!isPlain(scene, plan)) return {};
    SimpleShading plain;
    for (const LightSource& light : scene.lights) plain.lights_.push_back(light.location);
    const auto add = [&](const Material& material) {
        SimpleSurface& surface = plain.surfaces_.emplace_back();
        surface.shine = selfLight(material, opacityRule(scene), rgb(scene.settings.ambientLight));
        for (const LightSource& light : scene.lights)
            surface.lightings.push_back(
                lightingOf(light, material, opacityRule(scene), rgb(scene.settings.iridWavelength)));
        surface.matte = std::all_of(surface.lightings.begin(), surface.lightings.end(), isMatte);
    };
    for (const Material& material : scene.materials) add(material);
    add({});
    return plain;
}

void SimpleShading::paint(const RayBatch& rays, const HitBatch& hits, std::span<LinearColor> pixels,
                          std::span<Verdict> verdicts) const {
    HWY_DYNAMIC_DISPATCH(paintAll)
    ({lights_, surfaces_, rays, hits, pixels.data(), verdicts.data()});
}

}  // namespace isoscope
#endif

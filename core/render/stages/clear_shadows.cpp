// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/clear_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/effect_reasons.h"
#include "core/render/light/interior_list.h"
#include "core/render/light/transmission.h"
#include "core/render/picture_parts.h"
#include "core/render/stages/textures.h"

namespace isoscope {

namespace {

/// As of Shadows.
constexpr double tolerance = 1e-3;
/// Surfaces on the way of one beam.
constexpr int surfaceLimit = 1000;
/// Less is not seen.
constexpr double darkness = 1e-4;

/// How much brighter light is that meets a surface like this, by POV-Ray's `caustics` (measured).
double gathered(double caustics, double cosine) {
    return caustics > 0 ? 1 + std::pow(std::abs(cosine), 45 * caustics) : 1;
}

}  // namespace

/// The light between its sources and the points of one batch.
struct ClearShadows::Beams : public ShapeState {
    struct Beam {
        std::uint32_t point = 0;
        Ray ray;
        double limit = 0;  ///< what is left of the way
        glm::dvec3 light{1}, passing{0};
        bool met = false;
        InteriorList inside{};  ///< as of the ray that sees the point
        InteriorId passed = noInterior;
    };
    std::vector<Beam> beams;
    RayBatch rays;
    HitBatch hits;
    SurfacePoints points;  ///< their samples are numbers of beams
};

ClearShadows::ClearShadows(const Scene& scene, const Textures* textures, bool media)
    : scene_(scene), textures_(textures), objects_(scene, concerns) {
    if (media) media_.emplace(scene, MediaMarch::Concerned{false, true}, nullptr);
}

void ClearShadows::filter(TileScratch& work, SurfacePoints& points, std::size_t light) const {
    if (scene_.lights[light].shadowless) return;
    Beams& own = work.context.state<Beams>(this, [] { return std::make_unique<Beams>(); });
    own.beams.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (at(points.returned, k) == glm::dvec3(0)) continue;
        const Ray ray{at(points.point, k), at(points.toLight, k)};
        own.beams.push_back({static_cast<std::uint32_t>(k), ray, points.distance[k] - tolerance});
        if (work.lit) own.beams.back().inside = work.lit->path(points.samples[k]).inside;
    }
    for (int step = 0; !own.beams.empty() && step < surfaceLimit; ++step) {
        if (work.context.stop.stop_requested()) break;
        findSurfaces(work, own);
        if (media_) dimByMedia(work, own, points);
        for (const Beams::Beam& beam : own.beams)
            if (beam.met)
                for (std::size_t c = 0; c < 3; ++c)
                    points.returned[c][beam.point] *= beam.passing[static_cast<int>(c)];
        goOn(own);
    }
    work.charge(StageKind::clearShadows);
}

void ClearShadows::findSurfaces(TileScratch& work, Beams& own) const {
    const std::size_t count = own.beams.size();
    own.rays.clear();
    own.rays.reserve(count);
    own.rays.setSize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Ray ray = own.beams[i].ray;
        ray.sample = static_cast<std::uint32_t>(i);
        own.rays.set(i, ray);
    }
    const bool missMemory = work.context.missMemory;
    work.meter(StageKind::clearShadows).rays += count;
    work.context.missMemory = false;
    work.context.nearLimit = tolerance;
    objects_.nearest(own.rays, work.context, work.gathered, own.hits);
    work.context.nearLimit = 0;
    work.context.missMemory = missMemory;
    for (std::size_t i = 0; i < count; ++i) {
        Beams::Beam& beam = own.beams[i];
        beam.met = own.hits[HitBatch::t][i] < beam.limit;
        beam.passing = glm::dvec3(0);
        beam.passed = noInterior;
        if (!beam.met) own.hits.limit(i, HitBatch::never);
    }
    own.points.clear();
    own.points.gather(own.rays, own.hits);
    if (textures_) textures_->lookUp(own.points, work);
    for (std::size_t k = 0; k < own.points.size(); ++k) {
        Beams::Beam& beam = own.beams[own.points.samples[k]];
        beam.passing += passing(own, k);
        const MaterialId id = own.points.materials[k];
        if (id >= 0 && static_cast<std::size_t>(id) < scene_.materials.size())
            beam.passed = scene_.materials[static_cast<std::size_t>(id)].interior;
    }
}

glm::dvec3 ClearShadows::passing(const Beams& own, std::size_t k) const {
    const SurfacePoints& points = own.points;
    const MaterialId id = points.materials[k];
    if (id < 0 || static_cast<std::size_t>(id) >= scene_.materials.size()) return glm::dvec3(0);
    const Material& material = scene_.materials[static_cast<std::size_t>(id)];
    glm::dvec3 result = transmissionAt(material, points, k);
    if (material.interior == noInterior) return result;
    const Interior& interior = scene_.interiors[static_cast<std::size_t>(material.interior)];
    const Beams::Beam& beam = own.beams[points.samples[k]];
    const Ray& ray = beam.ray;
    const double cosine = glm::dot(ray.direction, at(points.normal, k));
    // Without a power interiors dim what is seen through them, but not their shadows, as in POV-Ray.
    if (interior.fades() && interior.fadePower > 0 && beam.inside.has(material.interior))
        result *= fading(interior, glm::distance(at(points.point, k), ray.origin));
    return result * gathered(interior.caustics, cosine);
}

/// By what fills the objects that the beams are in, up to the next surface. Between the last one and the
/// light media take nothing, as in POV-Ray.
void ClearShadows::dimByMedia(TileScratch& work, Beams& own, SurfacePoints& points) const {
    auto& march = work.context.state<MediaMarch::Work>(
        &*media_, [&] { return std::make_unique<MediaMarch::Work>(work.context.parameters()); });
    march.ways.clear();
    for (std::size_t i = 0; i < own.beams.size(); ++i) {
        const Beams::Beam& beam = own.beams[i];
        if (beam.met && media_->fills(beam.inside))
            march.ways.push_back(
                {beam.ray, own.hits[HitBatch::t][i], beam.inside, static_cast<std::uint32_t>(i)});
    }
    media_->find(work, march);
    for (const MediaMarch::Way& way : march.ways) {
        Beams::Beam& beam = own.beams[way.sample];
        beam.light *= way.through;
        for (std::size_t c = 0; c < 3; ++c)
            points.returned[c][beam.point] *= way.through[static_cast<int>(c)];
    }
}

void ClearShadows::goOn(Beams& own) const {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < own.beams.size(); ++i) {
        Beams::Beam& beam = own.beams[i];
        if (!beam.met) continue;
        beam.light *= beam.passing;
        if (beam.inside.has(beam.passed))
            beam.inside.leave(beam.passed);
        else if (beam.passed != noInterior)
            beam.inside.enter(beam.passed);
        if (!(std::max({beam.light.x, beam.light.y, beam.light.z}) > darkness)) continue;
        const double way = own.hits[HitBatch::t][i];
        beam.ray.origin += way * beam.ray.direction;
        beam.limit -= way;
        own.beams[kept++] = beam;
    }
    own.beams.resize(kept);
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    if (!firstCastingLight(scene)) return {false, "no light casts shadows"};
    return reasonOfObjects(scene, ClearShadows::concerns, "lets light through",
                           "no transparent object casts");
}

void build(PictureParts& parts) {
    parts.lightFilters->shadows.add(
        std::make_unique<ClearShadows>(parts.scene(), parts.textures, parts.plan.has(StageKind::media)));
}

}  // namespace

const EffectDescription effects::clearShadows{
    .name = "light through glass",
    .reasonFor = reasonFor,
    .build = build,
    .leftOutNote = "; without it these objects cast no shadow",
};

}  // namespace isoscope

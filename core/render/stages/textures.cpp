// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/stages/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>
#include <utility>

#include "core/render/camera/mirror.h"
#include "core/render/effect_reasons.h"
#include "core/render/light/transmission.h"
#include "core/render/picture_parts.h"
#include "core/texture/color_lookup.h"
#include "core/texture/map_shares.h"

namespace isoscope {

namespace {

/// A part of the texture of a point.
struct Part {
    std::size_t point = 0;
    MaterialId material = noMaterial;
    double share = 1;
    int depth = 0;  ///< layers above it
};

/// Which entries of the material's map show at point k, where its pattern has `value`.
void findShares(const SurfacePoints& points, std::size_t k, const Material& material, double value,
                std::vector<MapShare>& shares) {
    shares.clear();
    switch (material.map->kind) {
        case MapKind::sides: {
            const bool inside = glm::dot(at(points.normal, k), at(points.view, k)) > 0;
            return shares.push_back({inside ? std::size_t{1} : 0, 1});
        }
        case MapKind::surface: {
            const TexturedShape& on = *material.surface;
            const glm::dvec3 place = on.transform.inversePoint(at(points.point, k));
            for (const TextureShare& share : on.shape->textureShares(place))
                if (share.texture < material.parts.size()) shares.push_back({share.texture, share.share});
            return;
        }
        default: return findMapShares(*material.map, value, shares);
    }
}

/// What the pattern of a material knows of point k.
SurfacePlace placeOf(const SurfacePoints& points, std::size_t k, const Material& material) {
    const glm::dvec3 view = at(points.view, k), normal = facingNormal(points, k, material);
    return {normal, view, surfaceCoordinates(material, at(points.point, k))};
}

void set(SurfacePoints::Vectors& columns, std::size_t k, const glm::dvec3& value) {
    for (int c = 0; c < 3; ++c) columns[static_cast<std::size_t>(c)][k] = value[c];
}

std::array<double, 3> numbers(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

/// The scratch memory of one thread.
class TextureWork : public ShapeState {
  public:
    explicit TextureWork(std::span<const double> parameters) : lookup(parameters), pigments(parameters) {}

    /// Lays the points out anew, one for each part.
    void spread(SurfacePoints& points);

    TapeLookup lookup;
    ColorLookup pigments;
    std::vector<Part> parts;     ///< of weighted points, one each
    std::vector<Color> colors;   ///< their pigments
    std::vector<double> values;  ///< of the maps, one for each part
    std::vector<Part> finer;     ///< parts of the parts
    std::vector<MapShare> shares;

  private:
    SurfacePoints::Column column_;
    std::vector<std::uint32_t> samples_;
};

void TextureWork::spread(SurfacePoints& points) {
    const std::size_t room = parts.size() + SurfacePoints::padding;
    for (SurfacePoints::Vectors* vectors : {&points.point, &points.normal, &points.view})
        for (SurfacePoints::Column& column : *vectors) {
            if (column_.size() < room) column_.resize(room);
            for (std::size_t k = 0; k < parts.size(); ++k) column_[k] = column[parts[k].point];
            column_.swap(column);
        }
    samples_.clear();
    points.materials.clear();
    for (const Part& part : parts) {
        samples_.push_back(points.samples[part.point]);
        points.materials.push_back(part.material);
    }
    points.samples.swap(samples_);
    points.weighted = true;
    points.makeRoom(parts.size());
}

Textures::Textures(const Scene& scene, bool transparency) : scene_(scene), transparency_(transparency) {
    for (const Material& material : scene.materials) {
        hasParts_ |= !material.parts.empty();
        tints_ |= material.finish.reflectionMetallic != 0 || material.finish.metallic != 0;
        hasNormals_ |= material.normalTape != nullptr;
    }
}

void Textures::run(TileScratch& work, SampleBatch& batch) const {
    lookUp(batch.points, &batch, work);
    work.charge(StageKind::textures);
}

void Textures::lookUp(SurfacePoints& points, const SampleBatch* batch, TileScratch& work) const {
    TextureWork& own = work.context.state<TextureWork>(
        this, [&] { return std::make_unique<TextureWork>(work.context.parameters()); });
    std::size_t evaluations = 0;
    points.lookedUp = true;
    points.makeRoom(points.size());
    if (hasParts_) evaluations += separateParts(points, own);
    if (hasNormals_) evaluations += bendNormals(points, own);
    evaluations += findPigments(points, own);
    if (points.weighted) weighParts(points, batch, own);
    work.context.evaluations += evaluations;
}

const Material* Textures::materialOf(MaterialId id) const {
    return id >= 0 && static_cast<std::size_t>(id) < scene_.materials.size()
               ? &scene_.materials[static_cast<std::size_t>(id)]
               : nullptr;
}

std::size_t Textures::separateParts(SurfacePoints& points, TextureWork& own) const {
    std::vector<Part>& parts = own.parts;
    parts.clear();
    bool some = false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        parts.push_back({k, points.materials[k]});
        const Material* material = materialOf(points.materials[k]);
        some |= material && !material->parts.empty();
    }
    if (!some) return 0;
    std::size_t evaluations = 0;
    // Maps may hold maps; each round takes the outermost ones apart. Their depth is limited.
    for (bool again = true; again;) {
        own.values.assign(parts.size(), 0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Material* material = materialOf(parts[i].material);
            if (!material || !material->mapTape) continue;
            const std::size_t k = parts[i].point;
            const glm::dvec3 place = material->mapTransform.inversePoint(at(points.point, k));
            if (needsSurface(*material->mapTape))
                own.lookup.ask(material->mapTape,
                               surfaceArguments(place, glm::dvec3(0), placeOf(points, k, *material)), i);
            else
                own.lookup.ask(material->mapTape, numbers(place), i);
        }
        evaluations += own.lookup.answer(
            [&](std::size_t i, std::span<const double> value) { own.values[i] = value[0]; });
        again = takeApart(points, own);
    }
    own.spread(points);
    return evaluations;
}

bool Textures::takeApart(const SurfacePoints& points, TextureWork& own) const {
    std::vector<Part>& finer = own.finer;
    finer.clear();
    bool apart = false;
    for (std::size_t i = 0; i < own.parts.size(); ++i) {
        const Part& part = own.parts[i];
        const Material* material = materialOf(part.material);
        if (!material || material->parts.empty()) {
            finer.push_back(part);
            continue;
        }
        apart = true;
        if (!material->map) {
            for (std::size_t depth = 0; depth < material->parts.size(); ++depth)
                finer.push_back({part.point, material->parts[depth], part.share, static_cast<int>(depth)});
            continue;
        }
        findShares(points, part.point, *material, own.values[i], own.shares);
        for (const MapShare& share : own.shares)
            finer.push_back({part.point, material->parts[share.entry], part.share * share.share});
    }
    own.parts.swap(finer);
    return apart;
}

/// POV-Ray bends the normal that faces the viewer; the bent one may point anywhere.
std::size_t Textures::bendNormals(SurfacePoints& points, TextureWork& own) const {
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Material* material = materialOf(points.materials[k]);
        if (!material || !material->normalTape) continue;
        glm::dvec3 normal = at(points.normal, k);
        if (glm::dot(normal, at(points.view, k)) > 0) normal = -normal;
        set(points.normal, k, normal);
        set(points.straight, k, normal);
        const Transform& transform = material->normalTransform;
        const glm::dvec3 place = transform.inversePoint(at(points.point, k));
        const glm::dvec3 turned = glm::transpose(glm::dmat3(transform.forward())) * normal;
        if (needsSurface(*material->normalTape)) {
            own.lookup.ask(material->normalTape,
                           surfaceArguments(place, turned, placeOf(points, k, *material)), k);
            continue;
        }
        const std::array<double, 6> arguments{place.x, place.y, place.z, turned.x, turned.y, turned.z};
        own.lookup.ask(material->normalTape, arguments, k);
    }
    return own.lookup.answer([&](std::size_t k, std::span<const double> bent) {
        const Material& material = *materialOf(points.materials[k]);
        const glm::dvec3 normal = material.normalTransform.normal({bent[0], bent[1], bent[2]});
        const double size = glm::length(normal);
        if (size > 0 && std::isfinite(size)) set(points.normal, k, normal / size);
    });
}

std::size_t Textures::findPigments(SurfacePoints& points, TextureWork& own) const {
    own.colors.assign(points.weighted ? points.size() : 0, Color{});
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Material* material = materialOf(points.materials[k]);
        if (!material) continue;
        if (material->pigmentTape)
            own.pigments.ask(*material, at(points.point, k), k,
                             [&] { return placeOf(points, k, *material); });
        else if (points.weighted)
            own.colors[k] = std::get<SolidPigment>(material->pigment).color;
    }
    return own.pigments.answer([&](std::size_t k, const Color& color) {
        if (points.weighted) {
            own.colors[k] = color;
            return;
        }
        if (tints_) set(points.tint, k, rgb(color));
        if (!transparency_) return set(points.pigment, k, rgb(color));
        const bool clear = materialOf(points.materials[k])->transparent;
        set(points.pigment, k, clear ? rgb(color) * opacity(color, opacityRule(scene_)) : rgb(color));
        set(points.transmission, k, clear ? transmission(color) : glm::dvec3(0));
    });
}

/// Layers follow one another from the outside in. Each hides what is below as far as it is opaque, and its
/// pigment counts as far; its highlights keep their strength, and so does what it mirrors, as in POV-Ray.
void Textures::weighParts(SurfacePoints& points, const SampleBatch* batch, TextureWork& own) const {
    const OpacityRule rule = opacityRule(scene_);
    glm::dvec3 through(1);
    points.outermost.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool top = own.parts[k].depth == 0;
        if (top) through = glm::dvec3(1);
        points.outermost[k] = top ? 1 : 0;
        const Color& color = own.colors[k];
        const bool lowest = k + 1 == points.size() || own.parts[k + 1].depth == 0;
        const double opaque = lowest && !transparency_ ? 1 : opacity(color, rule);
        const double share = own.parts[k].share;
        set(points.tint, k, rgb(color));
        set(points.pigment, k, rgb(color) * opaque);
        set(points.weight, k, through * share);
        points.share[k] = isSeen(through) ? share : 0;
        through *= transmission(color);
        if (batch) through *= conserved(points, k, *batch);
        set(points.transmission, k, lowest && transparency_ ? through * share : glm::dvec3(0));
    }
}

bool Textures::isSeen(const glm::dvec3& through) const {
    return std::max({through.x, through.y, through.z}) >= scene_.settings.adcBailout;
}

glm::dvec3 Textures::conserved(const SurfacePoints& points, std::size_t k, const SampleBatch& batch) const {
    const Material* material = materialOf(points.materials[k]);
    if (!material || !material->finish.conserveEnergy || !material->finish.reflects()) return glm::dvec3(1);
    return glm::dvec3(1) - reflectanceAt(scene_, *material, points, k, batch.path(points.samples[k]));
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    if (countObjects(scene, &SceneObject::visible) == 0) return {false, "there is nothing to paint"};
    std::set<const Tape*> patterns;
    bool some = false;
    for (const Material& material : scene.materials) {
        some |= material.patterned();
        for (const auto& tape : {material.pigmentTape, material.normalTape, material.mapTape})
            if (tape) patterns.insert(tape.get());
    }
    if (!some) return {false, "every material is plain"};
    return {true, "materials with " + counted(patterns.size(), "pattern")};
}

void build(PictureParts& parts) {
    auto textures = std::make_unique<Textures>(parts.scene(), parts.plan.has(StageKind::transparency));
    parts.textures = textures.get();
    parts.addSurfaceStage(std::move(textures));
}

}  // namespace

const EffectDescription effects::textures{.name = "textures", .reasonFor = reasonFor, .build = build};

}  // namespace isoscope

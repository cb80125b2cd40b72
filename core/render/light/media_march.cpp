// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/media_march.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/render/light/surface_light.h"
#include "core/render/progressive/tile_scratch.h"

namespace isoscope {

namespace {

/// Samples of a group of ways, each of them times its media, but for those of the last way.
constexpr std::size_t groupSamples = 1 << 13;
/// Beams that divide one way.
constexpr std::size_t mostBeams = 100;
/// Where a way does not end, in POV-Ray as here.
constexpr double horizon = 1e10;

/// How many parts an interval has.
std::size_t partsOf(const Medium& medium) {
    const auto samples = static_cast<std::size_t>(medium.samples);
    return medium.adaptive ? samples / 2 + 1 : samples;
}

glm::dvec3 left(const glm::dvec3& loss, double length) {
    if (loss.x == loss.y && loss.x == loss.z) return glm::dvec3(std::exp(-loss.x * length));
    return {std::exp(-loss.x * length), std::exp(-loss.y * length), std::exp(-loss.z * length)};
}

/// What it takes of light by unit of length, where its density is 1.
glm::dvec3 lossOf(const Medium& medium) {
    return rgb(medium.absorption) + medium.extinction * rgb(medium.scattering);
}

/// Sorts them, and makes one of those that overlap or touch.
void joinStretches(std::vector<BeamStretch>& stretches) {
    std::ranges::sort(stretches, {}, &BeamStretch::from);
    std::size_t kept = 0;
    for (const BeamStretch& stretch : stretches)
        if (kept > 0 && stretch.from <= stretches[kept - 1].to)
            stretches[kept - 1].to = std::max(stretches[kept - 1].to, stretch.to);
        else
            stretches[kept++] = stretch;
    stretches.resize(kept);
}

bool isEven(const Medium* medium) { return medium->layers() == 0; }

double difference(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
}

}  // namespace

MediaMarch::MediaMarch(const Scene& scene, Concerned concerned, std::shared_ptr<const LightFilters> filters)
    : scene_(scene), concerned_(concerned), filters_(std::move(filters)) {
    const auto counts = [](const LightSource& light) { return !light.shadowless && light.mediaInteraction; };
    const auto hasBeam = [](const LightSource& light) {
        return light.kind == LightKind::spotlight || light.kind == LightKind::cylinder;
    };
    if (!filters_) return;
    // A light that reaches everywhere leaves nothing to be divided.
    for (const LightSource& light : scene.lights)
        if (counts(light) && !hasBeam(light)) return;
    for (const LightSource& light : scene.lights)
        if (counts(light) && beams_.size() < mostBeams) beams_.push_back(&light);
}

std::vector<MediaMarch::Present> MediaMarch::mediaIn(const InteriorList& inside) const {
    std::vector<Present> media;
    const auto add = [&](const std::vector<std::shared_ptr<const Medium>>& more, int lightGroup) {
        for (const auto& medium : more) media.push_back({medium.get(), lightGroup});
    };
    if (concerned_.space) add(scene_.atmosphere, 0);
    for (const InteriorId id : inside.all()) {
        const Interior& interior = scene_.interiors[static_cast<std::size_t>(id)];
        if (!interior.hollow) return {};
        if (concerned_.objects) add(interior.media, interior.lightGroup);
    }
    return media;
}

void MediaMarch::find(TileScratch& work, Work& own) const {
    for (std::size_t first = 0; first < own.ways.size();) {
        const std::size_t end = begin(first, own);
        for (std::size_t sample = 0, part = 0; sample < own.samples_.size();) {
            if (work.context.stop.stop_requested()) return;
            findSamples(sample, work, own);
            sample = own.samples_.size();
            const std::size_t parts = own.parts_.size();
            halve(part, parts, own);
            part = parts;
        }
        join(own);
        addUp(first, end, own);
        first = end;
    }
}

/// Takes the first samples of some ways; returns where they end.
std::size_t MediaMarch::begin(std::size_t first, Work& own) const {
    own.samples_.clear();
    own.parts_.clear();
    own.wholeParts_.clear();
    std::size_t end = first, taken = 0;
    for (; end < own.ways.size() && taken < groupSamples; ++end) {
        Way& way = own.ways[end];
        way.distance = std::min(way.distance, horizon);
        const std::size_t before = own.parts_.size(), samples = own.samples_.size();
        const std::vector<Present> media = mediaIn(way.inside);
        if (!filters_ && std::ranges::all_of(media, isEven, &Present::medium)) {
            glm::dvec3 loss(0);
            for (const Present& present : media) loss += lossOf(*present.medium);
            way.through = left(loss, way.distance);
        } else if (!media.empty()) {
            takeIntervals(static_cast<std::uint32_t>(end), *media.front().medium, own);
        }
        own.wholeParts_.push_back(static_cast<std::uint32_t>(own.parts_.size() - before));
        taken += (own.samples_.size() - samples) * media.size();
    }
    return end;
}

/// Samples are taken in each stretch of the way in beams of light, and of what lies between. Those stretches
/// come on top of the intervals that the medium asks for; these divide what lies in beams, if anything does.
void MediaMarch::takeIntervals(std::uint32_t number, const Medium& rules, Work& own) const {
    const Way& way = own.ways[number];
    std::vector<BeamStretch>& lit = own.lit_;
    lit.clear();
    for (const LightSource* light : beams_) addBeamStretches(*light, way.ray, way.distance, lit);
    joinStretches(lit);
    std::size_t dark = 0;
    double end = 0;
    for (const BeamStretch& stretch : lit) {
        dark += stretch.from > end;
        end = stretch.to;
    }
    dark += way.distance > end;
    const std::size_t divided = lit.empty() ? 1 : lit.size();
    if (lit.empty()) dark = 0;
    const auto wanted = static_cast<std::size_t>(rules.intervals);
    const std::size_t each = std::max<std::size_t>(1, (wanted - std::min(wanted, dark)) / divided);
    const auto take = [&](double from, double to, std::size_t count) {
        const double length = (to - from) / static_cast<double>(count);
        if (length > 0)
            for (std::size_t i = 0; i < count; ++i)
                takeSamples(number, rules, from + static_cast<double>(i) * length, length, own);
    };
    if (lit.empty()) return take(0, way.distance, each);
    end = 0;
    for (const BeamStretch& stretch : lit) {
        take(end, stretch.from, 1);
        take(stretch.from, stretch.to, each);
        end = stretch.to;
    }
    take(end, way.distance, 1);
}

/// Of an interval of a way, as many as `rules` ask for.
void MediaMarch::takeSamples(std::uint32_t way, const Medium& rules, double start, double length,
                             Work& own) const {
    const std::size_t count = partsOf(rules);
    const double part = length / static_cast<double>(count);
    const auto take = [&](double t) {
        own.samples_.push_back({way, t});
        return static_cast<std::uint32_t>(own.samples_.size() - 1);
    };
    if (!rules.adaptive) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t middle = take(start + part * (static_cast<double>(k) + 0.5));
            own.parts_.push_back({middle, middle, middle, way, part, length});
        }
        return;
    }
    // The samples end one step before the interval does.
    const double step = length / static_cast<double>(count + 1);
    std::uint32_t last = take(start);
    for (std::size_t k = 0; k < count; ++k) {
        const double t = start + static_cast<double>(k) * step;
        const std::uint32_t middle = take(t + step / 2), next = take(t + step);
        own.parts_.push_back({last, middle, next, way, part, length});
        last = next;
    }
}

/// What the media do at the samples from `first` on.
void MediaMarch::findSamples(std::size_t first, TileScratch& work, Work& own) const {
    own.fillings_.clear();
    own.scattering_.clear();
    std::uint32_t way = Work::Part::none;
    std::vector<Present> media;
    std::size_t most = 0;
    for (std::size_t k = first; k < own.samples_.size(); ++k) {
        if (own.samples_[k].way != way) {
            way = own.samples_[k].way;
            media = mediaIn(own.ways[way].inside);
        }
        for (const auto& [medium, lightGroup] : media) {
            own.fillings_.push_back({medium, lightGroup, static_cast<std::uint32_t>(k)});
            most = std::max(most, medium->layers());
        }
    }
    for (std::size_t layer = 0; layer < most; ++layer) {
        for (std::size_t number = 0; number < own.fillings_.size(); ++number) {
            Work::Filling& filling = own.fillings_[number];
            if (layer >= filling.medium->layers()) continue;
            const Material& density = (*filling.medium->densities)[layer];
            const Work::Sample& sample = own.samples_[filling.sample];
            if (density.pigmentTape)
                own.lookup_.ask(density,
                                filling.medium->transform.inversePoint(own.ways[sample.way].ray.at(sample.t)),
                                number);
            else
                filling.density *= rgb(std::get<SolidPigment>(density.pigment).color);
        }
        work.context.evaluations += own.lookup_.answer(
            [&](std::size_t number, const Color& color) { own.fillings_[number].density *= rgb(color); });
    }
    for (std::size_t number = 0; number < own.fillings_.size(); ++number) {
        const auto& [medium, lightGroup, k, density] = own.fillings_[number];
        Work::Sample& sample = own.samples_[k];
        sample.loss += density * lossOf(*medium);
        if (!filters_) continue;
        sample.shine += density * rgb(medium->emission);
        if (medium->scatters() && density != glm::dvec3(0))
            own.scattering_.push_back(static_cast<std::uint32_t>(number));
    }
    if (!own.scattering_.empty()) scatter(work, own);
}

/// Adds to the samples what their media scatter of each light. Lights without shadows do not count, as in
/// POV-Ray.
void MediaMarch::scatter(TileScratch& work, Work& own) const {
    SurfacePoints& places = own.places_;
    const std::size_t count = own.scattering_.size();
    places.clear();
    places.makeRoom(count);
    places.samples.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Work::Sample& sample = own.samples_[own.fillings_[own.scattering_[k]].sample];
        const Way& way = own.ways[sample.way];
        const glm::dvec3 point = way.ray.at(sample.t);
        places.samples[k] = way.sample;
        for (int c = 0; c < 3; ++c) places.point[static_cast<std::size_t>(c)][k] = point[c];
    }
    for (std::size_t number = 0; number < scene_.lights.size(); ++number) {
        const LightSource& light = scene_.lights[number];
        if (light.shadowless || !light.mediaInteraction) continue;
        if (work.context.stop.stop_requested()) return;
        findArrival(light, places);
        takeLit(light, own);
        if (own.litFillings_.empty()) continue;
        filters_->filter(work, own.litPlaces_, number);
        for (std::size_t k = 0; k < own.litFillings_.size(); ++k)
            own.samples_[own.fillings_[own.litFillings_[k]].sample].shine += at(own.litPlaces_.returned, k);
    }
}

/// Of the places that scatter those that the light reaches, shadows aside, and how much of it they scatter:
/// as in POV-Ray, all that is there turns light as the media do on average.
void MediaMarch::takeLit(const LightSource& light, Work& own) const {
    const SurfacePoints& places = own.places_;
    SurfacePoints& lit = own.litPlaces_;
    std::vector<Present> media;
    std::uint32_t mediaOf = Work::Part::none;
    own.litFillings_.clear();
    lit.clear();
    lit.makeRoom(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const Work::Filling& filling = own.fillings_[own.scattering_[k]];
        if (places.strength[k] == 0 || !reaches(scene_, light, filling.lightGroup)) continue;
        const std::uint32_t way = own.samples_[filling.sample].way;
        if (way != mediaOf) media = mediaIn(own.ways[way].inside);
        mediaOf = way;
        const Ray& sight = own.ways[way].ray;
        const std::size_t to = own.litFillings_.size();
        own.litFillings_.push_back(own.scattering_[k]);
        lit.samples.push_back(places.samples[k]);
        lit.materials.push_back(noMaterial);
        lit.distance[to] = places.distance[k];
        lit.strength[to] = places.strength[k];
        const double turn = glm::dot(sight.direction, at(places.toLight, k));
        double phase = 0;
        for (const Present& present : media) phase += phaseFunction(*present.medium, turn);
        const glm::dvec3 scattered = filling.density * rgb(filling.medium->scattering) * rgb(light.color) *
                                     (places.strength[k] * phase / static_cast<double>(media.size()));
        for (int c = 0; c < 3; ++c) {
            const auto axis = static_cast<std::size_t>(c);
            lit.point[axis][to] = places.point[axis][k];
            lit.toLight[axis][to] = places.toLight[axis][k];
            lit.view[axis][to] = sight.direction[c];
            lit.normal[axis][to] = -sight.direction[c];
            lit.returned[axis][to] = scattered[c];
        }
    }
}

/// Parts whose samples differ get a half on that side.
void MediaMarch::halve(std::size_t first, std::size_t end, Work& own) const {
    const auto half = [&](Work::Part& part, std::uint32_t from, std::uint32_t to) {
        const Work::Sample before = own.samples_[from], behind = own.samples_[to];
        own.samples_.push_back({part.way, (before.t + behind.t) / 2});
        own.parts_.push_back({from, static_cast<std::uint32_t>(own.samples_.size() - 1), to, part.way,
                              part.length / 2, part.interval, part.depth + 1});
        return static_cast<std::uint32_t>(own.parts_.size() - 1);
    };
    std::uint32_t way = Work::Part::none;
    const Medium* rules = nullptr;
    for (std::size_t k = first; k < end; ++k) {
        Work::Part part = own.parts_[k];
        if (part.way != way) {
            way = part.way;
            rules = mediaIn(own.ways[way].inside).front().medium;
        }
        if (!rules->adaptive || part.depth >= rules->refinements) continue;
        const auto differ = [&](std::uint32_t a, std::uint32_t b) {
            return difference(own.samples_[a].shine, own.samples_[b].shine) * part.interval >=
                   rules->threshold;
        };
        if (differ(part.first, part.middle)) part.firstHalf = half(part, part.first, part.middle);
        if (differ(part.middle, part.last)) part.lastHalf = half(part, part.middle, part.last);
        own.parts_[k] = part;
    }
}

/// The means of all parts; halves stand behind what they are halves of.
void MediaMarch::join(Work& own) {
    for (std::size_t k = own.parts_.size(); k-- > 0;) {
        Work::Part& part = own.parts_[k];
        const auto mean = [&](glm::dvec3 Work::Sample::*sampled, glm::dvec3 Work::Part::*joined) {
            const glm::dvec3 &first = own.samples_[part.first].*sampled,
                             &middle = own.samples_[part.middle].*sampled,
                             &last = own.samples_[part.last].*sampled;
            if (part.firstHalf == Work::Part::none && part.lastHalf == Work::Part::none)
                return (first + middle + last) / 3.0;
            const auto of = [&](std::uint32_t half, const glm::dvec3& a, const glm::dvec3& b) {
                return half == Work::Part::none ? (a + b) / 2.0 : own.parts_[half].*joined;
            };
            return (of(part.firstHalf, first, middle) + of(part.lastHalf, middle, last)) / 2.0;
        };
        part.shine = mean(&Work::Sample::shine, &Work::Part::shine);
        part.loss = mean(&Work::Sample::loss, &Work::Part::loss);
    }
}

/// The light of the ways [first, end) from their parts: that of each is dimmed by the parts before it, and
/// but for POV-Ray's method 3 by half of its own.
void MediaMarch::addUp(std::size_t first, std::size_t end, Work& own) const {
    std::size_t part = 0;
    for (std::size_t k = first; k < end; ++k) {
        Way& way = own.ways[k];
        const std::uint32_t count = own.wholeParts_[k - first];
        if (count == 0) continue;
        const bool adaptive = mediaIn(way.inside).front().medium->adaptive;
        for (const std::size_t last = part + count; part < last; ++part) {
            const glm::dvec3 &shine = own.parts_[part].shine, &loss = own.parts_[part].loss;
            const double length = own.parts_[part].length;
            const glm::dvec3 dimmed = adaptive ? way.through : way.through * left(loss, length / 2);
            way.light += dimmed * shine * length;
            way.through *= left(loss, length);
        }
    }
}

}  // namespace isoscope

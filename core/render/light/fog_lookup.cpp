// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/light/fog_lookup.h"

#include <array>

#include "core/function/patterns/pattern_call.h"
#include "core/render/light/fog_depth.h"

namespace isoscope {

namespace {

std::shared_ptr<const Tape> turbulenceTape(const Fog& fog, int generator) {
    Pattern pattern;
    pattern.octaves = fog.octaves;
    pattern.lambda = fog.lambda;
    pattern.omega = fog.omega;
    FunctionGraph graph;
    const std::array<Expression, 3> place{Expression(graph, graph.variable(0)),
                                          Expression(graph, graph.variable(1)),
                                          Expression(graph, graph.variable(2))};
    const Expression value = turbulence({pattern, place[0], place[1], place[2], generator});
    const Function function = finish(std::move(graph), {value.node()}, 3);
    return function.valid() ? Tape::compile(function) : nullptr;
}

}  // namespace

FogLookup::FogLookup(const Scene& scene) : scene_(scene), turbulences_(scene.fogs.size()) {
    for (std::size_t k = 0; k < turbulences_.size(); ++k)
        if (scene.fogs[k].turbulence != glm::dvec3(0))
            turbulences_[k] = turbulenceTape(scene.fogs[k], scene.settings.noiseGenerator);
}

std::size_t FogLookup::findTurbulence(Work& work) const {
    const std::size_t ways = work.ways_.size();
    work.turbulence_.assign(turbulences_.size() * ways, 0);
    for (std::size_t fog = 0; fog < turbulences_.size(); ++fog) {
        if (!turbulences_[fog]) continue;
        for (std::size_t way = 0; way < ways; ++way) {
            const glm::dvec3 place =
                turbulencePlace(scene_.fogs[fog], work.ways_[way].ray, work.ways_[way].distance);
            work.lookup_.ask(turbulences_[fog], std::array{place.x, place.y, place.z}, fog * ways + way);
        }
    }
    return work.lookup_.answer(
        [&](std::size_t number, std::span<const double> value) { work.turbulence_[number] = value[0]; });
}

double FogLookup::left(std::size_t fog, std::size_t way, const Work& work) const {
    const auto& [ray, distance] = work.ways_[way];
    return leftByFog(scene_.fogs[fog], ray, distance, work.turbulence_[fog * work.ways_.size() + way]);
}

}  // namespace isoscope

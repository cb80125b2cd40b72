// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/range/scene_ranges.h"

#include <algorithm>
#include <cmath>

#include "core/function/graph_copy.h"

namespace isoscope {

namespace {

/// Whole numbers beyond are not looked at one by one.
constexpr double mostValues = 200;

bool standsIn(const SourceRange& statement, const SourceRange& range) {
    return range.file == statement.file && statement.begin <= range.begin && range.end <= statement.end;
}

}  // namespace

std::vector<RangeSubject> rangeSubjects(const Scene& scene) {
    std::vector<RangeSubject> subjects;
    for (std::size_t i = 0; i < scene.isosurfaces.size(); ++i) {
        const SceneIsosurface& isosurface = scene.isosurfaces[i];
        if (!isosurface.shape) continue;
        const std::vector<int> slots = parameterSlots(isosurface.shape->settings().function);
        for (std::size_t k = 0; k < scene.parameters.size(); ++k) {
            const SceneParameter& parameter = scene.parameters[k];
            if (parameter.expression) continue;
            const bool isThreshold =
                parameter.role == ParameterRole::threshold && standsIn(isosurface.range, parameter.range);
            const bool isArgument = parameter.slot >= 0 && std::ranges::binary_search(slots, parameter.slot);
            if (isThreshold || isArgument)
                subjects.push_back({i, k, isThreshold ? RangeStudy::threshold : parameter.slot});
        }
    }
    return subjects;
}

ParameterRange rangeOf(const Scene& scene, const RangeSubject& subject, double low, double high,
                       const RangeSettings& settings, std::stop_token stop) {
    RangeStudy study(scene.isosurfaces[subject.isosurface].shape, *scene.parameterTable, subject.slot,
                     settings);
    if (!scene.parameters[subject.parameter].integral || !(high - low <= mostValues))
        return study.run(low, high, stop);
    std::vector<double> values;
    for (double value = std::ceil(low); value <= high; ++value) values.push_back(value);
    return study.run(values, stop);
}

ParameterRange rangeOf(const Scene& scene, const RangeSubject& subject, const RangeSettings& settings,
                       std::stop_token stop) {
    const SceneParameter& parameter = scene.parameters[subject.parameter];
    return rangeOf(scene, subject, parameter.minimum, parameter.maximum, settings, stop);
}

}  // namespace isoscope

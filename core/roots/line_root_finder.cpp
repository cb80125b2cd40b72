// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/line_root_finder.h"

#include <algorithm>

namespace isoscope {

void LineRootFinder::findFirst(const LineColumns& lines, const RootRequest& request, FirstRoots& roots) {
    roots.clear(lines.count);
    queries_.resize(lines.count);
    for (std::size_t line = 0; line < lines.count; ++line) queries_[line] = lines[line];
    if (lists_.size() < lines.count) lists_.resize(lines.count);
    find(queries_, request, std::span(lists_).first(lines.count));
    if (request.stop.stop_requested()) return;
    for (std::size_t line = 0; line < lines.count; ++line) {
        const RootList& list = lists_[line];
        const auto first = std::find_if(list.begin(), list.end(),
                                        [&](const Root& root) { return root.t >= request.sufficient; });
        if (first != list.end()) roots.others.push_back({line, *first});
    }
    setNormals(lines, request.stop, roots);
}

void LineRootFinder::setNormals(const LineColumns& lines, const std::stop_token& stop, FirstRoots& roots) {
    const auto isAsked = [](const FirstRoots::Other& other) {
        return other.root.kind != RootKind::entryWall && other.root.kind != RootKind::exitWall &&
               other.root.kind != RootKind::jump && !other.hasNormal;
    };
    places_.clear();
    for (const FirstRoots::Other& other : roots.others) {
        const LineQuery line = lines[other.line];
        if (isAsked(other)) places_.push_back(line.origin + other.root.t * line.direction);
    }
    normals_.assign(places_.size(), FirstRoots::Other().normal);
    computeNormals(places_, stop, normals_);
    std::size_t next = 0;
    for (FirstRoots::Other& other : roots.others)
        if (isAsked(other)) other.normal = normals_[next++];
}

void LineRootFinder::computeNormals(std::span<const glm::dvec3> points, const std::stop_token& stop,
                                    std::span<glm::dvec3> out) {
    constexpr std::size_t few = 64;
    for (std::size_t first = 0; first < points.size() && !stop.stop_requested(); first += few) {
        const std::size_t count = std::min(few, points.size() - first);
        normals(points.subspan(first, count), out.subspan(first, count));
    }
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/mesh_checker.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace isoscope::test {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::string number(std::size_t value) { return std::to_string(value); }

/// Follows the triangles around a point from one to the next: `next` leads from the first to the second point
/// across from it.
bool isOneFan(const std::map<std::uint32_t, std::uint32_t>& next, bool border) {
    // A border fan begins at the point that nothing leads to.
    std::uint32_t begin = next.begin()->first;
    if (border) {
        std::set<std::uint32_t> reached;
        for (const auto& [from, to] : next) reached.insert(to);
        std::size_t begins = 0;
        for (const auto& [from, to] : next)
            if (reached.count(from) == 0) {
                begin = from;
                ++begins;
            }
        if (begins > 1) return false;
    }
    std::size_t steps = 0;
    std::uint32_t at = begin;
    do {
        const auto step = next.find(at);
        if (step == next.end()) break;
        at = step->second;
        ++steps;
    } while (at != begin && steps <= next.size());
    return steps == next.size();
}

}  // namespace

CheckedMesh checkMesh(const TriangleMesh& mesh, bool borders) {
    CheckedMesh result;
    std::map<Edge, int> directed;
    std::vector<std::map<std::uint32_t, std::uint32_t>> around(mesh.points.size());
    const auto fail = [&](const std::string& fault) {
        if (result.fault.empty()) result.fault = fault;
    };
    if (mesh.cornerNormals.size() != mesh.triangles.size()) fail("normals are missing");
    for (const glm::dvec3& p : mesh.points)
        if (!std::isfinite(p.x + p.y + p.z)) fail("a point is not finite");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& triangle = mesh.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3], c = triangle[(k + 2) % 3];
            if (a >= mesh.points.size()) return fail("no such point: " + number(a)), result;
            if (a == b) fail("triangle " + number(t) + " has a point twice");
            if (++directed[{a, b}] > 1) fail("edge " + number(a) + " " + number(b) + " is passed twice");
            if (!around[a].emplace(b, c).second) fail("two triangles at point " + number(a));
            if (t < mesh.cornerNormals.size()) {
                const std::uint32_t n = mesh.cornerNormals[t][k];
                if (n >= mesh.normals.size() || std::abs(glm::length(mesh.normals[n]) - 1) > 1e-5)
                    fail("triangle " + number(t) + " has a normal that is none");
            }
        }
    }
    std::vector<char> atBorder(mesh.points.size(), 0);
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
    for (const auto& [edge, times] : directed) {
        const bool alone = directed.count({edge.second, edge.first}) == 0;
        if (alone) {
            ++result.borderEdges;
            atBorder[edge.first] = atBorder[edge.second] = 1;
            if (!borders) fail("edge " + number(edge.first) + " " + number(edge.second) + " is open");
        }
        if (alone || edge.first < edge.second) ++result.edges;
        neighbours[edge.first].insert(edge.second);
        neighbours[edge.second].insert(edge.first);
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (around[p].empty()) {
            fail("point " + number(p) + " is in no triangle");
            continue;
        }
        ++result.points;
        if (!isOneFan(around[p], atBorder[p] != 0)) fail("point " + number(p) + " has several fans");
    }
    std::set<std::uint32_t> seen;
    for (const auto& [point, next] : neighbours) {
        if (!seen.insert(point).second) continue;
        ++result.pieces;
        std::vector<std::uint32_t> open{point};
        while (!open.empty()) {
            const std::uint32_t at = open.back();
            open.pop_back();
            for (const std::uint32_t other : neighbours[at])
                if (seen.insert(other).second) open.push_back(other);
        }
    }
    result.triangles = mesh.triangles.size();
    return result;
}

double enclosedVolume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += glm::dot(mesh.points[t[0]], glm::cross(mesh.points[t[1]], mesh.points[t[2]]));
    return sum / 6;
}

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <vector>

#include "core/function/builtins/builtin.h"
#include "core/function/graph_builder.h"
#include "core/roots/line_query.h"
#include "tests/support/tape_of.h"

namespace isoscope::test {

/// Functions that are plain, and functions that are not.
struct NamedTape {
    const char* name;
    std::shared_ptr<const Tape> tape;
};

inline std::vector<NamedTape> sampleTapes() {
    return {
        {"sphere", tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1; })},
        {"gyroid", tapeOf([](auto x, auto y, auto z) {
             return sin(x * 4) * cos(y * 4) + sin(y * 4) * cos(z * 4) + sin(z * 4) * cos(x * 4);
         })},
        {"noise", tapeOf([](auto x, auto y, auto z) {
             return sq(x) + sq(y) + sq(z) - 1 + 0.3 * noise(x.number(2), x * 3, y * 3, z * 3);
         })},
        {"landscape", tapeOf([](auto x, auto y, auto z) {
             const Expression zero = x.number(0), half = x.number(0.5), most = x.number(0.7);
             const std::vector<Expression> arguments{x,           zero, z,    half,       x.number(2.2),
                                                     x.number(7), most, most, x.number(2)};
             return y - buildBuiltin(*findBuiltin("f_ridged_mf"), arguments, 2) * 0.35;
         })},
        {"pole", tapeOf([](auto x, auto y, auto) { return y - 0.2 / x; })},
        {"edge of the domain", tapeOf([](auto x, auto y, auto) { return sqrt(x) - sq(y) - 0.5; })},
        {"steps", tapeOf([](auto x, auto y, auto z) { return floor(x * 3) / 3 + sq(y) + sq(z) - 0.4; })},
        {"even contact", tapeOf([](auto x, auto y, auto z) { return sq(sq(x) + sq(y) + sq(z) - 1); })},
        {"thin sheet", tapeOf([](auto x, auto, auto) { return abs(x) - 1e-5; })},
        {"union", tapeOf([](auto x, auto y, auto z) {
             return min(sq(x - 0.5) + sq(y) + sq(z), sq(x + 0.4) + sq(y - 0.2) + sq(z)) - 0.2;
         })},
        {"union of many", tapeOf([](auto x, auto y, auto z) {
             Expression result = x.number(10);
             for (int k = 0; k < 20; ++k)
                 result = min(result, sq(x - 0.9 * std::cos(k)) + sq(y - 0.9 * std::sin(k)) + sq(z) - 0.04);
             return result;
         })},
        {"ball with many holes", tapeOf([](auto x, auto y, auto z) {
             Expression holes = x.number(10);
             for (int k = 0; k < 20; ++k)
                 holes = min(holes, sq(x - 0.9 * std::cos(k)) + sq(y - 0.9 * std::sin(k)) + sq(z) - 0.04);
             return max(sq(x) + sq(y) + sq(z) - 0.8, -holes);
         })},
        {"many blended folds", tapeOf([](auto x, auto y, auto z) {
             Expression result = x;
             for (int k = 0; k < 10; ++k)
                 result = max(result, y * std::cos(k) + z * std::sin(k)) - 0.02 * sq(result);
             return result - 0.5;
         })},
    };
}

/// 16 x 16 rays of neighbouring pixels, 4 x 4 at a time, from a random place outside the cube of side 2.
inline std::vector<LineQuery> neighbourLines(std::mt19937_64& random, double width) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    const glm::dvec3 eye =
        4.0 * glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
    const glm::dvec3 target = 0.3 * glm::dvec3(anywhere(random), anywhere(random), anywhere(random));
    const glm::dvec3 ahead = glm::normalize(target - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.1, 1, 0.2)));
    const glm::dvec3 up = glm::cross(right, ahead);
    std::vector<LineQuery> result;
    for (int k = 0; k < 256; ++k) {
        const double u = (k / 16 % 4) * 4 + k % 4 - 7.5, v = (k / 64) * 4 + k / 4 % 4 - 7.5;
        result.push_back({eye, ahead + width / 16 * (u * right + v * up), 2.4, 5.6});
    }
    return result;
}

/// As at the edge of a container: what is certain where most lines begin may lie before others.
inline void beginAnywhere(std::mt19937_64& random, std::vector<LineQuery>& lines) {
    std::uniform_real_distribution<double> depth(2.4, 4.5);
    for (LineQuery& line : lines) line.near = depth(random);
}

}  // namespace isoscope::test

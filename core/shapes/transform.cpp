// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/transform.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace isoscope {

namespace {

bool allFinite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

/// The rotation that carries axis `from` towards axis `to`.
glm::dmat4 turn(int from, int to, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    glm::dmat4 matrix(1);
    matrix[from][from] = std::cos(angle);
    matrix[from][to] = std::sin(angle);
    matrix[to][from] = -std::sin(angle);
    matrix[to][to] = std::cos(angle);
    return matrix;
}

}  // namespace

Transform Transform::translation(const glm::dvec3& by) {
    Transform result;
    result.forward_[3] = glm::dvec4(by, 1);
    result.backward_[3] = glm::dvec4(-by, 1);
    return result;
}

Transform Transform::scaling(const glm::dvec3& factors) {
    Transform result;
    for (int axis = 0; axis < 3; ++axis) {
        const double factor = factors[axis] == 0 ? 1 : factors[axis];
        result.forward_[axis][axis] = factor;
        result.backward_[axis][axis] = 1 / factor;
    }
    return result;
}

Transform Transform::rotation(const glm::dvec3& degrees) {
    Transform result;
    result.forward_ = turn(0, 1, degrees.z) * turn(2, 0, degrees.y) * turn(1, 2, degrees.x);
    result.backward_ = glm::transpose(result.forward_);
    return result;
}

Transform Transform::axisRotation(const glm::dvec3& axis, double degrees) {
    const double length = glm::length(axis);
    if (!(length > 0) || !std::isfinite(length)) return {};
    const glm::dvec3 unit = axis / length;
    const double angle = degrees * std::numbers::pi / 180;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const auto turned = [&](const glm::dvec3& p) {
        return p * cosine + glm::cross(unit, p) * sine + unit * (glm::dot(unit, p) * (1 - cosine));
    };
    Transform result;
    result.forward_[0] = glm::dvec4(turned({1, 0, 0}), 0);
    result.forward_[1] = glm::dvec4(turned({0, 1, 0}), 0);
    result.forward_[2] = glm::dvec4(turned({0, 0, 1}), 0);
    result.backward_ = glm::transpose(result.forward_);
    return result;
}

Transform Transform::matrix(const glm::dmat4& matrix) {
    Transform result;
    const glm::dmat4 inverse = glm::inverse(matrix);
    if (!allFinite(matrix) || glm::determinant(matrix) == 0 || !allFinite(inverse)) {
        result.singular_ = true;
        return result;
    }
    result.forward_ = matrix;
    result.backward_ = inverse;
    return result;
}

Transform Transform::then(const Transform& next) const {
    Transform result;
    result.forward_ = next.forward_ * forward_;
    result.backward_ = backward_ * next.backward_;
    result.singular_ = singular_ || next.singular_;
    return result;
}

Transform Transform::inverse() const {
    Transform result;
    result.forward_ = backward_;
    result.backward_ = forward_;
    result.singular_ = singular_;
    return result;
}

bool Transform::identity() const { return forward_ == glm::dmat4(1); }

}  // namespace isoscope

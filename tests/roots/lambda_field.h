// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "core/roots/lipschitz/field_function.h"

namespace isoscope::test {

using PointFunction = std::function<double(const glm::dvec3&)>;

/// A field written as a C++ function, which counts its calls.
class LambdaField : public FieldFunction {
  public:
    explicit LambdaField(PointFunction function) : function_(std::move(function)) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = function_({x[i], y[i], z[i]});
        points += out.size();
        ++calls;
    }

    std::uint64_t points = 0;
    std::uint64_t calls = 0;

  private:
    PointFunction function_;
};

}  // namespace isoscope::test

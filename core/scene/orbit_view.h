// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "core/scene/camera.h"

namespace isoscope {

/// What moving the view can change of a camera.
std::array<glm::dvec3*, 7> movableVectors(Camera& camera);

/// The view as the mouse moves it, starting from a scene's camera: turning about the point looked at,
/// shifting, coming nearer, and back. Knows no toolkit; all movements are given as they look on the screen.
/// Non-finite amounts change nothing.
class OrbitView {
  public:
    explicit OrbitView(const Camera& home = {}) { setHome(home); }

    /// The camera to return to; the view becomes this camera.
    void setHome(const Camera& home);
    const Camera& home() const { return home_; }

    /// Where the view is, to be returned to; the home stays what it is.
    struct State {
        Camera camera;
        glm::dvec3 pivot{0};

        friend bool operator==(const State&, const State&) = default;
    };
    /// setState() brings camera and pivot back exactly; the numbers are not checked.
    State state() const { return {camera_, pivot_}; }
    void setState(const State& state) {
        camera_ = state.camera;
        pivot_ = state.pivot;
    }

    /// The camera to draw with, whether it differs from the home, and the way back to it.
    const Camera& camera() const { return camera_; }
    bool moved() const { return !(camera_ == home_); }
    void reset() { setHome(home_); }
    /// The view becomes this camera, from the same home.
    void show(const Camera& camera);

    /// The point that stays in place while turning: look_at, brought onto the axis of the view.
    const glm::dvec3& pivot() const { return pivot_; }

    /// Turns by degrees: what is in front moves to the right (about the sky) and up. The view never tips
    /// over: it stays a degree away from the sky's axis.
    void orbit(double degreesRight, double degreesUp);
    /// Shifts the picture, at the distance of the pivot, by these parts of its width and height to the right
    /// and up.
    void pan(double widths, double heights);
    /// Magnifies what is around the pivot by `factor` (above 1: nearer), within bounds that keep all numbers
    /// usable.
    void zoom(double factor);

  private:
    double distance() const;
    void turn(const glm::dvec3& axis, double degrees);

    Camera home_;
    Camera camera_;
    glm::dvec3 pivot_{0};
};

}  // namespace isoscope

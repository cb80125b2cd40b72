// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace isoscope {

/// An OpenGL context without window or display (EGL "surfaceless" platform), in which all VTK panels draw. It
/// keeps OpenGL out of Qt, so that the window runs, and is tested, on machines without a display server. To
/// be used in one thread only.
class EglContext {
  public:
    /// The context of the process; made at the first call and destroyed with its last owner. Never null, but
    /// valid() only where EGL works.
    static std::shared_ptr<EglContext> shared();

    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    /// Whether there is a context; false stays false.
    bool valid() const { return context_ != nullptr; }
    /// What failed, in words for the user; empty when valid.
    const std::string& problem() const { return problem_; }

    /// Makes it the current context of this thread, without a surface; false when that fails or there is
    /// none.
    bool makeCurrent();
    bool isCurrent() const;

  private:
    EglContext();

    // EGLDisplay and EGLContext; EGL's headers stay out of this one because they may pull in X11's macros.
    void* display_ = nullptr;
    void* context_ = nullptr;
    std::string problem_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "core/shapes/solids/sphere.h"

namespace isoscope::test {

/// A unit sphere that counts how often it is asked, and can make those who ask wait: tests then need no
/// clock.
class GatedShape : public Shape {
  public:
    void intersect(const Ray& ray, RayInterval interval, TraceContext& context,
                   HitList& hits) const override {
        sphere_.intersect(ray, interval, context, hits);
    }
    void nearest(std::span<const Ray> rays, TraceContext& context,
                 std::span<NearestHit> nearest) const override {
        if (context.shadowRay) ++shadowCalls;
        {
            std::unique_lock lock(mutex_);
            ++calls;
            changed_.notify_all();
            changed_.wait(lock, [this] { return calls <= allowed_ || allowed_ < 0; });
        }
        sphere_.nearest(rays, context, nearest);
    }
    bool contains(const glm::dvec3& point, TraceContext& context) const override {
        return sphere_.contains(point, context);
    }
    Bounds bounds() const override { return {}; }  // so that every batch asks

    /// From now on the first `count` calls pass, the others wait; negative lets all pass.
    void allow(int count) {
        const std::lock_guard lock(mutex_);
        allowed_ = count;
        changed_.notify_all();
    }
    /// Returns when `count` calls have been made (those that wait included).
    void waitForCalls(int count) const {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return calls >= count; });
    }

    mutable std::atomic<int> calls{0};
    mutable std::atomic<int> shadowCalls{0};

  private:
    Sphere sphere_{glm::dvec3(0), 1.0};
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    int allowed_ = -1;
};

}  // namespace isoscope::test

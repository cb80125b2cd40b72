// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/roots/line_query.h"
#include "core/roots/root_settings.h"
#include "tests/roots/lambda_field.h"

namespace isoscope::test {

/// docs/povray/solver.md written down sentence by sentence, with real recursion and no thought of speed: what
/// the machine in core/roots is held against.
class PlainLipschitz {
  public:
    /// `bound` is M; it moves with `evaluate`.
    PlainLipschitz(const PointFunction& f, const LineQuery& query, const RootSettings& settings,
                   double& bound)
        : f_(f), query_(query), settings_(settings), bound_(bound) {}

    RootList roots() {
        if (!(query_.near <= query_.far)) return {};
        const double A = settings_.accuracy;
        double t1 = query_.near;
        const double t2 = query_.far;
        RootList result;
        int count = 0;

        // The ends of the interval, 1.
        const double atStart = g(t1);
        if (!settings_.open) {
            if (t1 > A) {
                if (atStart < 0) {
                    result.push_back({t1, RootKind::entryWall});
                    ++count;
                    s_ = -1;
                }
            } else {
                if (atStart < 4 * bound_ * A) {
                    t1 = 5 * A;
                    if (g(t1) < 0) s_ = -1;
                }
                if (g(t2) < 0) result.push_back({t2, RootKind::exitWall});
            }
        }
        // 2. (the interval as it was given counts, too)
        if (!(query_.far - query_.near >= A) || !(t2 - t1 >= A)) return {};
        // 3.
        if (t1 < A && s_ == 1 && std::abs(g(t1)) < 4 * bound_ * A) {
            t1 = 5 * A;
            if (g(t1) < 0) s_ = -1;
            if (!(t2 - t1 >= A)) return {};
        }
        // The search.
        while (count < settings_.maxTrace) {
            // 4.
            if (settings_.open && s_ * g(t1) < 0) s_ = -s_;
            if (settings_.evaluate && bound_ > (*settings_.evaluate)[0]) bound_ *= (*settings_.evaluate)[2];
            const double speed = glm::length(query_.direction);
            const std::optional<double> hit =
                find(t1, s_ * g(t1), t2, s_ * g(t2), bound_ * speed * (t2 - t1));
            if (!hit) break;
            result.push_back({*hit, RootKind::crossing});
            ++count;
            t1 = *hit + 5 * A;
            s_ = -s_;
            if (!(t2 - t1 >= A)) break;
        }
        std::stable_sort(result.begin(), result.end(), [](Root a, Root b) { return a.t < b.t; });
        return result;
    }

  private:
    double g(double t) const { return settings_.signedValue(f_(query_.origin + t * query_.direction)); }

    std::optional<double> find(double t1, double h1, double t2, double h2, double L) {
        // The second half comes in the next round: called, the halves behind a pole filled the stack.
        for (;;) {
            const double w = t2 - t1;
            const double speed = glm::length(query_.direction);
            const double slope = std::abs(h2 - h1) / (w * speed);
            if (settings_.evaluate && std::isfinite(slope)) {
                const double P1 = (*settings_.evaluate)[1];
                if (slope * P1 > bound_) {
                    bound_ = slope * P1 * P1;
                    L = bound_ * speed * w;
                }
            }
            if (w < settings_.accuracy) return h2 < 0 ? std::optional(t2) : std::nullopt;
            if (std::isnan(h1 + h2 - L) || h1 + h2 - L >= 0) return std::nullopt;
            const double m = (t1 + t2) / 2;
            const double hm = s_ * g(m);
            L /= 2;
            if (const auto hit = find(t1, h1, m, hm, L)) return hit;
            t1 = m;
            h1 = hm;
        }
    }

    const PointFunction& f_;
    LineQuery query_;
    RootSettings settings_;
    double& bound_;
    double s_ = 1;
};

}  // namespace isoscope::test

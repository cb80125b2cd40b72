// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/shape/shape_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <queue>

#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/evaluate/tape/tape_simplifier.h"
#include "core/roots/cells/short_tapes.h"
#include "core/study/gradient/gradient_domain.h"

namespace isoscope {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Rounding of sums of a few hundred thousand volumes, relative.
constexpr double sumError = 1e-9;

double volumeOf(const GradientBox& box) {
    const glm::dvec3 size = box.high - box.low;
    return size.x * size.y * size.z;
}

struct Room {
    GradientBox box;
    double volume = 0;
    std::shared_ptr<const SimplifiedTape> tape;  ///< with the sign of the function there; null for the whole

    /// The largest first.
    bool operator<(const Room& other) const { return volume < other.volume; }
};

/// Sorts boxes into what is inside and what is open.
class VolumeSearch {
  public:
    VolumeSearch(const Isosurface& surface, std::span<const double> parameters)
        : surface_(surface),
          domain_(surface.settings().container),
          function_(surface.prepared(parameters)),
          boxes_(function_),
          simplifier_(function_->links()),
          levels_(function_->links().levels(function_->uniforms(), surface.settings().threshold)),
          becomesShort_(ShortTapes(*function_).possible()) {}

    bool empty() const { return domain_.empty(); }
    void run(std::uint64_t limit, const std::stop_token& stop) {
        open_ = volumeOf(domain_.box());
        queue_.push({domain_.box(), open_, {}});
        std::vector<Room> parts;
        while (!queue_.empty() && boxes_.evaluations() < limit && !stop.stop_requested()) {
            parts.clear();
            do {
                divide(parts);
            } while (!queue_.empty() && parts.size() + 8 <= batchLanes && haveSameTape(parts, queue_.top()));
            sort(parts, stop);
        }
    }
    VolumeBracket bracket() const {
        double whole = volumeOf(domain_.box());
        if (domain_.isBall()) whole = 4.0 / 3 * M_PI * std::pow(domain_.radius(), 3);
        return {inside_ * (1 - sumError), std::min(whole, inside_ + std::max(0.0, open_)) * (1 + sumError),
                boxes_.evaluations()};
    }

  private:
    static bool haveSameTape(const std::vector<Room>& rooms, const Room& other) {
        return rooms.empty() || rooms.front().tape == other.tape;
    }
    void divide(std::vector<Room>& parts) {
        const Room room = queue_.top();
        const GradientBox& whole = room.box;
        queue_.pop();
        const glm::dvec3 middle = whole.center();
        for (int corner = 0; corner < 8; ++corner) {
            GradientBox part = whole;
            for (int k = 0; k < 3; ++k) (corner >> k & 1 ? part.low : part.high)[k] = middle[k];
            const double volume = volumeOf(part);
            if (domain_.misses(part))
                open_ -= volume;
            else
                parts.push_back({part, volume, room.tape});
        }
    }
    /// Rooms with the same tape.
    void sort(std::span<const Room> rooms, const std::stop_token& stop) {
        if (rooms.empty()) return;
        BoxLanes lanes{};
        for (std::size_t i = 0; i < rooms.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                lanes.low[k][i] = rooms[i].box.low[static_cast<int>(k)];
                lanes.high[k][i] = rooms[i].box.high[static_cast<int>(k)];
            }
        std::array<Interval, batchLanes> values;
        evaluate(lanes, rooms[0].tape.get(), std::span(values).first(rooms.size()));
        // What loops said that were stopped does not count.
        if (stop.stop_requested()) return;
        const double threshold = surface_.settings().threshold;
        const bool positive = surface_.settings().positivePolarity;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            // Where there is no value there is no solid.
            const bool below = values[i].high<threshold, above = values[i].low> threshold;
            const bool isIn = (positive ? above : below) && !values[i].empty() && !values[i].maybeUndefined;
            const bool isOut = (positive ? below : above) || values[i].empty();
            const bool whole = domain_.encloses(rooms[i].box);
            if (isOut || (isIn && whole)) open_ -= rooms[i].volume;
            if (isIn && whole) inside_ += rooms[i].volume;
            if (!isOut && !(isIn && whole))
                queue_.push({rooms[i].box, rooms[i].volume, shortened(rooms[i].tape, i)});
        }
    }
    /// By a tape, or the whole one.
    void evaluate(const BoxLanes& lanes, const SimplifiedTape* tape, std::span<Interval> values) {
        if (!becomesShort_) return boxes_.evaluate(lanes, values);
        simplifier_.setBase(tape);
        boxes_.evaluateChoices(lanes, tape != nullptr ? *tape : function_->links().whole(),
                               {levels_, simplifier_.levelNumbers()}, values, choices_);
    }
    /// The tape for what is within the room in a lane that was enclosed last: that one, or a much shorter
    /// one.
    std::shared_ptr<const SimplifiedTape> shortened(const std::shared_ptr<const SimplifiedTape>& tape,
                                                    std::size_t lane) {
        constexpr std::size_t worthwhileShare = 2;
        const std::size_t length = (tape ? *tape : function_->links().whole()).instructions.size();
        if (!becomesShort_ || length <= ShortTapes::shortLength) return tape;
        simplifier_.simplify(choices_, std::uint64_t(1) << lane, 0, made_);
        if (worthwhileShare * made_.instructions.size() > length) return tape;
        return std::make_shared<const SimplifiedTape>(made_);
    }

    const Isosurface& surface_;
    GradientDomain domain_;
    std::shared_ptr<const PreparedFunction> function_;
    BoxEvaluator boxes_;
    TapeSimplifier simplifier_;
    std::vector<SignLevel> levels_;
    std::vector<LaneChoices> choices_;  ///< of the rooms at hand
    SimplifiedTape made_;
    bool becomesShort_;  ///< whether the tape may do so in a room
    std::priority_queue<Room> queue_;
    double inside_ = 0, open_ = 0;
};

/// Of the triangle or two through a tetrahedron.
double cutArea(const std::array<glm::dvec3, 4>& corners, const std::array<double, 4>& values) {
    std::array<int, 4> in{}, out{};
    int inside = 0, outside = 0;
    for (int i = 0; i < 4; ++i) {
        if (!std::isfinite(values[static_cast<std::size_t>(i)])) return 0;
        if (values[static_cast<std::size_t>(i)] < 0)
            in[static_cast<std::size_t>(inside++)] = i;
        else
            out[static_cast<std::size_t>(outside++)] = i;
    }
    if (inside == 0 || outside == 0) return 0;
    const auto cut = [&](int a, int b) {
        const double u = values[static_cast<std::size_t>(a)], v = values[static_cast<std::size_t>(b)];
        return glm::mix(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)],
                        u / (u - v));
    };
    const auto triangle = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        return 0.5 * glm::length(glm::cross(b - a, c - a));
    };
    if (inside == 1) return triangle(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]));
    if (outside == 1) return triangle(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]));
    const glm::dvec3 a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                     d = cut(in[1], out[0]);
    return triangle(a, b, c) + triangle(a, c, d);
}

}  // namespace

VolumeBracket volumeOf(const Isosurface& surface, std::span<const double> parameters, std::uint64_t boxLimit,
                       std::stop_token stop) {
    const LoopStop loops(stop);
    VolumeSearch search(surface, parameters);
    if (search.empty()) return {0, infinity, 0};
    search.run(boxLimit, stop);
    return search.bracket();
}

double areaOf(const SolidGrid& grid) {
    if (!grid.known()) return 0;
    // The six ways from the first corner of a cell to the last one, an axis at a time.
    constexpr std::array<std::array<int, 2>, 6> ways{{{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
    double area = 0;
    const glm::ivec3 cells = grid.cells();
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) {
                std::array<glm::ivec3, 8> points;
                bool anyIn = false, anyOut = false;
                for (int corner = 0; corner < 8; ++corner) {
                    auto& point = points[static_cast<std::size_t>(corner)];
                    point = {x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2 & 1)};
                    (grid.inside(point) ? anyIn : anyOut) = true;
                }
                if (!anyIn || !anyOut) continue;
                for (const auto& way : ways) {
                    std::array<glm::dvec3, 4> corners;
                    std::array<double, 4> values;
                    const int chain[4] = {0, way[0], way[1], 7};
                    for (std::size_t i = 0; i < 4; ++i) {
                        const glm::ivec3& point = points[static_cast<std::size_t>(chain[i])];
                        corners[i] = grid.place(point);
                        values[i] = grid.value(point);
                    }
                    area += cutArea(corners, values);
                }
            }
    return area;
}

}  // namespace isoscope

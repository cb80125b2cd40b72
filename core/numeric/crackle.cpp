// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/crackle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/numeric/crackle_candidates.h"
#include "core/numeric/noise.h"

namespace isoscope {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct CellOffset {
    int axis[3];
};

consteval bool isSearched(int x, int y, int z) { return (x * x == 4) + (y * y == 4) + (z * z == 4) <= 1; }

/// The 81 cells to look at, nearest first so that the later ones can be skipped.
consteval std::array<CellOffset, 81> buildOffsets() {
    std::array<CellOffset, 81> offsets{};
    std::size_t count = 0;
    for (int shell = 0; shell <= 6; ++shell)
        for (int x = -2; x <= 2; ++x)
            for (int y = -2; y <= 2; ++y)
                for (int z = -2; z <= 2; ++z)
                    if (isSearched(x, y, z) && x * x + y * y + z * z == shell) offsets[count++] = {{x, y, z}};
    return offsets;
}

constexpr std::array<CellOffset, 81> offsets = buildOffsets();

/// The three smallest keys seen, and their points.
class Smallest {
  public:
    double third() const { return keys_[2]; }

    void add(double key, const std::array<double, 3>& point) {
        if (!(key < keys_[2])) return;
        std::size_t place = 2;
        for (; place > 0 && key < keys_[place - 1]; --place) {
            keys_[place] = keys_[place - 1];
            points_[place] = points_[place - 1];
        }
        keys_[place] = key;
        points_[place] = point;
    }

    CrackleDistances distances() const { return {keys_, points_}; }

  private:
    std::array<double, 3> keys_{infinite, infinite, infinite};
    std::array<std::array<double, 3>, 3> points_{};
};

/// The smallest possible distance along one axis from a place `inside` the middle cell to a cell `offset`
/// away. It allows for the 1e-10 by which the middle cell is displaced, and for rounding.
double gap(double inside, int offset) {
    constexpr double slack = 1e-9;
    if (offset > 0) return std::max(0.0, offset - inside - slack);
    return offset < 0 ? std::max(0.0, inside - offset - 1 - slack) : 0;
}

std::array<std::int64_t, 3> indexOf(const std::array<double, 3>& cell) {
    return {static_cast<std::int64_t>(cell[0]), static_cast<std::int64_t>(cell[1]),
            static_cast<std::int64_t>(cell[2])};
}

CrackleDistances finished(const Smallest& squares, double offset) {
    CrackleDistances found = squares.distances();
    for (double& d : found.d) d = std::sqrt(offset != 0 ? d + offset * offset : d);
    return found;
}

/// Euclidean distances. Squares are compared and roots taken at the end: rounding keeps the order.
CrackleDistances euclidean(const std::array<double, 3>& p, const CrackleCandidates& candidates,
                           double offset) {
    Smallest smallest;
    for (std::size_t i = 0; i < candidates.count; ++i) {
        const std::array<double, 3> point{candidates.x[i], candidates.y[i], candidates.z[i]};
        const double dx = p[0] - point[0], dy = p[1] - point[1], dz = p[2] - point[2];
        smallest.add(dx * dx + dy * dy + dz * dz, point);
    }
    return finished(smallest, offset);
}

/// The same by looking at all cells.
CrackleDistances euclidean(const std::array<double, 3>& p, const std::array<double, 3>& cell, double offset) {
    double squaredGaps[3][5];
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int o = -2; o <= 2; ++o) {
            const double distance = gap(p[axis] - cell[axis], o);
            squaredGaps[axis][o + 2] = distance * distance;
        }
    const std::array<std::int64_t, 3> index = indexOf(cell);
    Smallest smallest;
    for (const CellOffset& o : offsets) {
        const double least =
            squaredGaps[0][o.axis[0] + 2] + squaredGaps[1][o.axis[1] + 2] + squaredGaps[2][o.axis[2] + 2];
        if (least > smallest.third()) continue;
        const auto point = cracklePoint(index[0] + o.axis[0], index[1] + o.axis[1], index[2] + o.axis[2]);
        const double dx = p[0] - point[0], dy = p[1] - point[1], dz = p[2] - point[2];
        smallest.add(dx * dx + dy * dy + dz * dz, point);
    }
    return finished(smallest, offset);
}

/// Distances in another metric.
class GeneralSmallest {
  public:
    GeneralSmallest(const std::array<double, 3>& p, double metric) : p_(p), metric_(metric) {}

    void add(const std::array<double, 3>& point) {
        smallest_.add(crackleNorm(std::abs(p_[0] - point[0]), std::abs(p_[1] - point[1]),
                                  std::abs(p_[2] - point[2]), metric_),
                      point);
    }
    CrackleDistances finished(double offset) const {
        CrackleDistances found = smallest_.distances();
        if (offset != 0)
            for (double& d : found.d)
                d = std::pow(std::pow(d, metric_) + std::pow(offset, metric_), 1 / metric_);
        return found;
    }

  private:
    const std::array<double, 3>& p_;
    double metric_;
    Smallest smallest_;
};

CrackleDistances general(const std::array<double, 3>& p, const CrackleCandidates& candidates, double metric,
                         double offset) {
    GeneralSmallest smallest(p, metric);
    for (std::size_t i = 0; i < candidates.count; ++i)
        smallest.add({candidates.x[i], candidates.y[i], candidates.z[i]});
    return smallest.finished(offset);
}

/// The same by looking at all cells.
CrackleDistances general(const std::array<double, 3>& p, const std::array<double, 3>& cell, double metric,
                         double offset) {
    const std::array<std::int64_t, 3> index = indexOf(cell);
    GeneralSmallest smallest(p, metric);
    for (const CellOffset& o : offsets)
        smallest.add(cracklePoint(index[0] + o.axis[0], index[1] + o.axis[1], index[2] + o.axis[2]));
    return smallest.finished(offset);
}

/// Whether the coordinate's cell has a number of 64 bits.
bool hasCell(double coordinate) { return std::abs(coordinate) < 4611686018427387904.0; }

/// The random numbers of a cell: three in a row.
const double* cellNumbers(std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto& hash = latticeHash();
    const unsigned row = hash[hash[i & 4095] ^ static_cast<unsigned>(j & 4095)];
    return &uniformSequence()[hash[row ^ static_cast<unsigned>(k & 4095)]];
}

}  // namespace

const std::array<double, uniformCount>& uniformSequence() {
    static const std::array<double, uniformCount> sequence = [] {
        std::mt19937 random;
        std::array<double, uniformCount> values;
        for (double& value : values) value = static_cast<double>(random()) / 4294967296.0;
        return values;
    }();
    return sequence;
}

std::array<double, 3> cracklePoint(std::int64_t i, std::int64_t j, std::int64_t k) {
    const double* u = cellNumbers(i, j, k);
    return {static_cast<double>(i) + u[0], static_cast<double>(j) + u[1], static_cast<double>(k) + u[2]};
}

double cellValue(double x, double y, double z) {
    if (!hasCell(x) || !hasCell(y) || !hasCell(z)) return nan;
    const auto index = [](double t) { return static_cast<std::int64_t>(std::floor(t)); };
    return *cellNumbers(index(x), index(y), index(z));
}

CrackleDistances crackleDistances(double x, double y, double z, double metric, double offset) {
    const std::array<double, 3> p{x, y, z};
    if (!hasCell(x) || !hasCell(y) || !hasCell(z)) return {{nan, nan, nan}, {}};
    const CrackleCandidates* candidates = crackleCandidates({p, thriftyCrackleReach}, metric, 3);
    if (candidates && candidates->continuous())
        return metric == 2 ? euclidean(p, *candidates, offset) : general(p, *candidates, metric, offset);
    const std::array<double, 3> cell{std::floor(x - 1e-10), std::floor(y - 1e-10), std::floor(z - 1e-10)};
    return metric == 2 ? euclidean(p, cell, offset) : general(p, cell, metric, offset);
}

}  // namespace isoscope

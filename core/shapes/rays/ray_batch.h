// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/roots/column_table.h"
#include "core/shapes/rays/ray.h"

namespace isoscope {

/// Many rays coordinate by coordinate, so that vector instructions can work on them. Keeps its memory.
class RayBatch {
  public:
    /// The columns that operator[] hands out: one coordinate of all rays each.
    enum Column : std::size_t { originX, originY, originZ, directionX, directionY, directionZ, columnCount };

    /// Rays in use. clear() keeps the memory.
    std::size_t size() const { return columns_.size(); }
    bool empty() const { return columns_.empty(); }
    void clear() { columns_.clear(); }

    /// Room for so many rays; those that are there stay.
    void reserve(std::size_t rays) {
        columns_.reserve(rays);
        if (samples_.size() < rays) samples_.resize(rays);
    }
    /// Not beyond what is reserved: the new rays are for the caller to write.
    void setSize(std::size_t rays) { columns_.setSize(rays); }
    /// Becomes a copy of these rays.
    void assign(std::span<const Ray> rays) {
        clear();
        reserve(rays.size());
        setSize(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) set(i, rays[i]);
    }

    /// Becomes those of the rays with the given numbers.
    void gather(const RayBatch& rays, std::span<const std::uint32_t> numbers) {
        reserve(numbers.size());
        setSize(numbers.size());
        for (std::size_t column = 0; column < columnCount; ++column) {
            const double* const from = rays.columns_[column];
            double* const to = columns_[column];
            for (std::size_t k = 0; k < numbers.size(); ++k) to[k] = from[numbers[k]];
        }
        for (std::size_t k = 0; k < numbers.size(); ++k) samples_[k] = rays.samples_[numbers[k]];
    }

    double* operator[](Column column) { return columns_[column]; }
    const double* operator[](Column column) const { return columns_[column]; }
    /// Ray::sample of each ray, without padding. Valid, as all columns are, until reserve(), gather() or
    /// assign().
    std::uint32_t* samples() { return samples_.data(); }
    const std::uint32_t* samples() const { return samples_.data(); }

    /// Columns of x, y and z; behind the last ray go LineColumns::padding numbers without meaning.
    std::array<const double*, 3> origins() const {
        return {columns_[originX], columns_[originY], columns_[originZ]};
    }
    std::array<const double*, 3> directions() const {
        return {columns_[directionX], columns_[directionY], columns_[directionZ]};
    }

    /// A copy of ray i, which must be below size(), and its change; neither is checked.
    Ray ray(std::size_t i) const {
        return {{columns_[originX][i], columns_[originY][i], columns_[originZ][i]},
                {columns_[directionX][i], columns_[directionY][i], columns_[directionZ][i]},
                samples_[i]};
    }
    void set(std::size_t i, const Ray& ray) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int axis = static_cast<int>(c);
            columns_[originX + c][i] = ray.origin[axis];
            columns_[directionX + c][i] = ray.direction[axis];
        }
        samples_[i] = ray.sample;
    }

  private:
    ColumnTable<columnCount> columns_;
    std::vector<std::uint32_t> samples_;  ///< Ray::sample
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/roots/cells/box_pieces.h"
#include "core/shapes/isosurface/isosurface.h"

namespace isoscope {

/// The sides of the box around a container.
glm::dvec3 sizeOf(const Container& container);

/// The solid that an isosurface encloses, in its own coordinates: the points of the container at which g (the
/// function less the threshold, negated for polarity +) is below 0. Where g is undefined there is nothing, as
/// in pictures: rays pass through it. Immutable, shared by threads.
class SolidField {
  public:
    SolidField(const Isosurface& surface, std::span<const double> parameters);

    /// The function with its parameters, and the settings that say what g is.
    const PreparedFunction& function() const { return *function_; }
    const RootSettings& settings() const { return settings_; }
    const Container& container() const { return container_; }
    /// Whether the container's wall shows nothing.
    bool open() const { return settings_.open; }

    /// How far inside of the container a point lies, from the nearest wall; outside a negative number.
    double depth(const glm::dvec3& point) const;
    /// Out of the container, at the wall nearest to the point.
    glm::dvec3 wallNormal(const glm::dvec3& point) const;
    /// The point of the container nearest to this one.
    glm::dvec3 nearestInside(const glm::dvec3& point) const;
    /// The share of the way from `from`, inside, to `to`, outside, at which the container ends.
    double exit(const glm::dvec3& from, const glm::dvec3& to) const;
    /// Whether a box has no point of the container; whether it has no other points.
    bool misses(const glm::dvec3& low, const glm::dvec3& high) const;
    bool encloses(const glm::dvec3& low, const glm::dvec3& high) const;

  private:
    std::shared_ptr<const PreparedFunction> function_;
    RootSettings settings_;
    Container container_;
};

/// Whether a value of g counts as inside.
inline bool countsInside(double g) { return g < 0; }

/// The evaluators of one thread for a SolidField, which must outlive it. A single point without a value among
/// others that have one, as 0/0 on an axis, takes the value beside it; others without one have +infinity.
class SolidSampler {
  public:
    explicit SolidSampler(const SolidField& field);

    /// What is sampled.
    const SolidField& field() const { return field_; }
    /// For proofs about boxes.
    BoxPieces& boxes() { return boxes_; }
    /// g at many points; by a shortened tape, where it is given and holds at all of them.
    void values(std::span<const glm::dvec3> points, std::span<double> out,
                const SimplifiedTape* tape = nullptr);
    /// g and its gradient.
    void gradients(std::span<const glm::dvec3> points, std::span<ValueAndGradient> out);
    /// Whether points lie in the solid: 1 or 0. With `anywhere` g alone counts, not the container.
    void inside(std::span<const glm::dvec3> points, std::span<std::uint8_t> out, bool anywhere = false);

  private:
    void spread(std::span<const glm::dvec3> points);
    /// Gives g to those of the points where it is NaN.
    template <class Value>
    void settleUndefined(std::span<const glm::dvec3> points, std::span<Value> values);

    const SolidField& field_;
    BoxPieces boxes_;
    PointEvaluator points_;
    GradientEvaluator gradients_;
    std::vector<double> x_, y_, z_, values_, valuesBeside_;
};

/// Samplers that threads borrow. All methods may be called from any thread.
class SamplerPool {
  public:
    /// The field must outlive the pool, and the pool its loans.
    explicit SamplerPool(const SolidField& field) : field_(field) {}

    /// A sampler on loan; it goes back at the end of its life.
    class Loan {
      public:
        explicit Loan(SamplerPool& pool) : pool_(pool), sampler_(pool.take()) {}
        ~Loan() { pool_.giveBack(std::move(sampler_)); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        SolidSampler& operator*() const { return *sampler_; }
        SolidSampler* operator->() const { return sampler_.get(); }

      private:
        SamplerPool& pool_;
        std::unique_ptr<SolidSampler> sampler_;
    };

  private:
    std::unique_ptr<SolidSampler> take();
    void giveBack(std::unique_ptr<SolidSampler> sampler) noexcept;

    const SolidField& field_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<SolidSampler>> idle_;
};

}  // namespace isoscope

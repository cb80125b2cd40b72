// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace isoscope::test {

/// Proves bounds of a lattice noise N(f) = sum over the corners c of a unit cell of p_c(f) . w(n_c), where
/// p_c is a vector of polynomials that depends on the corner alone and w(n_c) one of finitely many vectors
/// from the noise's table (core/numeric/noise_bounds.h has the argument). Derivatives of N have the same form
/// with derivatives of p_c.
///
/// A bound on N, or on one of its first three derivatives along a direction, holds for every choice of the
/// n_c if sum over c of max over n of p_c(f) . w(n) stays below it for all f in the cell. The cell is halved
/// until interval bounds show that, or until a point shows the opposite.
class NoiseBoundProof {
  public:
    using Vector = std::array<double, 3>;

    /// The choices of w: (value, and the three slopes) for lattice noise.
    explicit NoiseBoundProof(std::vector<std::array<double, 4>> choices);

    /// Gradient noise: w is any vector (0, slopes) of length 1.
    static NoiseBoundProof ofUnitSlopes();

    /// Whether `sign` times the derivative of this order (0 to 3) along the unit vector `direction` is at
    /// most `bound`.
    bool holds(int order, const Vector& direction, int sign, double bound);

    /// The same for the second derivative d2N/(di dj) along two axes (0, 1, 2), which may be one.
    bool holdsForAxes(int i, int j, int sign, double bound);

    /// Whether the gradient (order 1) is at most `bound` long, the spectral norm of the second derivatives
    /// (order 2) or the third derivative along any direction (order 3) at most `bound`: proven for finitely
    /// many directions with the loss of the angle between them. With a `stride` above 1 only every so-manieth
    /// direction is looked at, which is a test and no proof.
    bool holdsForAllDirections(int order, double bound, int stride = 1);

    /// Whether the spectral norm of the second derivatives along the plane y = 0 is at most `bound` there.
    bool holdsInPlane(double bound);

    /// Boxes looked at so far: what the proofs have cost.
    long boxCount() const { return boxCount_; }

  private:
    static constexpr int mostOrder = 3;
    struct Centered;
    using Derivatives = std::array<Centered, mostOrder + 1>;
    struct Box;
    struct Corner;
    using Candidates = std::array<std::vector<unsigned short>, 8>;

    bool holdsInside(const Box& box, const Candidates& candidates);
    Corner cornerVector(int corner, const std::array<std::array<Derivatives, 4>, 3>& factors) const;
    double largest(const Corner& corner, const std::vector<unsigned short>& candidates,
                   std::vector<unsigned short>& kept, double& certain) const;
    bool holdsInPatch(int order, int face, double a, double b, double halfSize, double bound);

    std::vector<std::array<double, 4>> choices_;
    bool unitSlopes_ = false;
    bool inPlane_ = false;  ///< only the part y = 0 of the cell counts
    /// The derivative at hand as a sum: share of each term, and the order of the term along x, y and z.
    struct Term {
        double share = 0;
        std::array<int, 3> orders{};
    };
    bool holds(std::vector<Term> derivative, double bound);

    std::vector<Term> derivative_;
    double bound_ = 0;
    long boxCount_ = 0;
};

}  // namespace isoscope::test

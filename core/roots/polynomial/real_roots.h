// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace isoscope {

/// A short list of roots without memory of its own on the heap: tracing asks for them millions of times.
class RootSequence {
  public:
    static constexpr std::size_t capacity = 72;

    /// Further ones than `capacity` are dropped.
    void add(double root) {
        if (count_ < capacity) roots_[count_++] = root;
    }
    void clear() { count_ = 0; }
    /// Rising, and each once.
    void sort();

    /// Roots that are kept: at most `capacity`.
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    double operator[](std::size_t i) const { return roots_[i]; }
    /// Valid until the next add(), clear() or sort(), and while the sequence stays where it is.
    const double* begin() const { return roots_.data(); }
    const double* end() const { return roots_.data() + count_; }

  private:
    std::array<double, capacity> roots_;
    std::size_t count_ = 0;
};

/// The highest degree that realRoots() takes.
constexpr std::size_t realRootsDegreeLimit = 36;

/// The real roots of c[0] t^n + ... + c[n] with low <= t <= high, both finite, in rising order. Leading zeros
/// are allowed. Nothing for the zero polynomial, numbers that are not finite and an empty interval.
///
/// This is the fast way for pictures. Degrees 1 and 2 are solved in closed form with an exactly rounded
/// discriminant. Higher ones are written in the Bernstein basis and halved until Descartes' rule of signs
/// decides (Lane and Riesenfeld 1981), all in doubles with a bound on the accumulated rounding; where that
/// bound leaves a doubt, and where rounding blurs a root by more than 1e-11 of its size, polynomialRoots()
/// answers with 113 bits. So the sign changes found are those of the exact polynomial; of touching roots only
/// the double ones of degree 2 are reported, once: a ray that touches passes on, as in POV-Ray.
void realRoots(std::span<const double> coefficients, double low, double high, RootSequence& roots);

/// How often realRoots() of this thread had to ask polynomialRoots().
std::size_t realRootsFallbacks();

}  // namespace isoscope

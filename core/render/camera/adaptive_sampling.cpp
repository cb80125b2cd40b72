// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/adaptive_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/render/camera/place_random.h"

namespace isoscope {

namespace {

/// A rectangle of pixels with a number for each, -1 where none has been given.
class PixelNumbers {
  public:
    /// Around `pixels`, of which there must be at least one, and a margin of one pixel.
    explicit PixelNumbers(std::span<const PixelIndex> pixels) {
        const auto byX = [](const PixelIndex& a, const PixelIndex& b) { return a.x < b.x; };
        const auto byY = [](const PixelIndex& a, const PixelIndex& b) { return a.y < b.y; };
        const auto [left, right] = std::minmax_element(pixels.begin(), pixels.end(), byX);
        const auto [top, bottom] = std::minmax_element(pixels.begin(), pixels.end(), byY);
        left_ = left->x - 1;
        top_ = top->y - 1;
        across_ = right->x + 2 - left_;
        numbers_.assign(static_cast<std::size_t>(across_) * static_cast<std::size_t>(bottom->y + 2 - top_),
                        -1);
    }

    int& of(int x, int y) {
        return numbers_[static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(across_) +
                        static_cast<std::size_t>(x - left_)];
    }

  private:
    int left_, top_, across_;
    std::vector<int> numbers_;
};

constexpr std::array<PixelIndex, 4> neighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// A square part of a pixel, in the finest steps that its pixel may be divided into.
struct Part {
    std::uint32_t pixel;
    int left, top, size;
    int level;
};

/// The corners of parts, in finest steps of the picture; pixels share them.
class Lattice {
  public:
    explicit Lattice(int steps) : steps_(steps) {}

    /// The number of the colour at a corner; a new one is to be found at the place appended to `wanted`.
    std::size_t numberOf(const PixelIndex& pixel, int x, int y, std::vector<PixelIndex>& wanted) {
        const PixelIndex corner{pixel.x * steps_ + x, pixel.y * steps_ + y};
        const auto key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(corner.y)) << 32 |
                         static_cast<std::uint32_t>(corner.x);
        const auto [found, isNew] = numbers_.emplace(key, numbers_.size());
        if (isNew) wanted.push_back(corner);
        return found->second;
    }

  private:
    int steps_;
    std::unordered_map<std::uint64_t, std::size_t> numbers_;
};

/// NaN becomes 0.
float clipped(double value) { return static_cast<float>(std::min(std::max(0.0, value), 1.0)); }

}  // namespace

AdaptiveSampling::AdaptiveSampling(const Antialiasing& settings, int width, int height)
    : settings_(settings), width_(width), height_(height) {
    settings_.depth = std::clamp(settings_.depth, 1, 9);
}

bool AdaptiveSampling::draw(std::span<const PixelIndex> pixels, const Shade& shade,
                            std::span<LinearColor> colors, std::span<float> background) const {
    if (pixels.empty()) return true;
    std::vector<glm::dvec4> means(pixels.size(), glm::dvec4(0));
    const bool drawn = settings_.method == SamplingMethod::adaptive ? drawGrids(pixels, shade, means)
                                                                    : drawDivided(pixels, shade, means);
    for (std::size_t i = 0; i < means.size(); ++i)
        colors[i] = {clipped(means[i].x), clipped(means[i].y), clipped(means[i].z)};
    for (std::size_t i = 0; i < background.size(); ++i) background[i] = clipped(means[i].w);
    return drawn;
}

bool AdaptiveSampling::drawGrids(std::span<const PixelIndex> pixels, const Shade& shade,
                                 std::span<glm::dvec4> sums) const {
    PixelNumbers numbers(pixels);
    std::vector<SampleBatch::PixelPosition> places;
    const auto ask = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_ || numbers.of(x, y) >= 0) return;
        numbers.of(x, y) = static_cast<int>(places.size());
        places.push_back({x + 0.5, y + 0.5});
    };
    for (const PixelIndex& pixel : pixels) ask(pixel.x, pixel.y);
    for (const PixelIndex& pixel : pixels)
        for (const PixelIndex& way : neighbours) ask(pixel.x + way.x, pixel.y + way.y);
    std::vector<glm::dvec4> middles;
    if (!shade(places, middles)) return false;

    std::vector<std::size_t> uneven;
    places.clear();
    const int side = settings_.depth;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelIndex& pixel = pixels[i];
        sums[i] = middles[static_cast<std::size_t>(numbers.of(pixel.x, pixel.y))];
        const bool edge = std::any_of(neighbours.begin(), neighbours.end(), [&](const PixelIndex& way) {
            const int other = numbers.of(pixel.x + way.x, pixel.y + way.y);
            return other >= 0 && differ(sums[i], middles[static_cast<std::size_t>(other)]);
        });
        if (!edge) continue;
        uneven.push_back(i);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                places.push_back(
                    moved(pixel.x + (column + 0.5) / side, pixel.y + (row + 0.5) / side, 1.0 / side));
    }
    std::vector<glm::dvec4> finer;
    if (!shade(places, finer)) return false;
    // The first sample counts like the others.
    const auto each = static_cast<std::size_t>(side * side);
    for (std::size_t i = 0; i < uneven.size(); ++i) {
        glm::dvec4& sum = sums[uneven[i]];
        for (std::size_t k = 0; k < each; ++k) sum += finer[i * each + k];
        sum /= static_cast<double>(each + 1);
    }
    return true;
}

bool AdaptiveSampling::drawDivided(std::span<const PixelIndex> pixels, const Shade& shade,
                                   std::span<glm::dvec4> sums) const {
    const int steps = 1 << (settings_.depth - 1);
    Lattice lattice(steps);
    std::vector<Part> parts, finer;
    std::vector<std::array<std::size_t, 4>> corners;
    std::vector<PixelIndex> wanted;
    std::vector<SampleBatch::PixelPosition> places;
    std::vector<glm::dvec4> colors, found;
    for (std::uint32_t i = 0; i < pixels.size(); ++i) parts.push_back({i, 0, 0, steps, 0});
    while (!parts.empty()) {
        wanted.clear();
        corners.clear();
        for (const Part& part : parts) {
            std::array<std::size_t, 4>& four = corners.emplace_back();
            for (std::size_t k = 0; k < 4; ++k)
                four[k] = lattice.numberOf(pixels[part.pixel], part.left + (k % 2 ? part.size : 0),
                                           part.top + (k / 2 ? part.size : 0), wanted);
        }
        places.clear();
        for (const PixelIndex& corner : wanted)
            places.push_back(moved(static_cast<double>(corner.x) / steps,
                                   static_cast<double>(corner.y) / steps, 1.0 / steps));
        if (!shade(places, found)) return false;
        colors.insert(colors.end(), found.begin(), found.end());

        finer.clear();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const Part& part = parts[i];
            std::array<glm::dvec4, 4> four;
            for (std::size_t k = 0; k < 4; ++k) four[k] = colors[corners[i][k]];
            const bool edge = std::any_of(four.begin(), four.end(),
                                          [&](const glm::dvec4& color) { return differ(color, four[0]); }) ||
                              differ(four[1], four[2]) || differ(four[1], four[3]) ||
                              differ(four[2], four[3]);
            if (!edge || part.size == 1) {
                sums[part.pixel] +=
                    std::ldexp(0.25, -2 * part.level) * (four[0] + four[1] + four[2] + four[3]);
                continue;
            }
            const int half = part.size / 2;
            for (int k = 0; k < 4; ++k)
                finer.push_back({part.pixel, part.left + (k % 2) * half, part.top + (k / 2) * half, half,
                                 part.level + 1});
        }
        parts.swap(finer);
    }
    return true;
}

bool AdaptiveSampling::differ(const glm::dvec4& a, const glm::dvec4& b) const {
    double difference = 0;
    for (int c = 0; c < 4; ++c)
        difference += std::abs(std::pow(std::max(0.0, a[c]), 1 / settings_.gamma) -
                               std::pow(std::max(0.0, b[c]), 1 / settings_.gamma));
    return difference > settings_.threshold;
}

/// `reach` is the distance of samples.
SampleBatch::PixelPosition AdaptiveSampling::moved(double x, double y, double reach) const {
    if (!(settings_.jitter > 0)) return {x, y};
    PlaceRandom random({x, y, 0});
    const double amount = std::min(settings_.jitter, 1.0) * reach;
    const double aside = amount * (random.next() - 0.5);
    return {x + aside, y + amount * (random.next() - 0.5)};
}

}  // namespace isoscope

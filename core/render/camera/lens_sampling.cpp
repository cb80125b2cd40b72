// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/camera/lens_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/render/camera/place_random.h"
#include "core/render/effect_reasons.h"
#include "core/render/render_request.h"
#include "core/scene/camera.h"

namespace isoscope {

namespace {

/// After so many samples a pixel is looked at for the first time.
constexpr int firstLook = 8;
/// For their memory.
constexpr int samplesAtOnce = 1 << 18;

double fraction(double x) { return x - std::floor(x); }

/// Even sequences in four dimensions: Martin Roberts, "The unreasonable effectiveness of quasirandom
/// sequences", 2018. Two are for the pixel, two for the lens.
class Spread {
  public:
    explicit Spread(const PixelIndex& pixel) : pixel_(pixel) {
        PlaceRandom random({pixel.x, pixel.y, 0});
        for (double& start : starts_) start = random.next();
    }

    SampleBatch::PixelPosition place(int number) const {
        return {pixel_.x + at(number, 0), pixel_.y + at(number, 1)};
    }
    glm::dvec2 lens(int number) const {
        const double radius = std::sqrt(at(number, 2)), angle = 2 * std::numbers::pi * at(number, 3);
        return {radius * std::cos(angle), radius * std::sin(angle)};
    }

  private:
    double at(int number, std::size_t dimension) const {
        static constexpr double root = 1.1673039782614187;
        static constexpr std::array<double, 4> steps{1 / root, 1 / (root * root), 1 / (root * root * root),
                                                     1 / (root * root * root * root)};
        return fraction(starts_[dimension] + number * steps[dimension]);
    }

    PixelIndex pixel_;
    std::array<double, 4> starts_;
};

/// How many standard deviations hold a normal variable with this confidence, both sides counted.
double deviations(double confidence) {
    double low = 0, high = 8;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erf(middle / std::numbers::sqrt2) < confidence ? low : high) = middle;
    }
    return high;
}

struct Sum {
    glm::dvec4 values{0}, squares{0};
    int count = 0;

    void add(const glm::dvec4& color) {
        values += color;
        squares += color * color;
        ++count;
    }
    /// The standard deviation of the mean, of the worst channel.
    double doubt() const {
        double worst = 0;
        for (int c = 0; c < 4; ++c) {
            const double mean = values[c] / count;
            worst = std::max(worst, squares[c] / count - mean * mean);
        }
        return std::sqrt(worst / count);
    }
};

}  // namespace

bool LensSampling::draw(std::span<const PixelIndex> pixels, const Shade& shade, std::span<LinearColor> colors,
                        std::span<float> background) const {
    const double reach = deviations(blur_.confidence);
    std::vector<Sum> sums(pixels.size());
    std::vector<std::size_t> open(pixels.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
    std::vector<SampleBatch::PixelPosition> places;
    std::vector<glm::dvec2> lens;
    std::vector<glm::dvec4> found;
    for (int done = 0; done < blur_.samples && !open.empty();) {
        const int most = std::max(1, samplesAtOnce / static_cast<int>(open.size()));
        const int goal = std::min({blur_.samples, std::max(firstLook, 2 * done), done + most});
        places.clear();
        lens.clear();
        for (const std::size_t i : open) {
            const Spread spread(pixels[i]);
            for (int number = done; number < goal; ++number) {
                places.push_back(spread.place(number));
                lens.push_back(spread.lens(number));
            }
        }
        if (!shade(places, lens, found)) return false;
        const auto each = static_cast<std::size_t>(goal - done);
        for (std::size_t k = 0; k < open.size(); ++k)
            for (std::size_t n = 0; n < each; ++n) sums[open[k]].add(found[k * each + n]);
        std::erase_if(open, [&](std::size_t i) { return reach * sums[i].doubt() < blur_.variance; });
        done = goal;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto mean = [&](int c) {
            return static_cast<float>(
                std::min(std::max(0.0, sums[i].values[c] / std::max(1, sums[i].count)), 1.0));
        };
        colors[i] = {mean(0), mean(1), mean(2)};
        if (!background.empty()) background[i] = mean(3);
    }
    return true;
}

namespace {

EffectReason reasonFor(const Scene& scene) {
    const FocalBlur& blur = scene.camera.blur;
    if (!blur.any()) return {false, "the camera has no aperture"};
    return {true, "the camera has an aperture; up to " +
                      counted(static_cast<std::size_t>(blur.samples), "ray") + " a pixel"};
}

void takeOut(RenderRequest& request) { request.camera.blur = {}; }

}  // namespace

const EffectDescription effects::focalBlur{.name = "focal blur", .reasonFor = reasonFor, .takeOut = takeOut};

}  // namespace isoscope

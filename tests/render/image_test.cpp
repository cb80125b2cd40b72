// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/image.h"

#include <bit>
#include <cmath>
#include <QTest>
#include <random>

using namespace isoscope;

namespace {

/// The sRGB transfer function as it stands in the standard.
std::uint32_t codeByFormula(float linear) {
    const double x = linear;
    const double curve = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::floor(curve * 255 + 0.5));
}

std::uint32_t code(float linear) { return encodePixel({linear, 0, 0}) >> 16 & 0xff; }

}  // namespace

class ImageTest : public QObject {
    Q_OBJECT

  private slots:
    void codesAreThoseOfTheFormula() {
        const unsigned seed = 5;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
        for (int k = 0; k < 300000; ++k) {
            const float linear = std::bit_cast<float>(static_cast<std::uint32_t>(random() % one));
            QCOMPARE(code(linear), codeByFormula(linear));
        }
        for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0x1p-14f); bits < one; bits += 997)
            QCOMPARE(code(std::bit_cast<float>(bits)), codeByFormula(std::bit_cast<float>(bits)));
    }

    void codesAreExactWhereTheyChange() {
        for (std::uint32_t step = 1; step < 256; ++step) {
            // The smallest float with this code, by bisection of the formula.
            std::uint32_t low = 0, high = std::bit_cast<std::uint32_t>(1.0f);
            while (high - low > 1) {
                const std::uint32_t middle = low + (high - low) / 2;
                (codeByFormula(std::bit_cast<float>(middle)) < step ? low : high) = middle;
            }
            QCOMPARE(code(std::bit_cast<float>(low)), step - 1);
            QCOMPARE(code(std::bit_cast<float>(high)), step);
        }
    }

    void listsOfAnyLengthAreEncoded() {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> channel(-0.2f, 1.3f);
        for (std::size_t size = 0; size < 100; ++size) {
            std::vector<std::array<float, 3>> linear(size);
            for (auto& pixel : linear) pixel = {channel(random), channel(random), channel(random)};
            std::vector<std::uint32_t> encoded(size + 1, 7);
            encodePixels(linear, std::span(encoded).first(size));
            for (std::size_t i = 0; i < size; ++i)
                QCOMPARE(encoded[i], 0xff000000u | code(linear[i][0]) << 16 | code(linear[i][1]) << 8 |
                                         code(linear[i][2]));
            QCOMPARE(encoded[size], 7u);
        }
    }

    void extremesAreClipped() {
        QCOMPARE(code(std::nanf("")), 0u);
        QCOMPARE(code(-1), 0u);
        QCOMPARE(code(0), 0u);
        QCOMPARE(code(std::bit_cast<float>(1u)), 0u);
        QCOMPARE(code(1), 255u);
        QCOMPARE(code(HUGE_VALF), 255u);
    }
};

QTEST_APPLESS_MAIN(ImageTest)
#include "image_test.moc"

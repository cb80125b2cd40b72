// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/lipschitz/miss_memory.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <QFile>
#include <QTest>

#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "tests/roots/lambda_field.h"
#include "tests/support/csv_table.h"

using namespace isoscope;
using isoscope::test::LambdaField;

namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr int blockSize = 32;  // POV-Ray's

double sphere(const glm::dvec3& p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; }

using Mask = std::vector<bool>;

/// A pixel's ray through the container of tests/data/roots/sphere_holes.pov.
LineQuery pixelLine(int column, int row) {
    const glm::dvec3 origin(0, 0, -3);
    const glm::dvec3 direction =
        glm::normalize(glm::dvec3(1.33 * ((column + 0.5) / width - 0.5), 0.5 - (row + 0.5) / height, 1));
    const double middle = -glm::dot(origin, direction);
    const double squaredHalf = 1.2 * 1.2 - (9 - middle * middle);
    if (squaredHalf <= 0) return {};
    return {origin, direction, middle - std::sqrt(squaredHalf), middle + std::sqrt(squaredHalf)};
}

Mask render(double maxGradient, bool missMemory, double* steepest = nullptr) {
    RootSettings settings;
    settings.accuracy = 0.0001;
    settings.maxGradient = maxGradient;
    Mask mask(width * height);
    for (int top = 0; top < height; top += blockSize)
        for (int left = 0; left < width; left += blockSize) {
            LipschitzRootFinder finder(std::make_unique<LambdaField>(sphere), settings);
            std::vector<LineQuery> queries;
            std::vector<std::size_t> pixels;
            for (int row = top; row < std::min(height, top + blockSize); ++row)
                for (int column = left; column < std::min(width, left + blockSize); ++column) {
                    queries.push_back(pixelLine(column, row));
                    pixels.push_back(static_cast<std::size_t>(row * width + column));
                }
            std::vector<RootList> roots(queries.size());
            finder.find(queries, {0, missMemory, {}}, roots);
            for (std::size_t k = 0; k < pixels.size(); ++k) mask[pixels[k]] = !roots[k].empty();
            if (steepest != nullptr) *steepest = std::max(*steepest, finder.report().steepest);
        }
    return mask;
}

Mask povrayMask(const QString& maxGradient) {
    QFile file(test::dataFile("roots/sphere_holes_" + maxGradient + ".pbm"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray bits = file.readAll().last(width * height / 8);
    Mask mask(width * height);
    for (int i = 0; i < width * height; ++i) mask[std::size_t(i)] = (bits[i / 8] >> (7 - i % 8) & 1) != 0;
    return mask;
}

std::size_t count(const Mask& mask) { return std::size_t(std::count(mask.begin(), mask.end(), true)); }

}  // namespace

class MissMemoryTest : public QObject {
    Q_OBJECT

  private slots:
    void holesAreThoseOfPovray_data() {
        QTest::addColumn<QString>("maxGradient");
        QTest::addColumn<std::size_t>("povrayHoles");
        QTest::addColumn<std::size_t>("different");
        // What differs stems from the memory being empty at the start of each block.
        QTest::newRow("1.1") << "1.1" << std::size_t(2) << std::size_t(0);
        QTest::newRow("0.9") << "0.9" << std::size_t(145) << std::size_t(5);
        QTest::newRow("0.7") << "0.7" << std::size_t(647) << std::size_t(19);
        QTest::newRow("0.5") << "0.5" << std::size_t(3465) << std::size_t(223);
    }

    void holesAreThoseOfPovray() {
        QFETCH(QString, maxGradient);
        QFETCH(std::size_t, povrayHoles);
        QFETCH(std::size_t, different);
        const Mask povray = povrayMask(maxGradient);
        QCOMPARE(povray.size(), std::size_t(width * height));
        const Mask ours = render(maxGradient.toDouble(), true);
        QCOMPARE(count(render(2.4, false)) - count(povray), povrayHoles);
        std::size_t differences = 0;
        for (std::size_t i = 0; i < ours.size(); ++i) differences += ours[i] != povray[i];
        QCOMPARE(differences, different);
    }

    void steepestSlopeIsTheOneThatPovrayReports() {
        // "The maximum gradient found was", with max_gradient as given; POV-Ray prints three digits.
        const std::vector<std::pair<double, double>> reported{{0.5, 2.100}, {0.7, 2.100}, {0.9, 2.250},
                                                              {1.1, 2.250}, {1.8, 2.250}, {4, 2.325}};
        for (const auto& [maxGradient, expected] : reported) {
            double steepest = 0;
            render(maxGradient, true, &steepest);
            QVERIFY2(std::abs(steepest - expected) <= 0.0005, qPrintable(QString::number(steepest, 'g', 9)));
        }
    }

    void withoutTheMemoryMostHolesClose() {
        QCOMPARE(count(render(2.4, false)) - count(render(0.7, false)), std::size_t(0));
    }

    void aTrueBoundLosesNothing() { QCOMPARE(render(2.4, true), render(2.4, false)); }

    void dismissalCutsTheRootsOfTheSearchAndLater() {
        MissMemory memory;
        SearchTrail missed;
        missed.starts[0] = 1;
        missed.count = 1;
        missed.missed = true;
        missed.lowest = 0.5;
        RootList none;
        QVERIFY(!memory.apply({{0, 0, 0}, {0, 0, 1}, 1, 3}, missed, 1, none));

        SearchTrail found = missed;
        found.missed = false;
        const RootList roots{{1, RootKind::entryWall}, {2, RootKind::crossing}, {3, RootKind::exitWall}};
        // Ends moved by 0.4: 0.5 - 1 * 0.4 > 0.
        RootList near = roots;
        QVERIFY(memory.apply({{0.4, 0, 0}, {0, 0, 1}, 1, 3}, found, 1, near));
        QCOMPARE(near, (RootList{{1, RootKind::entryWall}, {3, RootKind::exitWall}}));
        RootList far = roots;
        QVERIFY(!memory.apply({{0.6, 0, 0}, {0, 0, 1}, 1, 3}, found, 1, far));
        QCOMPARE(far, roots);
        // A search that found its root has emptied the memory.
        near = roots;
        QVERIFY(!memory.apply({{0.4, 0, 0}, {0, 0, 1}, 1, 3}, found, 1, near));
        QCOMPARE(near, roots);
    }

    void dismissedLinesTeachNothing() {
        // Two equal lines of a function that is NaN in between: the second is dismissed, and with `evaluate`
        // the bound stays what the first has left.
        RootSettings settings;
        settings.maxGradient = 1;
        settings.evaluate = {1, 2, 0.5};
        int calls = 0;
        LipschitzRootFinder finder(std::make_unique<LambdaField>(
                                       [&](const glm::dvec3&) { return ++calls > 2 ? 100.0 * calls : 1.0; }),
                                   settings);
        const std::vector<LineQuery> queries(2, {{0, 0, -3}, {0, 0, 1}, 2, 3});
        std::vector<RootList> roots(2);
        finder.find(queries, {0, true, {}}, roots);
        QCOMPARE(finder.report().maxGradient, 1.0);
        const std::vector<LineQuery> elsewhere(1, {{5, 0, -3}, {0, 0, 1}, 2, 3});
        finder.find(elsewhere, {0, true, {}}, roots);
        QVERIFY(finder.report().maxGradient > 1.0);
    }
};

QTEST_APPLESS_MAIN(MissMemoryTest)
#include "miss_memory_test.moc"

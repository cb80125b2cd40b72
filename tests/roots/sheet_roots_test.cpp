// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/sheet_roots.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "core/evaluate/prepared_function.h"
#include "tests/roots/line_table.h"
#include "tests/roots/sample_lines.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::LineTable;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(141421);

/// The roots that bundles find by themselves.
struct Found {
    FirstRoots roots;
    CertainStarts starts;
    std::vector<std::size_t> found;  ///< lines
    std::size_t marched = 0;

    Found(const std::shared_ptr<const Tape>& tape, const std::vector<LineQuery>& lines,
          const RootSettings& settings = {}, double sufficient = 0) {
        const auto function = PreparedFunction::of(tape, {});
        AffineEvaluator forms(function);
        PointEvaluator points(function);
        GradientEvaluator gradients(function);
        const LineTable table(lines);
        starts.reset(lines.size());
        std::vector<MarchedBundle> bundles;
        BundleMarch(function->cost())
            .run(table.columns(), {{settings.threshold, settings.positivePolarity}}, forms, starts, &bundles);
        marched = bundles.size();
        roots.clear(lines.size());
        SheetRoots(function, points, gradients, settings)
            .run(table.columns(), bundles, sufficient, starts, roots);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (roots.crossings[FirstRoots::t][i] < FirstRoots::none) found.push_back(i);
    }

    std::size_t size() const { return found.size(); }
    std::size_t line(std::size_t k) const { return found[k]; }
    double t(std::size_t k) const { return roots.crossings[FirstRoots::t][found[k]]; }
    glm::dvec3 normal(std::size_t k) const {
        return {roots.crossings[FirstRoots::normalX][found[k]],
                roots.crossings[FirstRoots::normalY][found[k]],
                roots.crossings[FirstRoots::normalZ][found[k]]};
    }
};

std::shared_ptr<const Tape> sphere() {
    return tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 1; });
}

}  // namespace

class SheetRootsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void mostOfASphereIsFoundByBundles() {
        std::mt19937_64 random(seed);
        std::size_t found = 0, all = 0;
        for (int view = 0; view < 40; ++view) {
            const std::vector<LineQuery> lines = test::neighbourLines(random, 0.1);
            const Found sheet(sphere(), lines);
            found += sheet.size(), all += lines.size();
            for (std::size_t k = 0; k < sheet.size(); ++k) {
                const LineQuery& line = lines[sheet.line(k)];
                const glm::dvec3 point = line.origin + sheet.t(k) * line.direction;
                QVERIFY(std::abs(glm::length(point) - 1) < 1e-7);
                // The first of both.
                QVERIFY(glm::dot(point, line.direction) < 0);
                QVERIFY(glm::distance(sheet.normal(k), point) < 2e-5);
                QVERIFY(std::isinf(sheet.starts[sheet.line(k)].start));
            }
        }
        qInfo("%zu of %zu", found, all);
        QVERIFY(10 * found > 9 * all);
    }

    void narrowerAccuraciesTakeShorterSteps() {
        std::mt19937_64 random(seed);
        RootSettings settings;
        settings.accuracy = 1e-9;
        const std::vector<LineQuery> lines = test::neighbourLines(random, 0.1);
        const Found sheet(sphere(), lines, settings);
        QVERIFY(sheet.size() > 200);
        for (std::size_t k = 0; k < sheet.size(); ++k) {
            const LineQuery& line = lines[sheet.line(k)];
            QVERIFY(std::abs(glm::length(line.origin + sheet.t(k) * line.direction) - 1) < 1e-14);
        }
        // Where doubles end, nothing is certain.
        settings.accuracy = 1e-16;
        QCOMPARE(Found(sphere(), lines, settings).size(), std::size_t{0});
    }

    /// A wall a millionth thick: no slab holds one root only.
    void thinWallsAreLeftToOthers() {
        std::mt19937_64 random(seed);
        const auto wall =
            tapeOf([](auto x, auto y, auto z) { return sq(sq(x) + sq(y) + sq(z) - 1) - 1e-12; });
        leavesAllToOthers(wall, random);
    }

    /// The sign changes once for all three, but not where the line meets the first of them.
    void threeSheetsAtOnePlaceAreLeftToOthers() {
        std::mt19937_64 random(seed);
        const auto sheets = tapeOf([](auto x, auto y, auto z) {
            const auto s = sq(x) + sq(y) + sq(z) - 1;
            return s * (sq(s) - 1e-12);
        });
        leavesAllToOthers(sheets, random);
    }

    void linesThatBeginBehindTheSurfaceAreLeftToOthers() {
        std::mt19937_64 random(seed);
        std::vector<LineQuery> lines = test::neighbourLines(random, 0.1);
        for (std::size_t i = 0; i < lines.size(); i += 3) lines[i].near = 4;
        for (std::size_t i = 1; i < lines.size(); i += 3) lines[i].far = 2.6;
        const Found sheet(sphere(), lines);
        QVERIFY(sheet.size() > 50);
        for (std::size_t k = 0; k < sheet.size(); ++k) QCOMPARE(sheet.line(k) % 3, std::size_t{2});
    }

    void rootsThatAreNotSufficientAreLeftToOthers() {
        std::mt19937_64 random(seed);
        const std::vector<LineQuery> lines = test::neighbourLines(random, 0.1);
        QVERIFY(Found(sphere(), lines).size() > 200);
        QCOMPARE(Found(sphere(), lines, {}, 3.9).size(), std::size_t{0});
    }

    void aRootRightAtWhatIsSufficientCounts() {
        const auto plane = tapeOf([](auto, auto, auto z) { return -z; });
        std::vector<LineQuery> lines;
        for (int k = 0; k < 64; ++k)
            lines.push_back({{0.01 * (k % 8), 0.01 * (k / 8), -4}, {0, 0, 1}, 2.4, 5.6});
        const Found sheet(plane, lines, {}, 4);
        QCOMPARE(sheet.size(), lines.size());
        for (std::size_t k = 0; k < sheet.size(); ++k) QCOMPARE(sheet.t(k), 4.0);
    }

    /// Thresholds and signs as the settings say.
    void thresholdAndPolarityCount() {
        std::mt19937_64 random(seed);
        const auto inverted = tapeOf([](auto x, auto y, auto z) { return 4 - (sq(x) + sq(y) + sq(z)) * 4; });
        RootSettings settings;
        settings.threshold = 3;
        settings.positivePolarity = true;
        const std::vector<LineQuery> lines = test::neighbourLines(random, 0.02);
        const Found sheet(inverted, lines, settings);
        QVERIFY(sheet.size() > 200);
        for (std::size_t k = 0; k < sheet.size(); ++k) {
            const LineQuery& line = lines[sheet.line(k)];
            const glm::dvec3 point = line.origin + sheet.t(k) * line.direction;
            QVERIFY(std::abs(glm::length(point) - 0.5) < 1e-6);
            QVERIFY(glm::distance(sheet.normal(k), 2.0 * point) < 2e-4);
        }
    }

    /// What is left of a root's last step does not count, however the surface bends between the lines.
    void rootsOfBentSheetsAreExact() {
        std::mt19937_64 random(seed);
        const auto dented = tapeOf([](auto x, auto y, auto z) {
            return sq(sq(x)) + sq(sq(y)) + sq(z) + 0.1 * sin(x * 7) * cos(y * 5) + 0.2 * x * z - 0.9;
        });
        PointEvaluator points(dented, {});
        for (const double accuracy : {1e-3, 1e-6, 1e-9}) {
            RootSettings settings;
            settings.accuracy = accuracy;
            std::size_t found = 0;
            for (int view = 0; view < 40; ++view) {
                const std::vector<LineQuery> lines = test::neighbourLines(random, 0.02);
                const Found sheet(dented, lines, settings);
                found += sheet.size();
                for (std::size_t k = 0; k < sheet.size(); ++k) {
                    const LineQuery& line = lines[sheet.line(k)];
                    const auto at = [&](double t) {
                        const glm::dvec3 point = line.origin + t * line.direction;
                        return points.evaluate(point.x, point.y, point.z);
                    };
                    const double off = 1e-3 * accuracy / glm::length(line.direction) + 1e-13;
                    QVERIFY(at(sheet.t(k) - off) > 0 && at(sheet.t(k) + off) < 0);
                }
            }
            QVERIFY(found > 1000);
        }
    }

    void functionsWithoutSlopesAreLeftToOthers() {
        std::mt19937_64 random(seed);
        const auto steps =
            tapeOf([](auto x, auto y, auto z) { return floor(x * 3) / 3 + sq(y) + sq(z) - 0.4; });
        QCOMPARE(Found(steps, test::neighbourLines(random, 0.1)).size(), std::size_t{0});
    }

  private:
    /// Of some views, for in single ones no bundle comes near.
    static void leavesAllToOthers(const std::shared_ptr<const Tape>& tape, std::mt19937_64& random) {
        std::size_t marched = 0;
        for (int view = 0; view < 4; ++view) {
            const Found sheet(tape, test::neighbourLines(random, 0.1));
            marched += sheet.marched;
            QCOMPARE(sheet.size(), std::size_t{0});
        }
        QVERIFY(marched > 0);
    }
};

QTEST_APPLESS_MAIN(SheetRootsTest)
#include "sheet_roots_test.moc"

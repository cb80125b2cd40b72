// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/bundle_march.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/evaluate/point_evaluator.h"
#include "core/function/graph_builder.h"
#include "core/roots/certified/certified_root_finder.h"
#include "tests/roots/line_table.h"
#include "tests/roots/sample_lines.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::beginAnywhere;
using test::NamedTape;
using test::neighbourLines;
using test::sampleTapes;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(314159);

}  // namespace

class BundleMarchTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void certainStartsAreCertain() {
        std::mt19937_64 random(seed);
        std::size_t started = 0;
        for (const NamedTape& shape : sampleTapes()) {
            AffineEvaluator forms(shape.tape, {});
            PointEvaluator points(shape.tape, {});
            BundleMarch bundles(TapeCost(*shape.tape));
            for (int view = 0; view < 20; ++view) {
                const std::vector<LineQuery> lines = neighbourLines(random, 0.4);
                const std::vector<std::uint8_t> wanted(lines.size(), 1);
                CertainStarts starts(lines.size());
                bundles.run(lines, wanted, {}, forms, starts);
                for (std::size_t i = 0; i < lines.size(); ++i) {
                    if (starts[i].sign == 0) continue;
                    ++started;
                    const double end = std::min(starts[i].start, lines[i].far);
                    for (int k = 0; k <= 20; ++k) {
                        const double t = lines[i].near + (end - lines[i].near) * k / 20;
                        const glm::dvec3 p = lines[i].origin + t * lines[i].direction;
                        const double value = points.evaluate(p.x, p.y, p.z);
                        if (!(value * starts[i].sign > 0))
                            QFAIL(qPrintable(
                                QString("%1: f = %2 at t = %3").arg(shape.name).arg(value).arg(t)));
                    }
                }
            }
        }
        QVERIFY(started > 10000);
    }

    /// Rays answered together are answered as each one alone. Only whether the search has to step over the
    /// place of a jump may depend on where it begins.
    void bundlesChangeNoAnswer() {
        std::mt19937_64 random(seed + 1);
        for (const bool open : {true, false}) {
            RootSettings settings;
            settings.open = open;
            for (const NamedTape& shape : sampleTapes()) {
                CertifiedRootFinder finder(shape.tape, {}, settings);
                for (int view = 0; view < 8; ++view) {
                    std::vector<LineQuery> lines = neighbourLines(random, 0.4);
                    if (view >= 6) beginAnywhere(random, lines);
                    std::vector<RootList> together(lines.size()), alone(lines.size());
                    RootRequest request;
                    request.sufficient = 0;
                    finder.find(lines, request, together);
                    const std::vector<Verdict> verdicts(finder.verdicts().begin(), finder.verdicts().end());
                    for (std::size_t i = 0; i < lines.size(); ++i) {
                        finder.find({&lines[i], 1}, request, {&alone[i], 1});
                        const QString place =
                            QString("%1, view %2, line %3").arg(shape.name).arg(view).arg(i);
                        QVERIFY2(together[i].size() == alone[i].size(), qPrintable(place));
                        const bool jumps = shape.name == std::string_view("steps");
                        QVERIFY2(jumps || verdicts[i] == finder.verdicts()[0], qPrintable(place));
                        if (alone[i].empty()) continue;
                        QVERIFY2(jumps || together[i][0].kind == alone[i][0].kind, qPrintable(place));
                        QVERIFY2(std::abs(together[i][0].t - alone[i][0].t) < 1e-7, qPrintable(place));
                    }
                }
            }
        }
    }

    /// Found by golden rays that all point in different directions: such a tile has no enclosure.
    void linesThatAreNoBundleAreSearchedToo() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            Expression result = sq(x) + sq(y) + sq(z) - 1;
            for (int k = 0; k < 10; ++k) result = min(result, sq(x - 0.1 * k) + sq(y) + sq(z) - 0.5);
            return result;
        });
        CertifiedRootFinder finder(tape, {}, {});
        std::vector<LineQuery> lines;
        for (int k = 0; k < 64; ++k) lines.push_back({{k % 2 ? 3 : -3, 0, 0}, {k % 2 ? -1 : 1, 0, 0}, 1, 5});
        std::vector<RootList> roots(lines.size());
        finder.find(lines, {}, roots);
        for (const RootList& found : roots) QVERIFY(!found.empty());
    }

    /// Beside a tile that is one, it has to be searched, too.
    void aTileThatIsNoBundleIsSearchedBesideOthers() {
        const auto tape = tapeOf([](auto x, auto y, auto z) {
            Expression result = x.number(10);
            for (int k = -10; k <= 10; ++k) result = min(result, sq(x - k) + sq(y) + sq(z) - 0.09);
            return result;
        });
        RootSettings settings;
        settings.open = true;
        CertifiedRootFinder finder(tape, {}, settings);
        std::vector<LineQuery> lines;
        for (int k = 0; k < 128; ++k)
            lines.push_back({{1e-3 * k, 0, -4}, {0, 0, k >= 64 && k % 2 ? -1 : 1}, 1, 6});
        std::vector<RootList> roots(lines.size());
        finder.find(lines, {}, roots);
        for (std::size_t i = 0; i < lines.size(); ++i)
            QCOMPARE(roots[i].size(), std::size_t(lines[i].direction.z > 0));
        QCOMPARE(finder.report().searches, std::uint64_t(lines.size()));
    }

    /// Where the sign is certain over half of a bundle's way, two enclosures pass it.
    void bundlesBeginWithHalfTheirWay() {
        const auto plane = tapeOf([](auto, auto, auto z) { return z + 10; });
        AffineEvaluator forms(plane, {});
        const test::LineTable table(parallelLines());
        CertainStarts starts(parallelLines().size());
        BundleMarch(TapeCost(*plane)).run(table.columns(), {}, forms, starts);
        QCOMPARE(forms.evaluations(), std::uint64_t(2 * 256 / (4 * BundleMarch::bundleLines)));
        for (std::size_t i = 0; i < 256; ++i) QCOMPARE(starts[i].start, 6.0);
    }

    /// Behind the start a piece is worth trying that holds most of the crossings, and no more.
    void whereALineIsLeftItsCrossingIsNear() {
        const auto plane = tapeOf([](auto, auto, auto z) { return 1 - z; });
        AffineEvaluator forms(plane, {});
        const test::LineTable table(parallelLines());
        CertainStarts starts(parallelLines().size());
        BundleMarch(TapeCost(*plane)).run(table.columns(), {}, forms, starts);
        for (std::size_t i = 0; i < 256; ++i) {
            QCOMPARE(starts[i].sign, 1.0);
            QVERIFY(starts[i].start < 5 && starts[i].start > 4.9);
            QVERIFY(starts[i].length > 0 && starts[i].start + starts[i].length < 5.1);
        }
    }

    void emptySpaceCostsLittle() {
        const auto tape = tapeOf([](auto x, auto y, auto z) { return sq(x) + sq(y) + sq(z) - 0.01; });
        RootSettings settings;
        settings.open = true;
        CertifiedRootFinder finder(tape, {}, settings);
        std::vector<LineQuery> lines;
        for (int k = 0; k < 1024; ++k) lines.push_back({{-3, 2, 1e-3 * k}, {1, 0, 0}, 0, 6});
        std::vector<RootList> roots(lines.size());
        finder.find(lines, {}, roots);
        QVERIFY(finder.report().evaluations <= lines.size() / BundleMarch::bundleLines * 3);
        for (const Verdict verdict : finder.verdicts()) QCOMPARE(verdict, Verdict::certifiedMiss);
    }

  private:
    /// 16 x 16 lines along z, a thousandth apart.
    static std::vector<LineQuery> parallelLines() {
        std::vector<LineQuery> lines;
        for (int k = 0; k < 256; ++k)
            lines.push_back({{1e-3 * (k % 16), 1e-3 * (k / 16), -4}, {0, 0, 1}, 0, 6});
        return lines;
    }
};

QTEST_APPLESS_MAIN(BundleMarchTest)
#include "bundle_march_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_kernel.h"

#include <QTest>

#include "core/evaluate/prepared_function.h"
#include "tests/roots/line_table.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using test::LineTable;
using test::tapeOf;

namespace {

/// Waves along x that no enclosure of more than one of them bounds, and along y a surface bent a little.
std::shared_ptr<const Tape> wavesAcrossASurface() {
    return tapeOf(
        [](auto x, auto y, auto) { return (sin(1e4 * x) * cos(1e4 * x) + 0.6) * (2 - y - 0.01 * sq(y)); });
}

/// One beside the other, from x = 0.1.
std::vector<LineQuery> lines(std::size_t count, const glm::dvec3& direction) {
    std::vector<LineQuery> result;
    for (std::size_t k = 0; k < count; ++k)
        result.push_back({{0.1, 0, 0.01 * static_cast<double>(k)}, direction, 0, 5});
    return result;
}

}  // namespace

class MarchKernelTest : public QObject {
    Q_OBJECT

  private slots:
    /// What a list has left over is told once.
    void everyRunBeginsAnew() {
        const RootSettings settings = open();
        AffineEvaluator forms(PreparedFunction::of(wavesAcrossASurface(), {}));
        MarchKernel march(forms, settings);
        const LineTable across(lines(10, {1, 0, 0})), along(lines(10, {0, 1, 0}));
        const CertainStarts starts(10);
        QCOMPARE(march.run(across.columns(), starts, 0, {}).rest.size(), std::size_t(10));
        const MarchKernel::Results& found = march.run(along.columns(), starts, 0, {});
        QVERIFY(found.rest.empty());
        QCOMPARE(found.crossings.size(), std::size_t(10));
    }

    void aResumedRunLeavesNoBrackets() {
        const RootSettings settings = open();
        AffineEvaluator forms(PreparedFunction::of(wavesAcrossASurface(), {}));
        MarchKernel march(forms, settings);
        std::vector<LineQuery> both = lines(10, {1, 0, 0});
        for (const LineQuery& line : lines(10, {0, 1, 0})) both.push_back(line);
        const LineTable table(both);
        const MarchKernel::Results& found = march.run(table.columns(), CertainStarts(20), 0, {}, true);
        QCOMPARE(found.brackets.size(), std::size_t(10));
        march.resume({});
        QVERIFY(found.brackets.empty());
        QCOMPARE(found.crossings.size(), std::size_t(10));
        QCOMPARE(found.rest.size(), std::size_t(10));
    }

  private:
    static RootSettings open() {
        RootSettings settings;
        settings.open = true;
        return settings;
    }
};

QTEST_APPLESS_MAIN(MarchKernelTest)
#include "march_kernel_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/rays/hit_batch.h"

#include <QTest>

using namespace isoscope;

namespace {

/// Row i is met at i + 1 with the normal (i, 2 i, 3 i), odd ones never.
HitBatch::Table tableOf(std::size_t rows) {
    HitBatch::Table table;
    table.reserve(rows);
    table.setSize(rows);
    for (std::size_t i = 0; i < rows; ++i) {
        const auto number = static_cast<double>(i);
        table[HitBatch::t][i] = i % 2 == 0 ? number + 1 : HitBatch::never;
        for (std::size_t c = 0; c < 3; ++c)
            table[HitBatch::normalX + c][i] = static_cast<double>(c + 1) * number;
    }
    return table;
}

}  // namespace

class HitBatchTest : public QObject {
    Q_OBJECT

  private slots:
    void takesAWholeTableWhereNothingIsKnown() {
        HitBatch hits;
        // Lists that grow and shrink, with what is left of the time before.
        for (const std::size_t rows : {std::size_t{5}, std::size_t{300}, std::size_t{11}}) {
            hits.reset(rows);
            HitBatch::Table table = tableOf(rows);
            QVERIFY(hits.takeWhole(table, HitKind::crossing));
            QCOMPARE(hits.size(), rows);
            for (std::size_t i = 0; i < rows; ++i) {
                QCOMPARE(hits.found(i), i % 2 == 0);
                if (!hits.found(i)) continue;
                const auto number = static_cast<double>(i);
                QCOMPARE(hits[HitBatch::t][i], number + 1);
                QCOMPARE(hits.normal(i), glm::dvec3(1, 2, 3) * number);
                QCOMPARE(hits.kind(i), HitKind::crossing);
                QCOMPARE(hits.material(i), noMaterial);
            }
            hits.setMaterial(3);
            QCOMPARE(hits.material(0), 3);
            hits.set(1, 0.5, {0, 0, 1}, HitKind::container, 2);
            QVERIFY(hits.found(1) && hits.kind(1) == HitKind::container && hits.material(1) == 2);
        }
    }

    void refusesATableWhereSomethingIsKnown() {
        HitBatch hits;
        HitBatch::Table table = tableOf(5);
        hits.reset(5);
        hits.limit(2, 1.5);
        QVERIFY(!hits.takeWhole(table, HitKind::crossing));
        hits.reset(5);
        hits.set(0, 0.5, {0, 0, 1}, HitKind::crossing, 1);
        QVERIFY(!hits.takeWhole(table, HitKind::crossing));
        QCOMPARE(hits[HitBatch::t][0], 0.5);
        hits.reset(6);
        QVERIFY(!hits.takeWhole(table, HitKind::crossing));
        hits.reset(5);
        QVERIFY(hits.takeWhole(table, HitKind::crossing));
        QVERIFY(!hits.takeWhole(table, HitKind::crossing));
    }
};

QTEST_APPLESS_MAIN(HitBatchTest)
#include "hit_batch_test.moc"

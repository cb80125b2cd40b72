// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/progressive/effect_budget.h"

#include <cmath>
#include <QTest>

using namespace isoscope;

namespace {

/// A picture of one CPU second.
RenderStatistics costs(double sky, double textures, double shadows) {
    RenderStatistics statistics;
    statistics.cpuSeconds = 1;
    statistics.stages = {{StageKind::primaryRays, "", 0, 0, 1 - sky - textures - shadows},
                         {StageKind::sky, "", 0, 0, sky},
                         {StageKind::textures, "", 0, 0, textures},
                         {StageKind::shadows, "", 0, 0, shadows}};
    return statistics;
}

StageSet setOf(std::initializer_list<StageKind> kinds) {
    StageSet set;
    for (const StageKind kind : kinds) set.set(kind, true);
    return set;
}

}  // namespace

class EffectBudgetTest : public QObject {
    Q_OBJECT

  private slots:
    void leavesOutTheDearestFirst() {
        EffectBudget budget;
        budget.note(0.5, costs(0.1, 0.2, 0.4));  // two threads
        for (const auto& [seconds, leftOut, left] :
             {std::tuple{0.5, setOf({}), 0.5}, std::tuple{0.49, setOf({StageKind::shadows}), 0.3},
              std::tuple{0.29, setOf({StageKind::shadows, StageKind::textures}), 0.2},
              std::tuple{0.01, setOf({StageKind::shadows, StageKind::textures, StageKind::sky}), 0.15}}) {
            budget.setSeconds(seconds);
            QVERIFY(budget.decide().leftOut == leftOut);
            QVERIFY(std::abs(budget.decide().seconds - left) < 1e-12);
        }
    }

    void keepsWhatSavesNextToNothing() {
        EffectBudget budget;
        budget.setSeconds(0.01);
        budget.note(1, costs(0.04, 0, 0.3));
        QVERIFY(budget.decide().leftOut == setOf({StageKind::shadows}));
    }

    void leavesNothingOutWithoutKnowledgeOrLimit() {
        EffectBudget budget;
        budget.setSeconds(0.01);
        QVERIFY(budget.decide().leftOut == StageSet());
        budget.note(1, costs(0.1, 0.1, 0.5));
        QVERIFY(budget.decide().leftOut != StageSet());
        for (const double none : {0.0, -1.0, std::nan("")}) {
            budget.setSeconds(none);
            QVERIFY(budget.decide().leftOut == StageSet());
        }
        budget.setSeconds(0.01);
        budget.note(std::nan(""), costs(0, 0, 0));  // tells nothing
        QVERIFY(budget.decide().leftOut != StageSet());
        budget.forget();
        QVERIFY(budget.decide().leftOut == StageSet());
    }
};

QTEST_APPLESS_MAIN(EffectBudgetTest)
#include "effect_budget_test.moc"

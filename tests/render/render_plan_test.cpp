// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/render_plan.h"

#include <QTest>
#include <algorithm>
#include <set>

#include "core/language/parse.h"
#include "core/render/render_statistics.h"
#include "tests/support/lighting_case.h"

using namespace isoscope;

namespace {

Scene litScene() {
    test::LightingCase item;
    item.lights.emplace_back().line = 12;
    return *test::sceneOf(item);
}

std::string reason(const std::vector<PlannedStage>& stages, StageKind kind) {
    for (const PlannedStage& stage : stages)
        if (stage.kind == kind) return stage.reason;
    return "not among them";
}

}  // namespace

class RenderPlanTest : public QObject {
    Q_OBJECT

  private slots:
    void shadowsNeedALightThatCastsAndAnObjectInTheWay() {
        Scene scene = litScene();
        const RenderPlan plan = makePlan(scene);
        QCOMPARE(reason(plan.stages, StageKind::shadows),
                 std::string("light_source at line 12 casts; 2 objects can occlude"));

        scene.objects[0].castsShadow = false;
        QCOMPARE(reason(makePlan(scene).stages, StageKind::shadows),
                 std::string("light_source at line 12 casts; 1 object can occlude"));
        scene.objects[1].castsShadow = false;
        QVERIFY(!makePlan(scene).has(StageKind::shadows));
        QCOMPARE(reason(makePlan(scene).notCalledFor, StageKind::shadows),
                 std::string("every object is no_shadow"));

        scene = litScene();
        scene.lights[0].shadowless = true;
        QCOMPARE(reason(makePlan(scene).notCalledFor, StageKind::shadows),
                 std::string("every light is shadowless"));
        scene.lights.clear();
        QCOMPARE(reason(makePlan(scene).notCalledFor, StageKind::shadows), std::string("there is no light"));
        QVERIFY(makePlan(scene).has(StageKind::directLight));  // ambient and emission
    }

    void anEmptySceneIsBackgroundAlone() {
        const RenderPlan plan = makePlan(Scene());
        QCOMPARE(plan.stages.size(), std::size_t{1});
        QVERIFY(plan.has(StageKind::background));
        QCOMPARE(plan.notCalledFor.size(), stageKindCount - 1);
        QCOMPARE(reason(plan.notCalledFor, StageKind::primaryRays),
                 std::string("there is no visible object"));
    }

    /// Descriptions are written by the example of others: each must have its own name.
    void eachEffectIsListedOnceInItsOrder() {
        std::set<std::string> names;
        for (std::size_t i = 0; i < stageKindCount; ++i)
            QVERIFY(names.insert(name(static_cast<StageKind>(i))).second);
        const RenderPlan plan = makePlan(litScene());
        for (const auto* list : {&plan.stages, &plan.notCalledFor})
            QVERIFY(
                std::is_sorted(list->begin(), list->end(),
                               [](const PlannedStage& a, const PlannedStage& b) { return a.kind < b.kind; }));
        QVERIFY(plan.stages.size() > 1 && plan.notCalledFor.size() > 1);
    }

    void aStageIsPlannedLeftOutOrNotCalledFor() {
        Scene scene = litScene();
        StageSet all;
        for (std::size_t i = 0; i < stageKindCount; ++i) all.set(static_cast<StageKind>(i), true);
        const RenderPlan plan = makePlan(scene, all);
        QVERIFY(!plan.has(StageKind::shadows));
        QCOMPARE(reason(plan.leftOut, StageKind::shadows),
                 std::string("light_source at line 12 casts; 2 objects can occlude"));
        for (const PlannedStage& stage : plan.leftOut) QVERIFY(canBeLeftOut(stage.kind));
        for (const PlannedStage& stage : plan.stages) QVERIFY(!canBeLeftOut(stage.kind));
        QCOMPARE(plan.stages.size() + plan.leftOut.size() + plan.notCalledFor.size(), stageKindCount);
        // What the scene does not call for is not called left out.
        scene.lights.clear();
        QCOMPARE(reason(makePlan(scene, all).notCalledFor, StageKind::shadows),
                 std::string("there is no light"));
    }

    void saysWhatGlassLooksLikeWhenItIsLeftOut() {
        const ParseResult parsed =
            parseScene("sphere { 0, 1\npigment { rgbt 1 } interior { ior 1.5 } } light_source { 9, 1 }");
        StageSet glass;
        for (const StageKind kind : {StageKind::transparency, StageKind::refraction, StageKind::clearShadows})
            glass.set(kind, true);
        const RenderPlan plan = makePlan(*parsed.scene, glass);
        QCOMPARE(
            reason(plan.leftOut, StageKind::transparency),
            std::string("sphere at line 1 lets light through; 1 object in all; without it these objects are "
                        "drawn as opaque, and nothing is refracted"));
        QCOMPARE(reason(plan.leftOut, StageKind::refraction),
                 std::string("sphere at line 1 has an ior; 1 object in all; without it light goes straight "
                             "through"));
        QVERIFY(reason(plan.leftOut, StageKind::clearShadows)
                    .ends_with("; without it these objects cast no shadow"));
        // Not of stages that run.
        QCOMPARE(reason(makePlan(*parsed.scene).stages, StageKind::refraction),
                 std::string("sphere at line 1 has an ior; 1 object in all"));
    }

    void warnsOfMaxGradientAsPovrayDoes() {
        const auto warning = [](double setting, double steepest) {
            return gradientWarning({setting, steepest, 100});
        };
        const std::string holes = "may have holes";
        const std::string slow = "may be faster";
        // Holes: M/F <= 0.9 and F - M >= 0.5, or M < 10 and (M/F <= 0.95 or F - M >= 0.1).
        QVERIFY(warning(20, 23).find(holes) != std::string::npos);
        QVERIFY(warning(20, 22).empty());  // 0.909
        QVERIFY(warning(1.1, 1.16).find(holes) != std::string::npos);
        QVERIFY(warning(1.1, 1.15).empty());  // 0.957 and only 0.05
        QVERIFY(warning(9, 9.2).find(holes) != std::string::npos);
        QVERIFY(warning(11, 11.2).empty());
        // Wasteful: M - F >= 10, or M/F >= 1.1 and M - F >= 0.5.
        QVERIFY(warning(200, 190).find(slow) != std::string::npos);
        QVERIFY(warning(3, 2.5).find(slow) != std::string::npos);
        QVERIFY(warning(3, 2.6).empty());
        QVERIFY(warning(100, 95).empty());
        // Nothing was met, or nonsense.
        QVERIFY(warning(3, 0).empty());
        QVERIFY(warning(3, std::nan("")).empty());
        QVERIFY(warning(std::nan(""), 3).empty());
    }
};

QTEST_APPLESS_MAIN(RenderPlanTest)
#include "render_plan_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/accuracy/scene_likeness.h"

#include <QTest>

#include "tests/support/study_scene.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Scene> scene(const std::string& text) { return studyScene(text).scene; }

const std::string first = "isosurface { function { x*x + y - 0.3 } accuracy 0.01 max_gradient 2 }\n";

}  // namespace

class SceneLikenessTest : public QObject {
    Q_OBJECT

  private slots:
    void aloneTheSettingMayDiffer() {
        const auto finer = scene("isosurface { function { x*x + y - 0.3 } accuracy 0.001 max_gradient 2 }\n");
        QVERIFY(sameButFor(StudiedSetting::accuracy, *scene(first), *finer));
        QVERIFY(!sameButFor(StudiedSetting::maxGradient, *scene(first), *finer));
        const auto higher = scene("isosurface { function { x*x + y - 0.3 } accuracy 0.01 max_gradient 3 }\n");
        QVERIFY(!sameButFor(StudiedSetting::accuracy, *scene(first), *higher));
        QVERIFY(sameButFor(StudiedSetting::maxGradient, *scene(first), *higher));
    }

    void anotherFunctionIsSeenEvenBehindTheSameText() {
        const auto called = [](const char* number) {
            return scene("#declare F = function { x*x + y - " + std::string(number) +
                         " }\nisosurface { function { F(x, y, z) } }\n");
        };
        QVERIFY(sameButFor(StudiedSetting::accuracy, *called("0.3"), *called("0.3")));
        QVERIFY(!sameButFor(StudiedSetting::accuracy, *called("0.3"), *called("0.4")));
    }

    void placeContainerAndCompanyCount() {
        const auto same = scene(first);
        QVERIFY(!sameButFor(
            StudiedSetting::accuracy, *same,
            *scene("isosurface { function { x*x + y - 0.3 } accuracy 0.01 max_gradient 2 translate x }\n")));
        QVERIFY(!sameButFor(StudiedSetting::accuracy, *same,
                            *scene("isosurface { function { x*x + y - 0.3 } accuracy 0.01 max_gradient 2 "
                                   "contained_by { sphere { 0, 1 } } }\n")));
        QVERIFY(!sameButFor(StudiedSetting::accuracy, *same, *scene(first + "sphere { 0, 1 }\n")));
        QVERIFY(
            sameButFor(StudiedSetting::accuracy, *scene("sphere { 0, 1 }\n"), *scene("sphere { 0, 1 }\n")));
    }

    void undefinedFunctionsAreLikeThemselves() {
        const auto undefined = scene("isosurface { function { sqrt(-1 - x*x) } }\n");
        QVERIFY(sameButFor(StudiedSetting::accuracy, *undefined, *undefined));
    }
};

QTEST_APPLESS_MAIN(SceneLikenessTest)
#include "scene_likeness_test.moc"

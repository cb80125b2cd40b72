// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/formulas/difference_text.h"

#include <cmath>
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

ParseResult parsed(const std::string& isosurface) {
    return parseScene("#version 3.7;\n#include \"functions.inc\"\n" + isosurface);
}

DifferenceText difference(const ParseResult& a, const ParseResult& b) {
    return differenceText(*a.scene->isosurfaces.at(0).shape, *a.scene->parameterTable,
                          *b.scene->isosurfaces.at(0).shape, *b.scene->parameterTable);
}

double valueOf(const ParseResult& scene, double x, double y, double z) {
    const Isosurface& surface = *scene.scene->isosurfaces.at(0).shape;
    return PointEvaluator(surface.prepared(*scene.scene->parameterTable)).evaluate(x, y, z) -
           surface.settings().threshold;
}

}  // namespace

class DifferenceTextTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsOneFunctionLessTheOther() {
        const ParseResult a = parsed(
            "isosurface { function { f_torus(x,y,z,0.8,0.2) } threshold 0.1 contained_by { box { -1, 1 } } "
            "max_gradient 2 }");
        const ParseResult b = parsed(
            "isosurface { function { x*x + y*y + z*z - 1 } threshold -0.3 contained_by { sphere { 1, 1.5 } } "
            "max_gradient 4 }");
        const DifferenceText text = difference(a, b);
        QVERIFY2(text.problem.empty(), text.problem.c_str());
        const ParseResult whole = parsed(text.text);
        QVERIFY2(whole.ok(), text.text.c_str());
        for (const double at : {-0.7, 0.1, 0.4})
            QVERIFY(std::abs(valueOf(whole, at, 0.3, -at) -
                             (valueOf(a, at, 0.3, -at) - valueOf(b, at, 0.3, -at))) < 1e-12);
        const IsosurfaceSettings& settings = whole.scene->isosurfaces[0].shape->settings();
        QCOMPARE(settings.maxGradient, 6.0);
        const Bounds box = whole.scene->isosurfaces[0].shape->bounds();
        QVERIFY(box.low == glm::dvec3(-1) && box.high == glm::dvec3(2.5));
    }

    void noiseHasNoFormula() {
        const ParseResult a = parsed("isosurface { function { f_noise3d(x,y,z) } }");
        QVERIFY(difference(a, a).text.empty());
        QVERIFY(difference(a, a).problem.ends_with('.'));
    }
};

QTEST_MAIN(DifferenceTextTest)
#include "difference_text_test.moc"

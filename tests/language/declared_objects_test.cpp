// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>
#include <QTest>

#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

Color colorOf(const Material& material) { return std::get<SolidPigment>(material.pigment).color; }

}  // namespace

/// Names of declared objects and lights, and elements of arrays, in the places of what they stand for.
class DeclaredObjectsTest : public QObject {
    Q_OBJECT

  private slots:
    void elementsOfArraysStandForNames() {
        const ParseResult parsed = parseScene(R"(
#declare Colors = array[2] { rgb <1, 0, 0>, rgb <0, 1, 0> }
#declare Textures = array[2] { texture { pigment { rgb 0.25 } }, texture { pigment { rgb 0.75 } } }
#declare Things = array[2] { sphere { 0, 1 }, box { 0, 1 } }
object { Things[1] texture { Textures[1] } }
object { Things[0] pigment { Colors[1] } }
)");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const Scene& scene = *parsed.scene;
        QCOMPARE(scene.objects.at(0).name, std::string("box"));
        QCOMPARE(colorOf(scene.materials.at(std::size_t(scene.objects[0].material))).red, 0.75);
        QCOMPARE(colorOf(scene.materials.at(std::size_t(scene.objects[1].material))).green, 1.0);
    }

    /// They were mistakes; macros often end with one.
    void namesOfObjectsStandAlone() {
        const ParseResult parsed = parseScene(R"(
#declare Ball = sphere { 2*x, 1 pigment { rgb 0.25 } }
#declare Lamp = light_source { <1, 0, 0>, 1 }
#macro Moved(A) object { Ball translate A } #end
#macro Same() Ball #end
Ball Lamp
union { box { 8, 9 } Ball Lamp translate y }
Same()
difference { box { -9, 9 } Same() Ball Moved(z) }
light_group { Ball Lamp }
)");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        const Scene& scene = *parsed.scene;
        QCOMPARE(scene.objects.size(), std::size_t(6));
        QCOMPARE(scene.lights.size(), std::size_t(3));
        QVERIFY(glm::length(scene.lights[1].location - glm::dvec3(1, 1, 0)) < 1e-12);
        QCOMPARE(scene.objects[0].shape->bounds().high, glm::dvec3(3, 1, 1));
        QCOMPARE(colorOf(scene.materials.at(std::size_t(scene.objects[0].material))).red, 0.25);
        QCOMPARE(scene.objects[2].shape->bounds().high, glm::dvec3(3, 2, 1));
        TraceContext context;
        QVERIFY(!scene.objects[4].shape->contains({2, 0, 0}, context));
        QVERIFY(!scene.objects[4].shape->contains({2, 0, 1.9}, context));
        QVERIFY(scene.objects[4].shape->contains({2, 0, 2.1}, context));
    }

    void lightsInsideObjectsMoveWithThem() {
        const ParseResult parsed = parseScene(
            "#declare L = light_source { <1, 0, 0>, 1 }\nunion { sphere { 0, 1 } light_source { L } "
            "translate y }\n"
            "object { L rotate 90*z }");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QCOMPARE(parsed.scene->lights.size(), std::size_t(2));
        QVERIFY(glm::length(parsed.scene->lights[0].location - glm::dvec3(1, 1, 0)) < 1e-12);
        QVERIFY(glm::length(parsed.scene->lights[1].location - glm::dvec3(0, 1, 0)) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(DeclaredObjectsTest)
#include "declared_objects_test.moc"

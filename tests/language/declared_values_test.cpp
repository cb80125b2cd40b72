// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/directives/definition_reader.h"

#include <glm/geometric.hpp>
#include <QTest>

#include "tests/language/stream_run.h"
#include "tests/support/problems.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

Color colorOf(const Material& material) { return std::get<SolidPigment>(material.pigment).color; }

/// `name=value 'text of the range' slot` of every parameter; `-` for a slot that was taken away.
std::string sliders(const ParseContext& context) {
    std::string all;
    for (const SceneParameter& parameter : context.parameters)
        all += (all.empty() ? "" : "; ") + parameter.name + "=" + shortest(parameter.value) + " '" +
               std::string(context.sources.slice(parameter.range)) + "' " +
               (parameter.slot < 0 ? "-" : std::to_string(parameter.slot));
    return all;
}

}  // namespace

class DeclaredValuesTest : public QObject {
    Q_OBJECT

    static void row(const char* text, const char* found) {
        QTest::newRow(text) << QString(text) << QString(found);
    }

  private slots:
    void findsSliders_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("found");
        row("#declare R = 2;", "R=2 '2' 0");
        row("#declare R = -1.5;", "R=-1.5 '-1.5' 0");
        row("#declare R = - 3;", "R=-3 '- 3' 0");
        row("#declare R = +3;", "R=3 '+3' 0");
        row("#declare R = (2);", "R=2 '2' 0");
        row("#declare R = 2", "R=2 '2' 0");
        row("#declare A = 1; #declare B = 2;", "A=1 '1' 0; B=2 '2' 1");
        row("#declare A = 1, B = 2;", "A=1 '1' 0; B=2 '2' 1");
        row("#if (1) #declare R = 2; #end", "R=2 '2' 0");
        row("union { #declare R = 2; }", "R=2 '2' 0");
        row("#declare R = --2;", "");
        row("#declare R = !2;", "");
        row("#declare R = 1 + 1;", "");
        row("#declare R = pi;", "");
        row("#declare R = <1, 2, 3>;", "");
        row("#declare R = \"1\";", "");
        row("#local R = 2;", "");
        row("#for (I, 1, 2) #declare R = 2; #end", "");
        row("#macro M() #declare R = 2; #end M()", "");
        row("#macro M(P) #declare R = P; #end M(2)", "");
        row("#declare V = array[1]; #declare V[0] = 2;", "");
        row("#declare V = x; #declare V.y = 2;", "");
    }
    void findsSliders() { check(); }

    /// Whether a parse is needed to follow a change; a copy of the name alone does not ask for one.
    void tellsWhatNeedsANewParse_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("found");
        row("#declare S = R;", "R=2 '2' 0");
        row("#declare S = (R);", "R=2 '2' 0");
        row("#macro M(P) #end M(R)", "R=2 '2' 0");
        row("#macro M(P) #end M((R))", "R=2 '2' 0");
        row("#ifdef (R) #end", "R=2 '2' 0");
        row("#declare S = R; #declare T = S*2;", "R=2 '2' -");
        row("#declare S = R*2;", "R=2 '2' -");
        row("#declare S = 2 - R;", "R=2 '2' -");
        row("#declare S = -R;", "R=2 '2' -");
        row("#declare S = <R, 0, 0>;", "R=2 '2' -");
        row("#declare S = sin(R);", "R=2 '2' -");
        row("#declare S = str(R, 0, 3);", "R=2 '2' -");
        row("#declare S = rgb R;", "R=2 '2' -");
        row("#declare S = color red R;", "R=2 '2' -");
        row("#declare S = (R > 1);", "R=2 '2' -");
        row("#declare S = (1 ? R : 0);", "R=2 '2' -");
        row("#declare S = array[R];", "R=2 '2' -");
        row("#declare S = array[1] { R }", "R=2 '2' -");
        row("#declare S = array[1]; #declare S[0] = R;", "R=2 '2' -");
        row("#declare S = x; #declare S.y = R;", "R=2 '2' -");
        row("#if (R) #end", "R=2 '2' -");
        row("#while (R > 5) #end", "R=2 '2' -");
        row("#for (I, 0, R) #end", "R=2 '2' -");
        row("#switch (R) #end", "R=2 '2' -");
        row("#version R;", "R=2 '2' -");
    }

    void tellsWhatNeedsANewParse() {
        QFETCH(QString, text);
        QFETCH(QString, found);
        const StreamRun done = run("#declare R = 2; " + text.toStdString());
        QCOMPARE(QString::fromStdString(sliders(*done.context)), found);
    }

    void aFunctionCalledWhileParsingFixesItsParameters() {
        ParseContext context{ParseOptions{}};
        for (const double value : {5.0, 7.0}) {
            SceneParameter parameter;
            parameter.value = value;
            context.addParameter(parameter);
        }
        FunctionGraph graph;
        const NodeId sum = graph.binary(Operation::add, graph.variable(0), graph.parameter(1));
        context.symbols.declare("F", {FunctionValue{finish(std::move(graph), {sum}, 1), {"a"}, ""}});
        TokenStream tokens(context, context.sources.add("scene.pov", "F(1)"));
        QCOMPARE(ExpressionParser(tokens).parseFloat(), 8.0);
        QCOMPARE(context.parameters[0].slot, 0);
        QCOMPARE(context.parameters[1].slot, -1);
    }

    void theValueKnowsItsParameter() {
        const StreamRun done = run("#declare Q = 1; #declare R = 2; #declare S = R; #declare T = R + 0;");
        const auto parameterOf = [&](const char* name) {
            return std::get<NumberValue>(done.context->symbols.find(name)->data).parameter;
        };
        QCOMPARE(parameterOf("Q"), 0);
        QCOMPARE(parameterOf("R"), 1);
        QCOMPARE(parameterOf("S"), 1);
        QCOMPARE(parameterOf("T"), -1);
        QCOMPARE(done.context->parameterTable, (std::vector<double>{1, 2}));
        const SceneParameter& slider = done.context->parameters[1];
        QVERIFY(slider.role == ParameterRole::declared);
        QCOMPARE(slider.group, std::string("#declare"));
        QCOMPARE(slider.text, std::string("2"));
        QCOMPARE(slider.minimum, 0.0);
        QCOMPARE(slider.maximum, 8.0);
    }

    void parseNumberTellsTheParameter() {
        ParseContext context{ParseOptions{}};
        TokenStream tokens(context, context.sources.add("scene.pov", "#declare R = 2; R (R + 1)"));
        QCOMPARE(ExpressionParser(tokens).parseNumber().parameter, 0);
        QCOMPARE(ExpressionParser(tokens).parseNumber().parameter, -1);
    }

  private:
    void check() {
        QFETCH(QString, text);
        QFETCH(QString, found);
        QCOMPARE(QString::fromStdString(sliders(*run(text.toStdString()).context)), found);
    }

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

QTEST_APPLESS_MAIN(DeclaredValuesTest)
#include "declared_values_test.moc"

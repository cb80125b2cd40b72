// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/object_queries.h"

#include <QTest>

#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// The three components of the declared vector `name`, or of a float three times.
glm::dvec3 vectorOf(const ParseResult& parsed, const std::string& name) {
    const Value* value = parsed.symbols->find(name);
    if (!value) return glm::dvec3(-1e9);
    if (const auto* number = std::get_if<NumberValue>(&value->data)) return glm::dvec3(number->value);
    const auto& c = std::get<VectorValue>(value->data).components;
    return {c[0], c[1], c[2]};
}

bool near(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-9; }

}  // namespace

class ObjectQueriesTest : public QObject {
    Q_OBJECT

  private slots:
    void traceFindsTheFirstHitAndItsNormal() {
        const ParseResult parsed = parseScene(
            "#declare S = union { sphere { 0, 1 } box { <2, -1, -1>, <3, 1, 1> } translate y }\n"
            "#declare N = <9, 9, 9>;\n#declare P = trace(S, <-5, 1, 0>, 2*x, N);\n"
            "#declare Q = trace(S, <1.5, 1, 0>, x, M);\n"
            "#declare Miss = trace(S, <-5, 9, 0>, x, None);\n");
        QVERIFY2(parsed.ok(), problems(parsed).c_str());
        QVERIFY(near(vectorOf(parsed, "P"), {-1, 1, 0}) && near(vectorOf(parsed, "N"), {-1, 0, 0}));
        QVERIFY(near(vectorOf(parsed, "Q"), {2, 1, 0}) && near(vectorOf(parsed, "M"), {-1, 0, 0}));
        QVERIFY(near(vectorOf(parsed, "Miss"), glm::dvec3(0)) &&
                near(vectorOf(parsed, "None"), glm::dvec3(0)));
    }

    void traceLeavesTheSurfaceItStartsFrom() {
        const ParseResult parsed =
            parseScene("#declare S = sphere { 0, 1 }\n#declare P = trace(S, -x, x);\n");
        QVERIFY(near(vectorOf(parsed, "P"), {1, 0, 0}));
    }

    void insideAndExtents() {
        const ParseResult parsed = parseScene(
            "#declare S = difference { cylinder { 0, 2*y, 1 } sphere { 2*y, 0.5 } scale <2, 1, 1> }\n"
            "#declare In = inside(S, <1.9, 1, 0>);\n#declare Out = inside(S, <0, 1.9, 0>);\n"
            "#declare Low = min_extent(S);\n#declare High = max_extent(S);\n"
            "#declare Wide = max_extent(plane { y, 3 });\n#declare Floor = plane { y, 3 }\n"
            "#declare Endless = max_extent(Floor);\n");
        QCOMPARE(vectorOf(parsed, "In").x, 1.0);
        QCOMPARE(vectorOf(parsed, "Out").x, 0.0);
        QVERIFY(near(vectorOf(parsed, "Low"), {-2, 0, -1}) && near(vectorOf(parsed, "High"), {2, 2, 1}));
        QVERIFY(near(vectorOf(parsed, "Endless"), {1e10, 3, 1e10}));
        // Objects must be declared, as in POV-Ray.
        QVERIFY(!parsed.ok());
        QCOMPARE(parsed.diagnostics.at(0).id, std::string("no-object"));
    }

    void askingTheSlidersOfAnIsosurfaceMakesThemStructural() {
        const std::string text =
            "#declare S = isosurface { function { f_sphere(x, y, z, 0.8) } contained_by { box { -2, 2 } } "
            "}\n";
        const ParseResult plain = parseScene("#include \"functions.inc\"\n" + text);
        const ParseResult asked =
            parseScene("#include \"functions.inc\"\n" + text + "#declare P = trace(S, -3*x, x);\n");
        QVERIFY(plain.ok() && asked.ok());
        const auto slotCount = [](const ParseResult& parsed) {
            int count = 0;
            for (const SceneParameter& parameter : parsed.scene->parameters) count += parameter.slot >= 0;
            return count;
        };
        QVERIFY(slotCount(plain) > slotCount(asked));
        QVERIFY(glm::length(vectorOf(asked, "P") - glm::dvec3(-0.8, 0, 0)) < 0.01);
    }

    void theStepBudgetEndsEndlessTracing() {
        ParseOptions options;
        options.stepBudget = 200'000;
        const ParseResult parsed = parseScene(
            "#declare S = isosurface { function { sin(30*x)*sin(30*y)*sin(30*z) - 0.99 } contained_by { box "
            "{ -2, 2 } } "
            "max_gradient 60 accuracy 1e-6 }\n#declare I = 0;\n#while (I < 1000000)\n"
            "#declare P = trace(S, <-3, 0.0001*I, 0.3>, x);\n#declare I = I + 1;\n#end\n",
            options);
        QVERIFY(!parsed.ok());
    }
};

QTEST_APPLESS_MAIN(ObjectQueriesTest)
#include "object_queries_test.moc"

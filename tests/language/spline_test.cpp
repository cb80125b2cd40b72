// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/language/expressions/spline.h"

#include <cmath>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/parse.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// A component of the vector that `expression` has behind `prelude`.
double componentOf(const std::string& prelude, const std::string& expression, std::size_t component) {
    const ParseResult parsed =
        parseScene("#version 3.7;\n" + prelude + "\n#declare R = " + expression + ";\n");
    if (!parsed.ok()) qWarning("%s", problems(parsed).c_str());
    const Value* value = parsed.symbols->find("R");
    const auto* vector = value ? std::get_if<VectorValue>(&value->data) : nullptr;
    return vector ? vector->components[component] : std::nan("");
}

const std::string natural =
    "#declare S = spline { natural_spline 0, <0, 0, 0> 0.5, <1, 1, 0> 1, <2, 1, 1> 1.5, <3, 0, 3> }";

bool near(double a, double b) { return std::abs(a - b) < 1e-6; }

}  // namespace

class SplineTest : public QObject {
    Q_OBJECT

  private slots:
    /// The numbers are POV-Ray's.
    void declaredSplinesAreCalled() {
        QVERIFY(near(componentOf(natural, "S(1.1)", 0), 2.2));
        QVERIFY(near(componentOf(natural, "S(1.1)", 1), 0.8576));
        QVERIFY(near(componentOf(natural, "S(1.1)", 2), 1.3424));
        QVERIFY(near(componentOf(natural, "S(0.9)", 2), 0.704));
    }

    void commasMayBeLeftOut() {
        QVERIFY(near(componentOf("#declare S = spline { 0 <0 0 0> 1 <2 4 6> }", "S(0.5)", 2), 3));
    }

    void theTypeCanBeGivenInTheCall() {
        QVERIFY(near(componentOf(natural, "S(1.25, linear_spline)", 2), 2));
        QVERIFY(near(componentOf(natural + " #declare T = spline { S, linear_spline }", "T(1.25)", 2), 2));
    }

    void aSplineExtendsAnother() {
        const std::string more = natural + " #declare T = spline { S, 2, <9, 9, 9> }";
        QVERIFY(near(componentOf(more, "T(2)", 0), 9));
        QVERIFY(near(componentOf(natural, "S(2)", 0), 3));
        // It has as many components.
        QVERIFY(near(componentOf(natural + " #declare T = spline { S }", "<T(1.5).z, 0, 0>", 0), 3));
    }

    void arraysHoldSplines() {
        QVERIFY(near(componentOf(natural + " #declare A = array[1] { S }", "A[0](1.1)", 1), 0.8576));
    }

    void splineTransFollowsTheCurve() {
        const std::string prelude = natural + "\n#include \"transforms.inc\"\n";
        const char* call = "vtransform(x, transform { Spline_Trans(S, 1.1, y, 0.2, 1) })";
        QVERIFY(near(componentOf(prelude, call, 0), 3.105103));
        QVERIFY(near(componentOf(prelude, call, 1), 0.940738));
        QVERIFY(near(componentOf(prelude, call, 2), 0.925416));
    }

    /// The nodes of a function are the same curve as a call.
    void functionsAgreeWithCalls() {
        for (const SplineType type :
             {SplineType::linear, SplineType::quadratic, SplineType::cubic, SplineType::natural}) {
            std::vector<Spline::Point> points;
            for (int i = 0; i < 7; ++i)
                points.push_back({0.7 * i - 2, {std::sin(i), std::cos(2.0 * i), 0, 0, 0}});
            const Spline spline(type, points, 2);
            FunctionGraph graph;
            const NodeId place = graph.variable(0);
            std::vector<NodeId> results = spline.build(graph, place);
            ReferenceEvaluator evaluator(finish(std::move(graph), std::move(results), 1));
            for (double s = -3; s < 4; s += 0.0625)
                for (std::size_t c = 0; c < 2; ++c)
                    QVERIFY(std::abs(evaluator.evaluate(std::vector<double>{s}, {}, c) - spline.at(s)[c]) <
                            1e-12);
        }
    }

    void mistakesAreTold() {
        const auto firstProblem = [](const std::string& text) {
            const ParseResult parsed = parseScene(text);
            return parsed.diagnostics.empty() ? QString()
                                              : QString::fromStdString(parsed.diagnostics[0].message);
        };
        QCOMPARE(firstProblem("#declare S = spline { }"), QString("A spline needs at least one point."));
        QCOMPARE(firstProblem("#declare S = spline { 0, \"a\" }"),
                 QString("The points of a spline are floats or vectors."));
        QCOMPARE(firstProblem("#declare S = spline { 0, x }\n#declare R = S(1, 2);"),
                 QString("Expected the type of spline, but found `2`."));
    }

    void hostilePointsDoNoHarm() {
        const Spline once(SplineType::natural, {{1, {1}}, {1, {2}}, {1, {3}}}, 1);
        QCOMPARE(once.at(5)[0], 3.0);
        for (const SplineType type : {SplineType::quadratic, SplineType::cubic, SplineType::natural})
            Spline(type, {{0, {1}}, {1e-300, {2}}, {1e300, {INFINITY}}, {NAN, {0}}}, 1).at(0.5);
    }
};

QTEST_APPLESS_MAIN(SplineTest)
#include "spline_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/formulas/derivative_text.h"

#include <cmath>
#include <QTest>
#include <random>

#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/point_evaluator.h"
#include "core/function/derivative.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::shared_ptr<const Isosurface> isosurfaceOf(const std::string& function,
                                               const std::string& settings = {}) {
    const ParseResult parsed =
        parseScene("#version 3.7; #include \"functions.inc\"\nisosurface { function { " + function +
                   " } contained_by { box { -1, 1 } } " + settings + " }\n");
    if (!parsed.ok()) qCritical("%s", parsed.diagnostics.front().message.c_str());
    return parsed.scene->isosurfaces.at(0).shape;
}

/// What a declared function of the text is at a point.
double valueIn(const std::string& declarations, const std::string& call) {
    const ParsedFunction parsed = parseFunction(call, declarations);
    if (!parsed.ok()) qCritical("%s", parsed.diagnostics.front().message.c_str());
    PointEvaluator values(Tape::compile(parsed.value.function), parsed.parameterTable);
    return values.evaluate(0.3, -0.2, 0.45);
}

}  // namespace

class DerivativeTextTest : public QObject {
    Q_OBJECT

  private slots:
    /// min() takes its second value there, max() its first.
    void anUndefinedSideHasNoPart() {
        for (const char* function : {"min(sqrt(x), y)", "max(y, sqrt(x))"}) {
            const GradientFunction gradient = gradientOf(isosurfaceOf(function)->settings().function);
            PointEvaluator values(Tape::compile(gradient.function), {});
            const double x = -0.5, y = 0.2, z = 0.1;
            for (std::size_t k = 1; k < 4; ++k) {
                double found = -1;
                values.evaluate(std::span(&x, 1), std::span(&y, 1), std::span(&z, 1), std::span(&found, 1),
                                k);
                QCOMPARE(found, k == 2 ? 1.0 : 0.0);
            }
        }
    }

    /// Beside forward differentiation by the evaluator, for each operation with a formula.
    void formulasAreTheSlopes_data() {
        QTest::addColumn<QString>("function");
        for (const char* function :
             {"x*y - z/(2 + x)", "sqrt(1.5 + x)*exp(y)", "ln(2 + x) + log(3 + y*z)", "sin(x*3)*cos(y)*tan(z)",
              "asin(x) + acos(y) + atan(z)", "sinh(x) + cosh(y)*tanh(z)",
              "asinh(x) + acosh(2 + y) + atanh(z)", "abs(x - 0.1) + min(x, y, z) + max(x*2, y)",
              "pow(2 + x, 3) + pow(2 + y, z)", "atan2(x + 2, y)", "mod(x + 5, 0.7 + y/10)",
              "select(x, y, z*z)", "select(x, y, z, z*x)", "floor(x*3) + int(y*4) + z", "(x < y)*z",
              "f_torus(x, y, z, 0.5, 0.2)", "f_superellipsoid(x, y, z, 0.6, 0.7)", "f_heart(x, y, z, 1)",
              "f_klein_bottle(x, y, z, 1)"})
            QTest::newRow(function) << function;
    }
    void formulasAreTheSlopes() {
        QFETCH(QString, function);
        const auto surface = isosurfaceOf(function.toStdString());
        const GradientFunction gradient = gradientOf(surface->settings().function);
        QVERIFY(gradient.function.valid() && !gradient.missing);
        const unsigned seed = 20;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-0.9, 0.9);
        const ParseResult parsed =
            parseScene("#version 3.7; #include \"functions.inc\"\nisosurface { function { " +
                       function.toStdString() + " } contained_by { box { -1, 1 } } }\n");
        const std::vector<double>& parameters = *parsed.scene->parameterTable;
        PointEvaluator values(Tape::compile(gradient.function), parameters);
        GradientEvaluator slopes(surface->tape(), parameters);
        for (int i = 0; i < 200; ++i) {
            const double x = number(random), y = number(random), z = number(random);
            const ValueAndGradient expected = slopes.evaluate(x, y, z);
            for (std::size_t k = 0; k < 4; ++k) {
                double found = 0;
                values.evaluate(std::span(&x, 1), std::span(&y, 1), std::span(&z, 1), std::span(&found, 1),
                                k);
                const double wanted = k == 0 ? expected.value : expected.gradient[k - 1];
                if (std::isnan(found) && k > 0) continue;
                QVERIFY2(std::abs(found - wanted) <= 1e-9 * std::max(1.0, std::abs(wanted)),
                         qPrintable(QString("result %1 at %2 %3 %4: %5, not %6; seed %7")
                                        .arg(k)
                                        .arg(x)
                                        .arg(y)
                                        .arg(z)
                                        .arg(found)
                                        .arg(wanted)
                                        .arg(seed)));
            }
        }
    }

    void noiseHasNoFormula() {
        const GradientFunction gradient = gradientOf(isosurfaceOf("f_noise3d(x,y,z)")->settings().function);
        QVERIFY(!gradient.function.valid());
        QCOMPARE(gradient.missing, std::optional(Operation::noise));
        const DerivativeText text = derivativeText(*isosurfaceOf("f_noise3d(x,y,z) + x"), {});
        QVERIFY(text.declarations.empty());
        QCOMPARE(text.problem, std::string("There is no formula for the derivative of `noise`."));
        // Noise that does not move needs none.
        QVERIFY(gradientOf(isosurfaceOf("f_noise3d(1,2,3) + x")->settings().function).function.valid());
    }

    void theTextSaysTheSame() {
        const auto surface = isosurfaceOf("sqrt(x*x + y*y*3 + 0.1)*sin(z*3 + x) - z*z", "threshold 0.2");
        const DerivativeText text = derivativeText(*surface, {}, "shape");
        QVERIFY2(text.problem.empty(), text.problem.c_str());
        GradientEvaluator slopes(surface->tape(), std::span<const double>());
        const ValueAndGradient expected = slopes.evaluate(0.3, -0.2, 0.45);
        const double length = std::hypot(expected.gradient[0], expected.gradient[1], expected.gradient[2]);
        const auto near = [](double a, double b) {
            return std::abs(a - b) < 1e-12 * std::max(1.0, std::abs(b));
        };
        QVERIFY(near(valueIn(text.declarations, "shape(x,y,z)"), expected.value));
        QVERIFY(near(valueIn(text.declarations, "shape_dx(x,y,z)"), expected.gradient[0]));
        QVERIFY(near(valueIn(text.declarations, "shape_dy(x,y,z)"), expected.gradient[1]));
        QVERIFY(near(valueIn(text.declarations, "shape_dz(x,y,z)"), expected.gradient[2]));
        QVERIFY(near(valueIn(text.declarations, "shape_gradient(x,y,z)"), length));
        QVERIFY(near(valueIn(text.declarations, "shape_normalised(x,y,z)"), (expected.value - 0.2) / length));
    }

    /// Of x*x + y*y + z*z the surface is where the radius is 0.5: there the gradient of the normalised one
    /// is 1.
    void theNormalisedFunctionHasGradientOne() {
        const DerivativeText text = derivativeText(*isosurfaceOf("x*x + y*y + z*z", "threshold 0.25"), {});
        GradientEvaluator slopes(Tape::compile(text.normalised), std::span<const double>());
        const ValueAndGradient at = slopes.evaluate(0.3, 0, 0.4);
        QVERIFY(std::abs(at.value) < 1e-15);
        QVERIFY(std::abs(std::hypot(at.gradient[0], at.gradient[1], at.gradient[2]) - 1) < 1e-12);
    }

    /// A bug once: a derivative of 0 was called by name, as in f(x, y, z) - f_dz(x, y, z).
    void numbersAndVariablesAreWrittenAsSuch() {
        QCOMPARE(derivativeText(*isosurfaceOf("y"), {}).declarations,
                 std::string("#declare f = function(x, y, z) { y }\n"
                             "#declare f_dx = function(x, y, z) { 0 }\n"
                             "#declare f_dy = function(x, y, z) { 1 }\n"
                             "#declare f_dz = function(x, y, z) { 0 }\n"
                             "#declare f_gradient = function(x, y, z) { 1 }\n"
                             "#declare f_normalised = function(x, y, z) { y }\n"));
    }

    /// Long parts are written once: the text of a product of many factors stays short.
    void whatIsSharedIsWrittenOnce() {
        std::string product = "1";
        for (int i = 1; i <= 12; ++i) product += "*(x*x + y*y*" + std::to_string(i) + " + z*sin(x*y) - 0.1)";
        const DerivativeText text = derivativeText(*isosurfaceOf(product), {});
        QVERIFY2(text.problem.empty(), text.problem.c_str());
        QVERIFY(text.declarations.size() < 20'000);
        const double value = valueIn(text.declarations, "f_gradient(x,y,z)");
        QVERIFY(std::isfinite(value));
    }
};

QTEST_MAIN(DerivativeTextTest)
#include "derivative_text_test.moc"

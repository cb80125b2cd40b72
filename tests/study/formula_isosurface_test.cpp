// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/formula_isosurface.h"

#include <QTest>

#include "core/language/parse.h"
#include "core/render/render_image.h"
#include "core/study/gradient/gradient_study.h"
#include "tests/support/povray.h"
#include "tests/support/problems.h"

using namespace isoscope;

namespace {

FormulaIsosurface surfaceOf(const std::string& formula, const SymbolTable& symbols = {}) {
    const auto isNumber = [&symbols](std::string_view name) { return symbols.find(name) != nullptr; };
    const auto read = readBareFormula(formula, 0, isNumber);
    return read ? formulaIsosurface(*read, symbols) : FormulaIsosurface{};
}

constexpr int width = 80, height = 60;

Image pictureOf(const ParseResult& parsed) {
    RenderRequest request;
    request.scene = parsed.scene;
    request.camera = parsed.scene->camera;
    request.width = width;
    request.height = height;
    return renderImage(request);
}

/// How much of the picture is no background, which is darker than any surface.
double shareSeen(const Image& image) {
    const auto seen = std::count_if(image.pixels.begin(), image.pixels.end(), [](const auto& pixel) {
        return std::max({pixel[0], pixel[1], pixel[2]}) > 0.035F;
    });
    return double(seen) / (width * height);
}

}  // namespace

class FormulaIsosurfaceTest : public QObject {
    Q_OBJECT

  private slots:
    /// D31: what a calculator draws is drawn here, and by POV-Ray from the same text.
    void isSeenAndRendersInPovray_data() {
        QTest::addColumn<bool>("bounded");
        const auto row = [](const char* formula, bool bounded) { QTest::newRow(formula) << bounded; };
        row("x^2 + y^2 + z^2 = 1", true);
        row("x*x+y*y+z*z-1", true);
        row("sin(x)+cos(y)-z", false);
        row("(x^2+9/4*y^2+z^2-1)^3 = x^2*z^3 + 9/80*y^2*z^3", true);
        row("z = sin(x)*cos(y)", false);
        row("|x|+|y|+|z| = 1", true);
        row("2x + 3y", false);
        row("x² + y² = 1", false);
        row("(sqrt(x^2+z^2) - 2)^2 + y^2 = 0.25", true);
        row("x^4 + y^4 + z^4 = 81", true);
        row("(x-1)^2 + (y-2)^2 + z^2 = 1/4", true);
        row("-x^2 + y = 0", false);
        row("2^-x^2 = y", false);
        row("y = x^2 - z^2", false);
        row("x^2 + y^2 - z^2 = 1", false);
        row("e^(-x^2 - z^2) = y", false);
        row("ln(x^2 + y^2 + z^2) = 0", true);
        row("log10(x^2 + y^2 + z^2) = 1", true);
        row("max(abs(x), abs(y), 2) = z", false);
        row("max(abs(x), max(abs(y), abs(z))) = 1", true);
        row("sin(pi x) sin(pi y) sin(pi z) = 0.1", false);
        row("cos x + cos y + cos z = 0", false);
        row("tanh(x) = y", false);
        row("2^3^(x/4) = y + 3", false);
        row("x^2/4 + y^2/9 + z^2 <= 1", true);
    }

    void isSeenAndRendersInPovray() {
        QFETCH(bool, bounded);
        const std::string formula = QTest::currentDataTag();
        if (formula == "max(abs(x), abs(y), 2) = z") {
            QVERIFY(surfaceOf(formula).statement.empty());  // three arguments are not understood
            return;
        }
        const FormulaIsosurface surface = surfaceOf(formula);
        QVERIFY(!surface.statement.empty());
        QCOMPARE(surface.bounded, bounded);
        const ParseResult parsed = parseScene(surface.scene);
        QVERIFY2(parsed.diagnostics.empty(), (surface.scene + test::problems(parsed)).c_str());
        const Image ours = pictureOf(parsed);
        const double seen = shareSeen(ours);
        QVERIFY2(seen > 0.03 && seen < 0.9, qPrintable(QString::number(seen)));
        if (!test::hasPovray()) return;
        test::PovrayRun run;
        run.width = width;
        run.height = height;
        const Image theirs = test::povrayPicture(surface.scene, run);
        QCOMPARE(theirs.width, width);
        const double same = test::comparePictures(ours, theirs).shareWithin8;
        qInfo("%s: seen %.0f %%, like POV-Ray %.1f %%", formula.c_str(), 100 * seen, 100 * same);
        QVERIFY2(same > 0.95, qPrintable(QString::number(same)));
    }

    void theContainerFitsTheSurface() {
        const FormulaIsosurface sphere = surfaceOf("x^2 + y^2 + z^2 = 1");
        const auto& box = std::get<ContainerBox>(sphere.container);
        for (int k = 0; k < 3; ++k) {
            QVERIFY(box.high[k] > 1.01 && box.high[k] < 1.25);
            QCOMPARE(box.low[k], -box.high[k]);
        }
        // 2r at the corners of the box.
        QVERIFY(sphere.maxGradient >= 2 * std::sqrt(3.0) * box.high.x);
        QVERIFY(sphere.maxGradient < 2.2 * std::sqrt(3.0) * box.high.x);
    }

    void namesOfTheTextAreKnown() {
        SymbolTable symbols;
        symbols.declare("R", {NumberValue{3}});
        const FormulaIsosurface sphere = surfaceOf("x^2 + y^2 + z^2 = R^2", symbols);
        QVERIFY(sphere.bounded);
        QVERIFY(std::get<ContainerBox>(sphere.container).high.x > 3);
    }

    void stoppedAtOnceItStillAnswers() {
        std::stop_source stop;
        stop.request_stop();
        const auto read = readBareFormula("x^2 + y^2 + z^2 = 1", 0, [](std::string_view) { return false; });
        QVERIFY(!formulaIsosurface(*read, {}, stop.get_token()).statement.empty());
    }
};

QTEST_APPLESS_MAIN(FormulaIsosurfaceTest)
#include "formula_isosurface_test.moc"

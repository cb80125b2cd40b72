// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_snippet.h"

#include <QTest>

#include "core/language/parse.h"

using namespace isoscope;

namespace {

const Builtin& builtin(const char* name) {
    const Builtin* found = findBuiltin(std::string_view(name));
    static const Builtin none;
    return found ? *found : none;
}

std::string messages(const ParseResult& parsed) {
    std::string all;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        all += toString(diagnostic, *parsed.sources) + '\n';
    return all;
}

}  // namespace

class FunctionSnippetTest : public QObject {
    Q_OBJECT

  private slots:
    void callsHaveTheirDefaults() {
        QCOMPARE(signature(builtin("f_torus")), QString("f_torus(x, y, z, Major Radius, Minor Radius)"));
        QVERIFY(callSnippet(builtin("f_torus")).startsWith("f_torus(x, y, z, "));
        QCOMPARE(callSnippet(builtin("f_sphere")).count(','), 3);
        QCOMPARE(callSnippet(builtin("f_hexagon")), QString("f_hexagon(x, y, z).red"));
    }

    void statementsShowTheFunction() {
        const QString text = statementSnippet(builtin("f_algbr_cyl2"), "  translate x\n");
        QVERIFY(text.startsWith("isosurface {\n  function { f_algbr_cyl2(x, y, z, -0.3, 5, 1, 0, 0) }\n"));
        QVERIFY(text.contains("contained_by { box { <-1.6, -0.01, -1.6>, <1.6, 2.4, 1.6> } }"));
        QVERIFY(text.contains("max_gradient 17\n"));
        QVERIFY(text.endsWith("  translate x\n}\n"));
        QVERIFY(statementSnippet(builtin("f_boxed")).contains("function { -f_boxed(x, y, z) }"));
        QVERIFY(statementSnippet(builtin("f_algbr_cyl1")).contains("contained_by { sphere { 0, 1.1 } }"));
        // Patterns raise a ball; one that jumps colours it.
        QVERIFY(statementSnippet(builtin("f_bozo"))
                    .contains("function { sqrt(x*x + y*y + z*z) - 1 - 0.5*f_bozo(3*x, 3*y, 3*z) }"));
        QVERIFY(statementSnippet(builtin("f_dents")).contains("- 1 + 0.8*f_dents("));
        QVERIFY(
            statementSnippet(builtin("f_checker")).contains("    function { f_checker(3*x, 3*y, 3*z) }\n"));
    }

    void everySnippetIsUnderstood_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < builtins().size(); ++i)
            if (!builtins()[i].name.empty())
                QTest::addRow("%s (%d)", builtins()[i].name.c_str(), builtins()[i].id) << static_cast<int>(i);
    }
    void everySnippetIsUnderstood() {
        QFETCH(int, index);
        const Builtin& function = builtins()[index];
        const ParseResult parsed = parseScene(thumbnailScene(function));
        QVERIFY2(parsed.diagnostics.empty(), messages(parsed).c_str());
        QCOMPARE(parsed.scene->isosurfaces.size(), 1u);
        const IsosurfaceSettings& settings = parsed.scene->isosurfaces[0].shape->settings();
        QCOMPARE(settings.threshold, function.showing.threshold);
        QCOMPARE(settings.maxGradient, function.showing.maxGradient);
    }
};

QTEST_GUILESS_MAIN(FunctionSnippetTest)
#include "function_snippet_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rewrites/formula_rewrites.h"

#include <cmath>
#include <QTest>

#include "core/study/rewrites/formula_tree.h"

using namespace isoscope;

namespace {

const std::string head = "#version 3.7;\n#include \"functions.inc\"\n";

std::string sceneWith(const std::string& formula, const std::string& before = {},
                      const std::string& box = "-1, 1") {
    return head + before + "isosurface {\n  function { " + formula + " } // kept\n  contained_by { box { " +
           box + " } }\n}\n";
}

std::vector<FormulaRewrite> rewritesIn(const std::string& text) {
    return formulaRewrites(parseScene(text), 0);
}

const FormulaRewrite* of(const std::vector<FormulaRewrite>& all, RewriteKind kind) {
    for (const FormulaRewrite& one : all)
        if (one.kind == kind) return &one;
    return nullptr;
}

}  // namespace

class FormulaRewritesTest : public QObject {
    Q_OBJECT

  private slots:
    void formulasAreReadAsPovrayDoes() {
        const auto canonical = [](const std::string& text) {
            const FormulaPointer read = readFormula(text, {0, 0, static_cast<std::uint32_t>(text.size())});
            return read ? canonicalText(*read) : std::string("-");
        };
        QCOMPARE(canonical("a - b - c*-d /* x */"), std::string("((a-b)-(c*(-d)))"));
        QCOMPARE(canonical("a < b & c + 1 | v.x"), std::string("(((a<b)&(c+1))|v.x)"));
        QCOMPARE(canonical("pow((x), 2)"), std::string("pow(x,2)"));
        for (const char* none : {"", "a +", "(a", "a b", "#if (1) a #end", "--a", "pigment { x }", "f(a,)"})
            QCOMPARE(canonical(none), std::string("-"));
        QCOMPARE(canonical(std::string(5000, '(') + "x" + std::string(5000, ')')), std::string("-"));
    }

    void equalFactorsBecomeAPower() {
        const std::string text = sceneWith("(x + y*z)*(x + y*z) + y*y - 0.3");
        const auto all = rewritesIn(text);
        const FormulaRewrite* power = of(all, RewriteKind::power);
        QVERIFY(power);
        QCOMPARE(power->fix.replacement, std::string("pow(x + y*z, 2)"));
        QVERIFY(power->proof != RewriteProof::measured);
        QCOMPARE(power->largestDifference, 0.0);
        QVERIFY(power->points > 3500);
        QVERIFY(power->nanoseconds[1] < 0.8 * power->nanoseconds[0]);
        QCOMPARE(rewritten(parseScene(text), *power), sceneWith("pow(x + y*z, 2) + y*y - 0.3"));
    }

    void aPowerOfAHalfBecomesARoot() {
        const auto all = rewritesIn(sceneWith("pow(x + 2, 0.5) - 1.2 + y"));
        const FormulaRewrite* root = of(all, RewriteKind::root);
        QVERIFY(root);
        QCOMPARE(root->fix.replacement, std::string("sqrt(x + 2)"));
        QVERIFY(root->largestDifference < 1e-15);
    }

    void aRootWithAnEndlessSlopeIsSquared() {
        const auto all = rewritesIn(sceneWith("sqrt(x + 1) - (y + 1.5)"));
        const FormulaRewrite* squared = of(all, RewriteKind::squared);
        QVERIFY(squared);
        QCOMPARE(squared->fix.replacement, std::string("x + 1 - pow(y + 1.5, 2)"));
        QCOMPARE(name(squared->proof), std::string_view("identity"));
        QVERIFY(std::isnan(squared->largestDifference));
        QVERIFY(squared->steepest[1] < 10);
        QVERIFY(describe(*squared).find("max_gradient has to be found anew") != std::string::npos);
    }

    void aRootIsNotSquaredWhereSignsAreNotCertain() {
        // Negative on the other side of the root; undefined there; of another threshold; used elsewhere, too.
        QVERIFY(!of(rewritesIn(sceneWith("sqrt(x + 1) - y")), RewriteKind::squared));
        QVERIFY(!of(rewritesIn(sceneWith("sqrt(x) - (y + 1.5)")), RewriteKind::squared));
        QVERIFY(!of(rewritesIn("isosurface { function { sqrt(x + 1) - (y + 1.5) } threshold 0.1 }\n"),
                    RewriteKind::squared));
        const std::string declared = "#declare f = function { sqrt(x + 1) - (y + 1.5) }\n";
        QVERIFY(of(rewritesIn(sceneWith("f(x, y, z)", declared)), RewriteKind::squared));
        QVERIFY(!of(rewritesIn(sceneWith("f(x, y, z)", declared + "#declare g = f(0, 0, 0);\n")),
                    RewriteKind::squared));
        QVERIFY(!of(rewritesIn(sceneWith("f(x, z, y)", declared)), RewriteKind::squared));
    }

    void cancellingDifferencesKeepTheirDigits() {
        const std::string far = "<1e12, 1e12, 0>, <1.1e12, 1.1e12, 1e11>";
        const auto all = rewritesIn(sceneWith("x*x - pow(y, 2)", {}, far));
        const FormulaRewrite* difference = of(all, RewriteKind::cancellation);
        QVERIFY(difference);
        QCOMPARE(difference->fix.replacement, std::string("(x - y)*(x + y)"));
        QCOMPARE(name(difference->proof), std::string_view("identity"));
        QVERIFY(difference->off[0] > 1e-5);
        QVERIFY(difference->off[1] < difference->off[0] / 4);
        // Small numbers lose nothing.
        QVERIFY(!of(rewritesIn(sceneWith("x*x - y*y")), RewriteKind::cancellation));
    }

    void squaresThatOverflowAreScaled() {
        const auto all = rewritesIn(sceneWith("sqrt(exp(x)*exp(x) + y*y) - 5", {}, "-400, 400"));
        const FormulaRewrite* scaled = of(all, RewriteKind::overflow);
        QVERIFY(scaled);
        QCOMPARE(name(scaled->proof), std::string_view("identity"));
        QVERIFY2(scaled->mended > 100, describe(*scaled).c_str());
        QVERIFY(!of(rewritesIn(sceneWith("sqrt(x*x + y*y) - 0.5")), RewriteKind::overflow));
        // Nothing is told of containers in which nothing can be compared.
        QVERIFY(rewritesIn(sceneWith("(x + y)*(x + y) + z", {}, "-1e200, 1e200")).empty());
    }

    void commonPartsAreComputedOnce() {
        const std::string text =
            sceneWith("sin(x*y + z)*x + cos(sin(x*y + z)*3) - sin(x*y + z)*z*sin(x*y + z)");
        const auto all = rewritesIn(text);
        const FormulaRewrite* common = of(all, RewriteKind::common);
        QVERIFY(common);
        QVERIFY(common->proof != RewriteProof::measured);
        const std::string after = rewritten(parseScene(text), *common);
        QCOMPARE(after, sceneWith("f_parts(x, y, z, sin(x*y + z))",
                                  "#declare f_parts = function(x, y, z, part) { part*x + cos(part*3) - "
                                  "part*z*part }\n"));
        QVERIFY(parseScene(after).ok());
    }

    void anglesBecomeQuotients() {
        const auto all = rewritesIn(sceneWith("cos(2*atan2(y, x)) - z", {}, "<0.2, -1, -1>, <1, 1, 1>"));
        for (const FormulaRewrite& one : all) QVERIFY(one.nanoseconds[1] < one.nanoseconds[0]);
    }

    void otherIsosurfacesStayAsTheyAre() {
        const std::string declared = "#declare f = function(u) { (u + 1)*(u + 1) }\n";
        const std::string two =
            sceneWith("f(x) - y - 1", declared) + "isosurface { function { f(y*x) - 1 } }\n";
        const auto all = rewritesIn(two);
        QVERIFY(of(all, RewriteKind::power));
        QCOMPARE(of(all, RewriteKind::power)->fix.replacement, std::string("pow(u + 1, 2)"));
    }

    void plainFormulasNeedNone() {
        QVERIFY(rewritesIn(sceneWith("x*x + y*y + z*z - 1")).empty());
        QVERIFY(rewritesIn(sceneWith("x + ")).empty());
        QVERIFY(rewritesIn("").empty());
    }
};

QTEST_GUILESS_MAIN(FormulaRewritesTest)
#include "formula_rewrites_test.moc"

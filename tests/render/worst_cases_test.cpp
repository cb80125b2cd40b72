// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/render/verdict_map.h"
#include "core/roots/certified/general_search.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

constexpr int width = 64;
constexpr int height = 48;

}  // namespace

/// Functions that a certified search cannot finish, or only at the price of its whole budget: the picture is
/// finished all the same, within the budget, and says what is not certain.
class WorstCasesTest : public QObject {
    Q_OBJECT

  private slots:
    void budgetIsRespectedAndTheVerdictShown_data() {
        QTest::addColumn<QString>("function");
        QTest::addColumn<QString>("verdict");
        QTest::newRow("plateau") << "max(0, x)"
                                 << "gap";
        QTest::newRow("plateau of a product") << "max(0, x)*max(0, y)*sin(50*z)"
                                              << "gap";
        QTest::newRow("even contact") << "(x*x + y*y + z*z - 1)*(x*x + y*y + z*z - 1)"
                                      << "gap";
        QTest::newRow("thin shell") << "pow(x*x + y*y + z*z - 1, 2) - 1e-9"
                                    << "certified-hit";
        QTest::newRow("fast sine") << "sin(1e6*x) + min(0, y)"
                                   << "certified-hit";
        QTest::newRow("poles") << "1/(x*y*z)"
                               << "gap";
        QTest::newRow("poles everywhere") << "tan(300*x)*tan(300*y)"
                                          << "certified-hit";
        QTest::newRow("jumps") << "floor(20*x) + floor(20*y) - z"
                               << "certified-hit";
        QTest::newRow("undefined in half") << "sqrt(x) - 0.5"
                                           << "certified-hit";
        QTest::newRow("undefined everywhere") << "sqrt(-1 - x*x)"
                                              << "certified-miss";
        QTest::newRow("zero") << "0*x"
                              << "gap";
    }
    void budgetIsRespectedAndTheVerdictShown() {
        QFETCH(QString, function);
        QFETCH(QString, verdict);
        const ParseResult parsed = parseScene(
            "camera { location <0.3, 0.4, -4> look_at 0 } light_source { <5, 5, -5> rgb 1 }\n"
            "isosurface { function { " +
            function.toStdString() + " } contained_by { sphere { 0, 1.3 } } }");
        QVERIFY(parsed.ok());
        RenderRequest request = test::requestFor(parsed, width, height);
        request.rootFinder = RootFinder::certified;
        request.verdicts = std::make_shared<VerdictMap>(width, height);
        RenderStatistics statistics;
        renderImage(request, 2, &statistics);
        std::string told;
        for (const auto& [name, count] : statistics.verdicts)
            told += name + " " + std::to_string(count) + ", ";
        qInfo("%s%.1f evaluations a ray", told.c_str(),
              static_cast<double>(statistics.evaluations) / static_cast<double>(statistics.rays));
        QVERIFY2(statistics.verdicts[verdict.toStdString()] > 100, told.c_str());
        // Beside the budget the rest of the line is sampled, and roots are polished.
        constexpr std::uint64_t most = GeneralSearch::defaultBudget + 2 * GeneralSearch::restSamples;
        QVERIFY(statistics.evaluations <= most * statistics.rays);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) QVERIFY(request.verdicts->noted(x, y));
    }
};

QTEST_APPLESS_MAIN(WorstCasesTest)
#include "worst_cases_test.moc"

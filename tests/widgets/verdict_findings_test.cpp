// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/verdicts/verdict_findings.h"

#include <QTest>

using namespace isoscope;

class VerdictFindingsTest : public QObject {
    Q_OBJECT

    static std::vector<int> linesOf(const std::string& text) { return verdictLines(parseScene(text)); }

  private slots:
    void linesAreThoseOfTheSettings() {
        const std::vector<int> lines = linesOf(
            "isosurface { function { x }\n contained_by { box { -1, 1 } }\n max_gradient 2 }\n"
            "isosurface { function { y } }\n"
            "#macro M(A)\n isosurface { function { z - A }\n  max_gradient 3 }\n#end\n"
            "union { M(1) M(2) }\n"
            "isosurface { function { x + y }\n accuracy 0.1\n\n max_gradient 4 }\n");
        QCOMPARE(lines, (std::vector<int>{3, 4, 7, 7, 13}));
    }

    /// With each isosurface all settings were searched: 40 000 of them stopped the window for a minute.
    void eachOfManyHasItsOwnLine() {
        constexpr int count = 3000;
        std::string text;
        for (int i = 0; i < count; ++i)
            text +=
                i % 2 ? "isosurface { function { x } max_gradient 2 }\n" : "isosurface { function { x } }\n";
        const std::vector<int> lines = linesOf(text);
        QCOMPARE(lines.size(), std::size_t(count));
        for (int i = 0; i < count; ++i) QCOMPARE(lines[static_cast<std::size_t>(i)], i + 1);
    }
};

QTEST_APPLESS_MAIN(VerdictFindingsTest)
#include "verdict_findings_test.moc"

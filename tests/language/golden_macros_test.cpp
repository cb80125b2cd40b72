// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <QTest>
#include <set>

#include "core/language/directives/library_paths.h"
#include "core/language/parse.h"
#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

std::vector<std::string> splitAt(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::string part;
    for (const char c : text) {
        if (c == separator) {
            parts.push_back(part);
            part.clear();
        } else {
            part += c;
        }
    }
    if (!text.empty()) parts.push_back(part);
    return parts;
}

/// "<a, b, c>" of three parts from `first` on.
std::string vectorText(const std::vector<std::string>& parts, std::size_t first) {
    return "<" + parts.at(first) + ", " + parts.at(first + 1) + ", " + parts.at(first + 2) + ">";
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

/// One row of golden/macros.csv as the text that calls the macro; results are left in R0, R1, ...
std::string sceneOf(const std::string& macro, const std::string& object, const std::string& args) {
    const std::vector<std::string> parts = splitAt(args, ';');
    std::string text = "#version 3.7;\n#include \"shapes.inc\"\n";
    if (!object.empty()) text += "#declare Obj = " + object + "\n";
    const std::string extents = "#declare R0 = min_extent(New);\n#declare R1 = max_extent(New);\n";
    if (macro == "Isect" || macro == "IsectN") {
        const bool normal = macro == "IsectN";
        text += "#declare R1 = <7, 8, 9>;\n#declare R2 = <7, 8, 9>;\n#declare R0 = " + macro + "(" +
                vectorText(parts, 0) + ", " + vectorText(parts, 3) + ", Obj, R1" + (normal ? ", R2" : "") +
                ");\n";
    } else if (macro == "Extents") {
        text += "#declare R0 = 0;\n#declare R1 = 0;\nExtents(Obj, R0, R1)\n";
    } else if (macro == "Center_Object") {
        text += "#declare New = object { Center_Object(Obj, " + vectorText(parts, 0) + ") }\n" + extents;
    } else if (macro == "Align_Object") {
        text += "#declare New = object { Align_Object(Obj, " + vectorText(parts, 0) + ", " +
                vectorText(parts, 3) + ") }\n" + extents;
    } else if (macro == "Text_Width" || macro == "Text_Space") {
        text += "#declare R0 = " + macro + "(" + joined(parts) + ");\n";
    } else {
        text += "#declare New = object { " + macro + "(" + joined(parts) + ") }\n" + extents;
    }
    return text;
}

/// The numbers left in R0, R1 and so on; empty when the text has mistakes.
std::vector<double> resultsOf(const std::string& macro, const std::string& text, std::string& problem) {
    ParseOptions options;
    options.libraryPaths = installedLibraryPaths();
    const ParseResult parsed = parseScene(text, options);
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == Severity::error) {
            problem = toString(diagnostic, *parsed.sources);
            return {};
        }
    std::vector<double> results;
    const int count = macro == "IsectN" ? 3 : macro.starts_with("Text_") ? 1 : 2;
    for (int k = 0; k < count; ++k) {
        const Value* value = parsed.symbols->find("R" + std::to_string(k));
        if (!value) continue;
        if (const auto* number = std::get_if<NumberValue>(&value->data))
            results.push_back(number->value);
        else if (const auto* vector = std::get_if<VectorValue>(&value->data))
            results.insert(results.end(), vector->components.begin(), vector->components.begin() + 3);
    }
    return results;
}

/// Extents come out of POV-Ray in single precision and a little too large (golden/README-rays.md); the widths
/// of texts are differences of them.
double toleranceOf(const std::string& macro, double wanted) {
    if (macro.starts_with("Text_")) return 1e-6 * std::max(1.0, std::abs(wanted));
    return macro == "Isect" || macro == "IsectN" ? 1e-6 : 1e-4;
}

}  // namespace

/// The macros of shapes.inc that trace, place and measure, as POV-Ray answers them.
class GoldenMacrosTest : public QObject {
    Q_OBJECT

  private slots:
    void agreeWithPovray_data() {
        QTest::addColumn<QString>("macro");
        const auto row = [](const char* macro, const char* rows) {
            QTest::newRow((std::string(macro) + " " + rows).c_str()) << QString(macro);
        };
        row("Isect", "INC-ISECT");
        row("IsectN", "INC-ISECTN CONF-26");
        row("Extents", "INC-EXTENTS CONF-27");
        row("Center_Object", "INC-CENTER");
        row("Align_Object", "INC-ALIGN");
        row("Text_Width", "INC-TEXTWIDTH CONF-28");
        row("Text_Space", "INC-TEXTSPACE");
        row("Bevelled_Text", "INC-BEVEL CONF-77");
        row("Circle_Text", "INC-CIRCLETEXT");
    }

    void agreeWithPovray() {
        if (installedLibraryPaths().empty()) QSKIP("the fonts of the text macros come with POV-Ray");
        QFETCH(QString, macro);
        const test::CsvTable table(test::dataFile("golden/macros.csv"));
        int agreeing = 0, all = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            if (table.field(row, "macro") != macro.toStdString()) continue;
            const std::string text =
                sceneOf(macro.toStdString(), table.field(row, "object"), table.field(row, "args"));
            const std::vector<std::string> wanted = splitAt(table.field(row, "result"), ';');
            std::string problem;
            const std::vector<double> got = resultsOf(macro.toStdString(), text, problem);
            if (problem.empty() && got.size() != wanted.size()) problem = "the number of results differs";
            for (std::size_t k = 0; problem.empty() && k < wanted.size(); ++k)
                if (!(std::abs(got[k] - std::stod(wanted[k])) <=
                      toleranceOf(macro.toStdString(), std::stod(wanted[k]))))
                    problem = "number " + std::to_string(k + 1) + " is " + std::to_string(got[k]) + ", not " +
                              wanted[k];
            if (!problem.empty())
                qWarning("case %s, %s: %s\n%s", table.field(row, "case").c_str(), qPrintable(macro),
                         problem.c_str(), text.c_str());
            ++all;
            agreeing += problem.empty();
        }
        qInfo("%d of %d rows agree", agreeing, all);
        QVERIFY(all >= 4);
        QCOMPARE(agreeing, all);
    }

    void everyMacroIsCompared() {
        const std::set<std::string> compared{"Isect",         "IsectN",        "Extents",
                                             "Center_Object", "Align_Object",  "Text_Width",
                                             "Text_Space",    "Bevelled_Text", "Circle_Text"};
        const test::CsvTable table(test::dataFile("golden/macros.csv"));
        QVERIFY(table.rowCount() >= 90);
        for (std::size_t row = 0; row < table.rowCount(); ++row)
            QVERIFY2(compared.contains(table.field(row, "macro")), table.field(row, "macro").c_str());
    }
};

QTEST_APPLESS_MAIN(GoldenMacrosTest)
#include "golden_macros_test.moc"

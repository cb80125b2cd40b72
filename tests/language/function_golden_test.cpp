// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <QTest>
#include <regex>
#include <tuple>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/parse.h"
#include "tests/support/csv_table.h"
#include "tests/support/problems.h"

using namespace isoscope;
using test::problems;

namespace {

/// A function body of a golden table, parsed once for all its rows.
struct Body {
    ParsedFunction parsed;
    std::vector<double> extraArguments;  ///< behind x, y, z
};

/// `prelude` is a list of declarations, or the head of the function: `function(a,b) called with (x,y,0.5)`.
Body parseBody(const std::string& prelude, const std::string& expression, int noiseGenerator) {
    ParseOptions options;
    options.imageWidth = options.imageHeight = 1;
    options.noiseGenerator = noiseGenerator;
    Body body;
    if (prelude.rfind("function", 0) != 0) {
        body.parsed = parseFunction(expression, prelude, options);
        return body;
    }
    const std::string list = prelude.substr(9, prelude.find(')') - 9);
    std::vector<std::string> names;
    std::istringstream stream(list);
    for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
    if (prelude.find("called with") != std::string::npos) body.extraArguments = {0.5};
    // parseFunction takes the names as they are; the list itself is read by the scene language.
    const ParseResult whole =
        parseScene("#declare F = function(" + list + ") { " + expression + "\n}", options);
    body.parsed = parseFunction(expression, {}, options, names);
    if (!whole.ok()) body.parsed.diagnostics = whole.diagnostics;
    if (!whole.ok()) body.parsed.sources = whole.sources;
    return body;
}

QString rowText(const test::CsvTable& table, std::size_t row) {
    QString text = QStringLiteral("row %1").arg(row + 2);
    for (const char* column : {"prelude", "expression", "definition", "x", "y", "z", "value", "error"})
        if (!table.field(row, column).empty())
            text += QStringLiteral(", %1: %2").arg(column, QString::fromStdString(table.field(row, column)));
    return text;
}

double evaluate(const Body& body, const test::CsvTable& table, std::size_t row, std::size_t component = 0) {
    std::vector<double> arguments{table.number(row, "x"), table.number(row, "y"), table.number(row, "z")};
    arguments.insert(arguments.end(), body.extraArguments.begin(), body.extraArguments.end());
    ReferenceEvaluator evaluator(body.parsed.value.function);
    return evaluator.evaluate(arguments, body.parsed.parameterTable, component);
}

/// Every row of a table with columns prelude, expression, x, y, z, value and perhaps error.
void checkTable(const QString& file, std::size_t leastRows) {
    const test::CsvTable table(test::dataFile(file));
    QVERIFY(table.rowCount() >= leastRows);
    std::map<std::pair<std::string, std::string>, Body> bodies;
    std::size_t values = 0, refusals = 0;
    double worst = 0;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        const std::pair key(table.field(row, "prelude"), table.field(row, "expression"));
        auto body = bodies.find(key);
        if (body == bodies.end()) body = bodies.emplace(key, parseBody(key.first, key.second, 2)).first;
        const ParsedFunction& parsed = body->second.parsed;
        if (!table.field(row, "error").empty()) {
            QVERIFY2(!parsed.ok(), qPrintable("accepted, but POV-Ray refuses: " + rowText(table, row)));
            QVERIFY2(hasErrors(parsed.diagnostics), qPrintable("no error reported: " + rowText(table, row)));
            ++refusals;
            continue;
        }
        QVERIFY2(parsed.ok(),
                 qPrintable(rowText(table, row) + "\n" + QString::fromStdString(problems(parsed))));
        const double got = evaluate(body->second, table, row);
        const double error = test::goldenError(got, table.number(row, "value"));
        QVERIFY2(error <= 1e-9,
                 qPrintable(QStringLiteral("got %1 for %2").arg(got, 0, 'g', 17).arg(rowText(table, row))));
        worst = std::max(worst, error);
        ++values;
    }
    qInfo("%s: %zu values, worst error %.3g; %zu refusals", qPrintable(file), values, worst, refusals);
}

/// Rows of golden/patterns.csv whose functions give more than one number: `F(x,y,z).component`. POV-Ray keeps
/// colours in single precision.
void checkNamedFunctions(const char* kind, double tolerance, std::size_t leastValues) {
    const test::CsvTable table(test::dataFile("golden/patterns.csv"));
    std::map<std::tuple<std::string, std::string, int>, Body> bodies;
    std::size_t values = 0, edges = 0, refusals = 0;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        if (table.field(row, "kind") != kind) continue;
        const std::string& generator = table.field(row, "noise_generator");
        const std::tuple key(table.field(row, "definition"), table.field(row, "component"),
                             generator.empty() ? 2 : std::stoi(generator));
        auto body = bodies.find(key);
        if (body == bodies.end())
            body = bodies
                       .emplace(key, parseBody("#declare F = function { " + std::get<0>(key) + " }",
                                               "F(x,y,z)." + std::get<1>(key), std::get<2>(key)))
                       .first;
        const ParsedFunction& parsed = body->second.parsed;
        if (!table.field(row, "error").empty()) {
            const ParseResult scene = parseScene("#declare F = function { " + std::get<0>(key) +
                                                 " } #declare V = F(0, 0, 0)." + std::get<1>(key) + ";");
            QVERIFY2(!scene.ok(), qPrintable("accepted: " + rowText(table, row)));
            ++refusals;
            continue;
        }
        QVERIFY2(parsed.ok(),
                 qPrintable(rowText(table, row) + "\n" + QString::fromStdString(problems(parsed))));
        if (table.field(row, "edge") == "1") {
            ++edges;
            continue;
        }
        const double got = evaluate(body->second, table, row);
        QVERIFY2(test::goldenError(got, table.number(row, "value")) <= tolerance,
                 qPrintable(QStringLiteral("got %1 for %2").arg(got, 0, 'g', 17).arg(rowText(table, row))));
        ++values;
    }
    qInfo("%s: %zu values, %zu on edges, %zu refusals", kind, values, edges, refusals);
    QVERIFY(values >= leastValues);
}

}  // namespace

class FunctionGoldenTest : public QObject {
    Q_OBJECT

  private slots:
    void operators() { checkTable("golden/operators.csv", 500); }
    void seedExpressions_XF_FCSG_ISO() { checkTable("golden/seed_expressions.csv", 100); }

    void refusedCalls() {
        const test::CsvTable table(test::dataFile("golden/functions_errors.csv"));
        QVERIFY(table.rowCount() > 0);
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string& function = table.field(row, "function");
            std::string call = function;
            if (table.field(row, "set") == "arity") {
                call += "(x,y,z";
                for (int k = 0; k < 10; ++k)
                    if (!table.field(row, "P" + std::to_string(k)).empty()) call += ",1";
                call += ")";
            }
            const ParsedFunction parsed = parseFunction(call);
            QVERIFY2(!parsed.ok() && hasErrors(parsed.diagnostics), qPrintable(QString::fromStdString(call)));
            if (table.field(row, "set") != "arity") continue;
            const std::string& message = parsed.diagnostics.front().message;
            QVERIFY2(message.find("`" + function + "` takes x, y") == 0,
                     qPrintable(QString::fromStdString(message)));
        }
    }

    void splines() {
        const test::CsvTable table(test::dataFile("golden/patterns.csv"));
        std::map<std::string, ParsedFunction> splines;
        std::size_t values = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            if (table.field(row, "kind") != "spline") continue;
            const std::string& definition = table.field(row, "definition");
            const auto [parsed, isNew] = splines.try_emplace(definition);
            if (isNew) parsed->second = parseFunction(definition);
            QVERIFY2(parsed->second.ok(), qPrintable(rowText(table, row)));
            static const std::map<std::string, std::size_t> components{
                {"x", 0}, {"u", 0}, {"red", 0}, {"y", 1}, {"v", 1}, {"z", 2}, {"t", 3}};
            const std::size_t component = components.at(table.field(row, "component"));
            const Function& function = parsed->second.value.function;
            QCOMPARE(component < function.results.size(), table.field(row, "error").empty());
            if (component >= function.results.size()) continue;
            ReferenceEvaluator evaluator(function);
            const double got = evaluator.evaluate(std::vector<double>{table.number(row, "x")}, {}, component);
            QVERIFY2(
                test::goldenError(got, table.number(row, "value")) <= 1e-9,
                qPrintable(QStringLiteral("got %1 for %2").arg(got, 0, 'g', 17).arg(rowText(table, row))));
            ++values;
        }
        qInfo("%zu values of %zu splines", values, splines.size());
        QVERIFY(values > (test::hasSharedData() ? 1000u : 100u));
    }

    void pigments_FN_PRE() { checkNamedFunctions("pigment", 1e-6, test::hasSharedData() ? 1200 : 150); }
    void transforms() { checkNamedFunctions("transform", 1e-9, test::hasSharedData() ? 100 : 15); }

    void patternsAndNamedPatterns_FN_PAT() {
        const test::CsvTable table(test::dataFile("golden/patterns.csv"));
        QVERIFY(table.rowCount() > 500);
        std::map<std::pair<std::string, int>, Body> bodies;
        std::size_t values = 0, edges = 0, refusals = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string& kind = table.field(row, "kind");
            if (kind != "builtin" && kind != "pattern" && kind != "expression") continue;
            const std::string& definition = table.field(row, "definition");
            const std::string& generator = table.field(row, "noise_generator");
            const std::pair key(definition, generator.empty() ? 2 : std::stoi(generator));
            auto body = bodies.find(key);
            if (body == bodies.end()) {
                std::string call = definition;
                if (kind == "builtin") call += "(x,y,z)";
                if (!table.field(row, "component").empty()) call += "." + table.field(row, "component");
                body = bodies.emplace(key, parseBody({}, call, key.second)).first;
            }
            const ParsedFunction& parsed = body->second.parsed;
            if (!table.field(row, "error").empty()) {
                QVERIFY2(!parsed.ok(), qPrintable("accepted: " + rowText(table, row)));
                ++refusals;
                continue;
            }
            QVERIFY2(parsed.ok(),
                     qPrintable(rowText(table, row) + "\n" + QString::fromStdString(problems(parsed))));
            if (table.field(row, "edge") == "1") {
                ++edges;
                continue;
            }
            const double got = evaluate(body->second, table, row);
            const bool colors = definition.find("pigment_pattern") != std::string::npos;
            const double tolerance = colors ? 1e-6 : kind == "expression" ? 1e-7 : 1e-9;
            const double error = test::goldenError(got, table.number(row, "value"));
            QVERIFY2(
                error <= tolerance,
                qPrintable(QStringLiteral("got %1 for %2").arg(got, 0, 'g', 17).arg(rowText(table, row))));
            ++values;
        }
        qInfo("patterns: %zu values, %zu on edges, %zu refusals", values, edges, refusals);
        QVERIFY(values > (test::hasSharedData() ? 5000u : 500u));
    }
};

QTEST_APPLESS_MAIN(FunctionGoldenTest)
#include "function_golden_test.moc"

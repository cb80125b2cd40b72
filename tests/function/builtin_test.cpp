// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/builtins/builtin.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <QTest>
#include <set>

#include "core/evaluate/reference_evaluator.h"
#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

constexpr int defaultGenerator = 2;

/// A built-in with constant parameters, as a function of x, y, z.
Function withConstants(const Builtin& builtin, const std::vector<double>& parameters) {
    FunctionGraph graph;
    std::vector<Expression> arguments;
    for (int i = 0; i < builtin.pointArguments; ++i) arguments.emplace_back(graph, graph.variable(i));
    for (const double p : parameters) arguments.emplace_back(graph, graph.constant(p));
    const Expression value = buildBuiltin(builtin, arguments, defaultGenerator);
    return finish(std::move(graph), {value.node()}, builtin.pointArguments);
}

/// A built-in with all its arguments open, so that nothing can be decided while building.
Function withVariables(const Builtin& builtin) {
    FunctionGraph graph;
    std::vector<Expression> arguments;
    for (int i = 0; i < builtin.argumentCount(); ++i) arguments.emplace_back(graph, graph.variable(i));
    const Expression value = buildBuiltin(builtin, arguments, defaultGenerator);
    return finish(std::move(graph), {value.node()}, builtin.argumentCount());
}

const Builtin* findByCall(const std::string& name) {
    return name == "internal(77)" ? findBuiltin(77) : findBuiltin(std::string_view(name));
}

struct GoldenRow {
    const Builtin* builtin = nullptr;
    std::vector<double> point, parameters;
    double value = 0;

    double tolerance() const {
        const bool isFractal = builtin->id == 29 || builtin->id == 58 || builtin->id == 59;
        const bool isFar =
            std::any_of(point.begin(), point.end(), [](double t) { return std::abs(t) > 100; });
        return isFractal && isFar ? 1e-7 : 1e-9;
    }
};

GoldenRow readRow(const test::CsvTable& table, std::size_t row) {
    GoldenRow golden;
    golden.builtin = findByCall(table.field(row, "function"));
    for (const char* axis : {"x", "y", "z"}) golden.point.push_back(table.number(row, axis));
    for (int i = 0; i < 10; ++i) {
        const std::string column = "P" + std::to_string(i);
        if (!table.field(row, column).empty()) golden.parameters.push_back(table.number(row, column));
    }
    golden.value = table.number(row, "value");
    return golden;
}

/// Contradictions of the tutorials that the golden values of these functions decide
/// (docs/povray/coverage.md).
const std::map<std::string, std::string> settledBy{
    {"f_bicorn", "CONF-45"},
    {"f_bifolia", "CONF-45"},
    {"f_superellipsoid", "CONF-46"},
    {"f_spikes_2d", "CONF-47"},
    {"f_ridged_mf", "CONF-48"},
    {"f_spiral", "CONF-49"},
    {"f_scallop_wave", "CONF-50"},
    {"f_torus_gumdrop", "CONF-50"},
    {"f_steiners_roman", "CONF-51"},
    {"f_devils_curve_2d", "CONF-52"},
    {"f_folium_surface_2d", "CONF-52"},
    {"f_helix2", "CONF-53"},
    {"f_boy_surface", "CONF-54"},
    {"f_kampyle_of_eudoxus_2d", "CONF-55"},
    {"f_kummer_surface_v1", "CONF-84"},
    {"f_kummer_surface_v2", "CONF-84"},
    {"f_cushion", "CONF-88"},
    {"f_odd", "CONF-88"},
};

/// One test for each function of golden/functions.csv, named after the rows of the checklist that it holds.
void nameFunctions() {
    QTest::addColumn<QString>("function");
    const test::CsvTable table(test::dataFile("golden/functions.csv"));
    QVERIFY(table.rowCount() > 1000);
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.rowCount(); ++row) names.insert(table.field(row, "function"));
    QCOMPARE(int(names.size()), 80);  // numbers 0 to 78 and f_snoise3d
    for (const std::string& name : names) {
        const QString rows =
            name.starts_with("f_") ? "FN-" + QString::fromStdString(name.substr(2)).toUpper() : QString();
        const auto settled = settledBy.find(name);
        const QString more = settled == settledBy.end() ? QString() : QString::fromStdString(settled->second);
        const QString tag = QStringList{QString::fromStdString(name), rows, more}.join(' ').trimmed();
        QTest::newRow(qPrintable(tag)) << QString::fromStdString(name);
    }
}

/// Compares the rows of golden/functions.csv for one function with what `evaluate` makes of them.
void compareRows(const QString& function, const std::function<double(const GoldenRow&)>& evaluate) {
    static const test::CsvTable table(test::dataFile("golden/functions.csv"));
    int rows = 0;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        if (table.field(row, "function") != function.toStdString()) continue;
        const GoldenRow golden = readRow(table, row);
        QVERIFY2(golden.builtin, table.field(row, "function").c_str());
        QCOMPARE(golden.parameters.size(), golden.builtin->parameters.size());
        const double got = evaluate(golden);
        if (!(test::goldenError(got, golden.value) <= golden.tolerance()))
            QFAIL(qPrintable(QStringLiteral("row %1, %2 at (%3, %4, %5): got %6, POV-Ray has %7")
                                 .arg(row + 2)
                                 .arg(function)
                                 .arg(golden.point[0], 0, 'g', 17)
                                 .arg(golden.point[1], 0, 'g', 17)
                                 .arg(golden.point[2], 0, 'g', 17)
                                 .arg(got, 0, 'g', 17)
                                 .arg(golden.value, 0, 'g', 17)));
        ++rows;
    }
    QVERIFY(rows > 0);
}

}  // namespace

class BuiltinTest : public QObject {
    Q_OBJECT

  private slots:
    void goldenRowsWithConstantParameters_data() { nameFunctions(); }
    void goldenRowsWithConstantParameters() {
        QFETCH(QString, function);
        std::map<std::pair<const Builtin*, std::vector<double>>, ReferenceEvaluator> built;
        compareRows(function, [&](const GoldenRow& row) {
            const auto key = std::make_pair(row.builtin, row.parameters);
            auto found = built.find(key);
            if (found == built.end())
                found = built.emplace(key, withConstants(*row.builtin, row.parameters)).first;
            return found->second.evaluate(row.point);
        });
    }

    void goldenRowsWithVariableParameters_data() { nameFunctions(); }
    void goldenRowsWithVariableParameters() {
        QFETCH(QString, function);
        std::map<const Builtin*, ReferenceEvaluator> built;
        compareRows(function, [&](const GoldenRow& row) {
            auto found = built.find(row.builtin);
            if (found == built.end()) found = built.emplace(row.builtin, withVariables(*row.builtin)).first;
            std::vector<double> arguments = row.point;
            arguments.insert(arguments.end(), row.parameters.begin(), row.parameters.end());
            return found->second.evaluate(arguments);
        });
    }

    void factsAreThoseOfTheSpecification() {
        const test::CsvTable table(test::dataFile("spec/functions.csv"));
        QCOMPARE(int(table.rowCount()), 109);
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string& name = table.field(row, "name");
            const Builtin* builtin = findBuiltin(std::string_view(name));
            QVERIFY2(builtin, name.c_str());
            QCOMPARE(builtin->id, int(table.number(row, "id")));
            QCOMPARE(builtin->threshold, table.number(row, "threshold"));
            QCOMPARE(builtin->container, table.field(row, "container"));
            QCOMPARE(builtin->maxGradient, table.number(row, "max_gradient"));
            QCOMPARE(builtin->invert, table.field(row, "invert") == "1");
            QCOMPARE(builtin->kind, table.field(row, "kind"));
            QVERIFY2(!builtin->formula.empty(), name.c_str());
            if (builtin->pointArguments == 0) continue;  // the waves name their three arguments
            QCOMPARE(int(builtin->parameters.size()), int(table.number(row, "param_count")));
            for (std::size_t i = 0; i < builtin->parameters.size(); ++i) {
                const std::string column = "P" + std::to_string(i) + "_";
                QCOMPARE(builtin->parameters[i].name, table.field(row, column + "name"));
                QVERIFY(builtin->parameters[i].defaultValue == table.number(row, column + "default"));
                QVERIFY(builtin->parameters[i].minimum == table.number(row, column + "min"));
                QVERIFY(builtin->parameters[i].maximum == table.number(row, column + "max"));
            }
        }
    }

    void everyFunctionIsThereOnceAndInOrder() {
        const auto all = builtins();
        QCOMPARE(int(all.size()), 110);  // the table and internal(77)
        for (std::size_t i = 1; i < all.size(); ++i)
            QVERIFY(all[i - 1].id < all[i].id || (all[i - 1].id == -1 && all[i - 1].name < all[i].name));
        for (int id = 0; id <= 78; ++id) {
            QVERIFY(findBuiltin(id));
            QCOMPARE(findBuiltin(id)->id, id);
        }
        QVERIFY(!findBuiltin(-1));
        QVERIFY(!findBuiltin(79));
        QVERIFY(!findBuiltin(std::string_view()));
        QVERIFY(!findBuiltin(std::string_view("f_nonsense")));
    }

    void argumentCountsAreTheOnesPovRayWants() {
        const test::CsvTable table(test::dataFile("golden/functions_errors.csv"));
        int compared = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const QString error = QString::fromStdString(table.field(row, "error"));
            const qsizetype end = error.indexOf(" required");
            if (table.field(row, "set") != "arity" || end < 0) continue;
            const Builtin* builtin = findByCall(table.field(row, "function"));
            QVERIFY2(builtin, table.field(row, "function").c_str());
            QCOMPARE(builtin->argumentCount(), error.left(end).section(' ', -1).toInt());
            ++compared;
        }
        QVERIFY(compared > 70);
    }

    void sampleCallsAreWhatAPersonTypes() {
        QCOMPARE(sampleCall(*findBuiltin("f_torus")), std::string("f_torus(x, y, z, 0.8, 0.2)"));
        QCOMPARE(sampleCall(*findBuiltin("f_hexagon")), std::string("f_hexagon(x, y, z).red"));
        QCOMPARE(sampleCall(*findBuiltin("f_sine_wave")), std::string("f_sine_wave(x, y, z)"));
        QCOMPARE(sampleCall(*findBuiltin("f_r")), std::string("f_r(x, y, z)"));
    }

    void countsBeyondTheLimitActLikeTheLimit() {
        const Builtin& ridged = *findBuiltin("f_ridged_mf");
        const std::vector<double> p{0.3, 0.4, 0.5};
        ReferenceEvaluator limit(withConstants(ridged, {1, 1.5, double(octaveLimit), 1, 1, 2}));
        for (const double octaves : {65.0, 1e9, 1e300, double(INFINITY)}) {
            const Function function = withConstants(ridged, {1, 1.5, octaves, 1, 1, 2});
            QVERIFY(function.graph->size() < 2000);
            QCOMPARE(ReferenceEvaluator(function).evaluate(p), limit.evaluate(p));
        }
    }

    void wildParametersBuildAndEvaluate() {
        for (const Builtin& builtin : builtins())
            for (const double wild :
                 {double(INFINITY), -double(INFINITY), std::nan(""), 1e300, -1e300, 0.0}) {
                const std::vector<double> parameters(builtin.parameters.size(), wild);
                const Function function = withConstants(builtin, parameters);
                QVERIFY2(function.graph->size() < 20000, builtin.name.c_str());
                ReferenceEvaluator(function).evaluate(std::vector<double>{0.3, wild, 0.5});
            }
    }

    void structuralParametersAreKnown() {
        QVERIFY(isStructural(*findBuiltin("f_ridge"), 1));
        QVERIFY(isStructural(*findBuiltin("f_polytubes"), 0));
        QVERIFY(!isStructural(*findBuiltin("f_torus"), 0));
        QVERIFY(!isStructural(*findBuiltin("f_torus"), 7));
        QVERIFY(!isStructural(*findBuiltin("f_torus"), -1));
    }
};

QTEST_APPLESS_MAIN(BuiltinTest)
#include "builtin_test.moc"

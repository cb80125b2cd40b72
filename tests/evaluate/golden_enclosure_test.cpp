// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's values lie in the enclosures of the functions, at points and over boxes.
#include "core/evaluate/affine_evaluator.h"

#include <cmath>
#include <map>
#include <QTest>

#include "core/evaluate/interval_evaluator.h"
#include "core/function/builtins/builtin.h"
#include "core/language/parse.h"
#include "tests/support/csv_table.h"
#include "tests/support/exact_evaluator.h"

using namespace isoscope;

namespace {

/// POV-Ray's last digits are its own: the tables agree with exact arithmetic to this much of max(1, |value|).
constexpr double tolerance = 1e-9;

/// Both enclosures of one function.
class Enclosures {
  public:
    Enclosures(const Function& function, std::span<const double> parameters)
        : function_(function),
          parameters_(parameters.begin(), parameters.end()),
          hasLoops_(!Tape::compile(function)->loops().empty()),
          intervals_(Tape::compile(function), parameters),
          forms_(Tape::compile(function), parameters) {}

    /// Over the box with half widths `reach` around the point.
    Interval interval(const std::array<double, 3>& point, double reach) {
        std::array<Interval, 3> box;
        for (int k = 0; k < 3; ++k) box[k] = Interval::point(point[k]) + Interval{-reach, reach, false};
        return intervals_.evaluate(box);
    }
    /// Along a line of that length on both sides of the point.
    Interval form(const std::array<double, 3>& point, double reach) {
        RayPieces pieces;
        constexpr std::array<double, 3> direction{0.6, -0.5, 0.7};
        for (int k = 0; k < 3; ++k) {
            pieces.origin[k].fill(point[k]);
            pieces.direction[k].fill(direction[k]);
        }
        pieces.start.fill(-reach);
        pieces.length.fill(2 * reach);
        std::array<AffineForm, 1> forms;
        forms_.evaluate(pieces, forms);
        const AffineForm& f = forms[0];
        if (f.e == -Interval::infinite) return Interval::undefined();
        if (!(f.e < Interval::infinite)) return Interval::unknown();
        // At the middle of the line.
        return {f.a - f.e, f.a + f.e, false};
    }

    /// Whether all values on the way to the result are finite: enclosures speak of real arithmetic.
    bool isRegular(const std::array<double, 3>& point) const {
        for (NodeId id = 0; id < function_.graph->size(); ++id)
            if ((*function_.graph).isConstant(id) && std::isinf((*function_.graph).value(id))) return false;
        if (hasLoops_) return true;
        std::vector<test::ExactNumber> arguments;
        for (const double coordinate : point) arguments.emplace_back(coordinate);
        bool regular = true;
        test::evaluateExactly(function_, arguments, parameters_, regular);
        return regular;
    }

  private:
    Function function_;
    std::vector<double> parameters_;
    bool hasLoops_;
    IntervalEvaluator intervals_;
    AffineEvaluator forms_;
};

struct Counts {
    int values = 0;
    int bounded = 0;  ///< enclosures of finite width
};

/// Empty when the value lies in all enclosures.
QString problem(Enclosures& enclosures, const std::array<double, 3>& point, double value, Counts& counts) {
    if (!enclosures.isRegular(point)) return {};
    const double slack = std::isfinite(value) ? tolerance * std::max(1.0, std::abs(value)) : 0;
    for (const double reach : {0.0, 1e-3, 0.3})
        for (const bool affine : {false, true}) {
            Interval range = affine ? enclosures.form(point, reach) : enclosures.interval(point, reach);
            ++counts.values;
            counts.bounded += range.width() < Interval::infinite;
            range.low -= slack;
            range.high += slack;
            if (!range.holds(value))
                return QString::asprintf(
                    "%.17g at %.17g %.17g %.17g is not in the %s [%.17g, %.17g] (maybe undefined: %d) with "
                    "reach %g",
                    value, point[0], point[1], point[2], affine ? "form" : "interval", range.low, range.high,
                    range.maybeUndefined, reach);
        }
    return {};
}

std::array<double, 3> pointOf(const test::CsvTable& table, std::size_t row) {
    return {table.number(row, "x"), table.number(row, "y"), table.number(row, "z")};
}

void checkExpressions(const QString& file, double leastShareBounded) {
    const test::CsvTable table(test::dataFile(file));
    std::map<std::pair<std::string, std::string>, std::unique_ptr<Enclosures>> known;
    Counts counts;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        const std::string &prelude = table.field(row, "prelude"),
                          &expression = table.field(row, "expression");
        // Rows with a head of their own or that POV-Ray refuses are tested elsewhere.
        if (prelude.rfind("function", 0) == 0 || !table.field(row, "error").empty()) continue;
        auto& enclosures = known[{prelude, expression}];
        if (!enclosures) {
            ParseOptions options;
            options.imageWidth = options.imageHeight = 1;
            options.noiseGenerator = 2;
            const ParsedFunction parsed = parseFunction(expression, prelude, options);
            QVERIFY2(parsed.ok(), expression.c_str());
            enclosures = std::make_unique<Enclosures>(parsed.value.function, parsed.parameterTable);
        }
        const QString found = problem(*enclosures, pointOf(table, row), table.number(row, "value"), counts);
        QVERIFY2(found.isEmpty(),
                 qPrintable(QString::fromStdString(prelude + " " + expression + ": ") + found));
    }
    qInfo("%s: %d enclosures, %d bounded", qPrintable(file), counts.values, counts.bounded);
    QVERIFY(counts.bounded > leastShareBounded * counts.values && counts.values > 1000);
}

Function builtinFunction(const Builtin& builtin, const std::vector<double>& parameters) {
    FunctionGraph graph;
    std::vector<Expression> arguments;
    for (int k = 0; k < builtin.pointArguments; ++k) arguments.emplace_back(graph, graph.variable(k));
    for (const double parameter : parameters) arguments.emplace_back(graph, graph.constant(parameter));
    const NodeId root = buildBuiltin(builtin, arguments, 2).node();
    return finish(std::move(graph), {root}, 3);
}

}  // namespace

class GoldenEnclosureTest : public QObject {
    Q_OBJECT

  private slots:
    void operators() { checkExpressions("golden/operators.csv", 0.5); }
    void seedExpressions() { checkExpressions("golden/seed_expressions.csv", 0.8); }

    void builtinFunctions() {
        const test::CsvTable table(test::dataFile("golden/functions.csv"));
        std::map<std::string, std::unique_ptr<Enclosures>> known;
        Counts counts;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const std::string& called = table.field(row, "function");
            const Builtin* builtin =
                called == "internal(77)" ? findBuiltin(77) : findBuiltin(std::string_view(called));
            QVERIFY2(builtin, called.c_str());
            if (builtin->pointArguments != 3) continue;
            std::vector<double> parameters;
            std::string key = builtin->name;
            for (std::size_t k = 0; k < builtin->parameters.size(); ++k) {
                const std::string column = "P" + std::to_string(k);
                parameters.push_back(table.number(row, column));
                key += " " + table.field(row, column);
            }
            auto& enclosures = known[key];
            if (!enclosures)
                enclosures = std::make_unique<Enclosures>(builtinFunction(*builtin, parameters),
                                                          std::span<const double>());
            const QString found =
                problem(*enclosures, pointOf(table, row), table.number(row, "value"), counts);
            QVERIFY2(found.isEmpty(), qPrintable(QString::fromStdString(key + ": ") + found));
        }
        qInfo("%d enclosures, %d bounded", counts.values, counts.bounded);
        QVERIFY(counts.bounded > 0.8 * counts.values && counts.values > 1000);
    }
};

QTEST_APPLESS_MAIN(GoldenEnclosureTest)
#include "golden_enclosure_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The interval test vectors of IEEE 1788 (tests/data/ieee1788), and intervals between edges of doubles with
// the tightest answers by MPFR: every operation encloses them, and how much wider it is is told.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <QFile>
#include <QTest>
#include <sstream>

#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/text/number_format.h"
#include "test_folders.h"
#include "tests/support/exact_range.h"
#include "tests/support/instruction_sets.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::map<std::string, Operation> operations{
    {"neg", Operation::negate},
    {"add", Operation::add},
    {"sub", Operation::subtract},
    {"mul", Operation::multiply},
    {"div", Operation::divide},
    {"pown", Operation::power},
    {"pow", Operation::power},
    {"exp", Operation::exponential},
    {"log", Operation::naturalLogarithm},
    {"log10", Operation::decimalLogarithm},
    {"sin", Operation::sine},
    {"cos", Operation::cosine},
    {"tan", Operation::tangent},
    {"atan2", Operation::arcTangent2},
    {"sinh", Operation::hyperbolicSine},
    {"cosh", Operation::hyperbolicCosine},
    {"tanh", Operation::hyperbolicTangent},
    {"asinh", Operation::areaSine},
    {"acosh", Operation::areaCosine},
    {"atanh", Operation::areaTangent},
    {"ceil", Operation::ceiling},
    {"floor", Operation::floor},
    {"trunc", Operation::truncate},
    {"abs", Operation::absolute},
    {"min", Operation::minimum},
    {"max", Operation::maximum},
};

/// One line of a file: an operation, its operands and the tightest result.
struct Vector {
    std::string text, operation;
    std::vector<Interval> operands;
    Interval result;
};

double numberOf(const std::string& text) {
    if (text == "inf" || text == "-inf") return text == "inf" ? infinity : -infinity;
    // Hexadecimal, too.
    return std::strtod(text.c_str(), nullptr);
}

/// `[1.0, 2.0]`, `[empty]`, `[entire]`, or a number that stands for itself.
Interval intervalOf(std::string text) {
    std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == ' '; });
    if (text == "empty") return Interval::undefined();
    if (text == "entire") return Interval::all();
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) return Interval::point(numberOf(text));
    return {numberOf(text.substr(0, comma)), numberOf(text.substr(comma + 1)), false};
}

/// The interval or number that begins at `at`, which moves behind it.
std::string nextOperand(const std::string& line, std::size_t& at) {
    while (line[at] == ' ') ++at;
    const std::size_t begin = at;
    at = line[at] == '[' ? line.find(']', at) + 1 : line.find_first_of(" ;", at);
    return line.substr(begin, at - begin);
}

std::vector<Vector> vectorsOf(const QString& name) {
    QFile file(QStringLiteral(ISOSCOPE_TEST_DATA "/ieee1788/") + name);
    std::vector<Vector> vectors;
    if (!file.open(QIODevice::ReadOnly)) return vectors;
    std::istringstream lines(file.readAll().toStdString());
    for (std::string line; std::getline(lines, line);) {
        if (!line.ends_with(';')) continue;
        Vector vector;
        vector.text = line.substr(line.find_first_not_of(' '));
        std::size_t at = vector.text.find(' ');
        vector.operation = vector.text.substr(0, at);
        const std::size_t equals = vector.text.find('=');
        while (vector.text.find_first_not_of(' ', at) < equals)
            vector.operands.push_back(intervalOf(nextOperand(vector.text, at)));
        at = equals + 1;
        vector.result = intervalOf(nextOperand(vector.text, at));
        vectors.push_back(vector);
    }
    return vectors;
}

/// Steps from one double to another, as far as they are to be told.
double stepsBetween(double a, double b) {
    if (a == b) return 0;
    if (std::isinf(a) || std::isinf(b)) return infinity;
    const double unit = std::max(std::nextafter(std::abs(a), infinity) - std::abs(a), 0x1p-1074);
    return std::abs(b - a) / unit;
}

/// What was seen of an operation.
struct Tightness {
    double steps = 0;                    ///< the most that an end is beyond the tightest one
    std::uint64_t count = 0, loose = 0;  ///< results with an end that is infinite and need not be

    void note(const Interval& tightest, const Interval& found) {
        ++count;
        if (tightest.empty() || found.empty()) return;
        const double most =
            std::max(stepsBetween(tightest.low, found.low), stepsBetween(tightest.high, found.high));
        if (std::isinf(most))
            ++loose;
        else
            steps = std::max(steps, most);
    }
};

/// atan2(0, 0) is 0, pow(0, 0) is 1 and atanh(1) infinite here, as in C; for IEEE 1788 they have no value.
bool hasMoreValues(Operation operation) {
    return operation == Operation::arcTangent2 || operation == Operation::power ||
           operation == Operation::areaTangent;
}

bool encloses(const Interval& found, const Interval& wanted) {
    if (wanted.empty()) return found.maybeUndefined;
    return found.low <= wanted.low && wanted.high <= found.high &&
           (found.maybeUndefined || !wanted.maybeUndefined);
}

QString told(const Interval& interval) {
    return QString::asprintf("[%.17g, %.17g]%s", interval.low, interval.high,
                             interval.maybeUndefined ? " or undefined" : "");
}

void tell(const std::map<std::string, Tightness>& seen) {
    for (const auto& [name, tightness] : seen)
        qInfo("%-8s %6llu results, at most %.3g steps wide beyond the tightest, %llu without an end",
              name.c_str(), static_cast<unsigned long long>(tightness.count), tightness.steps,
              static_cast<unsigned long long>(tightness.loose));
}

/// Tapes of one operation of x and y.
std::shared_ptr<const Tape> tapeOf(Operation operation) {
    FunctionGraph graph;
    const NodeId x = graph.variable(0);
    const NodeId root =
        arity(operation) == 1 ? graph.unary(operation, x) : graph.binary(operation, x, graph.variable(1));
    return Tape::compile(finish(std::move(graph), {root}, 3));
}

/// The smallest interval of doubles around a range.
Interval rounded(const ExactRange& range) {
    return {mpfr_get_d(range.low.get(), MPFR_RNDD), mpfr_get_d(range.high.get(), MPFR_RNDU),
            range.maybeUndefined};
}

/// Ends of intervals, where functions and doubles have their edges.
std::vector<double> edges(bool few) {
    constexpr double pi = std::numbers::pi;
    std::vector<double> positive{
        0x1p-1074, 1e-310, 0x1p-1022, 1e-100, 0.1, 0.5, 1,     1.5,
        pi / 2,    2,      pi,        10,     1e3, 1e9, 1e100, std::numeric_limits<double>::max()};
    if (!few)
        for (const double more : {1e-20,
                                  1e-8,
                                  0.25,
                                  std::nextafter(1.0, 0.0),
                                  std::nextafter(1.0, 2.0),
                                  std::nextafter(pi / 2, 2.0),
                                  std::nextafter(pi, 4.0),
                                  2.5,
                                  3 * pi / 2,
                                  2 * pi,
                                  7.0,
                                  32.0,
                                  25000.0,
                                  709.7,
                                  710.5,
                                  1e5,
                                  2147483647.0,
                                  2147483648.0,
                                  1e16,
                                  1e300})
            positive.push_back(more);
    std::vector<double> all{0};
    for (const double edge : positive) {
        all.push_back(edge);
        all.push_back(-edge);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<Interval> intervalsBetween(const std::vector<double>& ends, std::size_t stride) {
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t k = i; k < ends.size(); k += k == i ? 1 : stride)
            intervals.push_back({ends[i], ends[k], false});
    return intervals;
}

double middleOf(const Interval& a) { return std::clamp(a.low / 2 + a.high / 2, a.low, a.high); }

ExactJet jetOf(const Interval& interval) {
    return {{ExactNumber(interval.low), ExactNumber(interval.high)}, ExactRange::all(), false};
}

}  // namespace

class IntervalVectorsTest : public QObject {
    Q_OBJECT

  private slots:
    void vectorsOfIeee1788AreEnclosed() {
        const std::vector<Vector> vectors = vectorsOf("elementary.itl");
        QVERIFY2(vectors.size() > 200, qPrintable(QString::number(vectors.size())));
        std::map<std::string, Tightness> seen;
        for (const Vector& vector : vectors) {
            QVERIFY2(operations.contains(vector.operation), vector.text.c_str());
            const Operation operation = operations.at(vector.operation);
            QCOMPARE(vector.operands.size(), static_cast<std::size_t>(arity(operation)));
            const Interval found = evaluateOperation(operation, vector.operands);
            if (vector.result.empty() && hasMoreValues(operation)) continue;
            QVERIFY2(encloses(found, vector.result),
                     qPrintable((vector.text + " is ").c_str() + told(found)));
            seen[vector.operation].note(vector.result, found);
        }
        tell(seen);
        // The others may leave out that both operands are near 0 or infinite.
        for (const auto& [name, tightness] : seen)
            if (name != "atan2" && name != "div" && name != "pow" && name != "pown")
                QVERIFY2(tightness.steps <= 10, name.c_str());
    }

    /// The same with vector instructions, on every set of them.
    void vectorsAreEnclosedByBoxes() {
        for (const auto& [set, setName] : instructionSets()) {
            const ForcedInstructionSet forced(set);
            for (const Vector& vector : vectorsOf("elementary.itl")) {
                const bool empty =
                    std::ranges::any_of(vector.operands, [](const Interval& a) { return a.empty(); });
                const Operation operation = operations.at(vector.operation);
                if (empty || (vector.result.empty() && hasMoreValues(operation))) continue;
                BoxLanes boxes;
                for (std::size_t k = 0; k < vector.operands.size(); ++k) {
                    boxes.low[k][0] = vector.operands[k].low;
                    boxes.high[k][0] = vector.operands[k].high;
                }
                Interval found;
                BoxEvaluator(tapeOf(operation), {}).evaluate(boxes, {&found, 1});
                QVERIFY2(
                    encloses(found, vector.result),
                    qPrintable((std::string(setName) + ": " + vector.text + " is ").c_str() + told(found)));
            }
        }
    }

    void intervalsBetweenEdgesAreEnclosed_data() {
        QTest::addColumn<int>("number");
        for (int number = 0; number < operationCount; ++number) {
            const auto operation = static_cast<Operation>(number);
            if (arity(operation) == 1 || arity(operation) == 2)
                QTest::newRow(std::string(name(operation)).c_str()) << number;
        }
    }

    void intervalsBetweenEdgesAreEnclosed() {
        QFETCH(int, number);
        const auto operation = static_cast<Operation>(number);
        const bool unary = arity(operation) == 1;
        const std::vector<Interval> first = intervalsBetween(edges(!unary), unary ? 1 : 9);
        const std::vector<Interval> second = unary ? std::vector<Interval>{{0, 0, false}} : first;
        Tightness scalar;
        for (const Interval& a : first)
            for (const Interval& b : second) {
                const ExactJet x = jetOf(a), y = jetOf(b);
                const std::array<const ExactJet*, 2> operands{&x, &y};
                const Interval wanted =
                    rounded(enclose(operation, std::span(operands).first(unary ? 1 : 2)).value);
                const std::array both{a, b};
                const Interval found = evaluateOperation(operation, std::span(both).first(unary ? 1 : 2));
                const auto what = [&] {
                    return told(a) + ' ' + told(b) + ": " + told(found) + ", not " + told(wanted);
                };
                QVERIFY2(holdsPoints(found, operation, a, b), qPrintable(what()));
                if (isTightest(operation) && !found.empty())
                    QVERIFY2(encloses(found, wanted), qPrintable(what()));
                scalar.note(wanted, found);
            }
        tell({{std::string(name(operation)), scalar}});
    }

  private:
    /// Whether enclose() gives no number more than there is, but for the rounding.
    static bool isTightest(Operation operation) {
        static constexpr std::array loose{
            Operation::remainder, Operation::integerDivide, Operation::truncate,    Operation::power,
            Operation::divide,    Operation::fraction,      Operation::triangleWave};
        return std::ranges::find(loose, operation) == loose.end();
    }

    /// Points of the operands, exactly, are in the interval.
    static bool holdsPoints(const Interval& found, Operation operation, const Interval& a,
                            const Interval& b) {
        for (const double x : {a.low, middleOf(a), a.high})
            for (const double y : {b.low, middleOf(b), b.high}) {
                const std::array operands{ExactNumber(x), ExactNumber(y)};
                const ExactNumber value = evaluateExactly(
                    operation, std::span(operands).first(static_cast<std::size_t>(arity(operation))),
                    nullptr);
                if (value.isNan() || (mpfr_inf_p(value.get()) != 0)) {
                    if (value.isNan() && !found.maybeUndefined) return false;
                    continue;
                }
                if (mpfr_cmp_d(value.get(), found.low) < 0 || mpfr_cmp_d(value.get(), found.high) > 0)
                    return false;
            }
        return true;
    }
};

QTEST_APPLESS_MAIN(IntervalVectorsTest)
#include "interval_vectors_test.moc"

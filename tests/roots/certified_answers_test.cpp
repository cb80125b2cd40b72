// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures rest on: first roots of neighbouring lines, on every instruction set, confirmed line by line
// by intervals of 200 bits. ISOSCOPE_SEED asks for other functions, ISOSCOPE_PROOF_CHAINS for more of them.
#include <cmath>
#include <map>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/roots/certified/certified_root_finder.h"
#include "tests/roots/line_table.h"
#include "tests/support/exact_line.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t defaultSeed = 14142135;
constexpr double defaultLines = 4000;
constexpr std::size_t linesAtOnce = 80;

/// Functions without jumps and poles: where the sign changes there is a surface.
RandomFunctionSettings continuousFunctions() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    settings.operations = {Operation::negate,  Operation::absolute, Operation::square,
                           Operation::sine,    Operation::cosine,   Operation::arcTangent,
                           Operation::add,     Operation::subtract, Operation::multiply,
                           Operation::minimum, Operation::maximum,  Operation::hyperbolicTangent};
    return settings;
}

/// Rays of neighbouring pixels.
std::vector<LineQuery> neighbours(std::mt19937_64& random) {
    std::vector<LineQuery> lines(linesAtOnce);
    glm::dvec3 origin, direction, across, up;
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = uniform(random, -4, 4);
        direction[axis] = uniform(random, -1, 1);
        across[axis] = uniform(random, -0.01, 0.01);
        up[axis] = uniform(random, -0.01, 0.01);
    }
    for (std::size_t k = 0; k < lines.size(); ++k)
        lines[k] = {origin, direction + double(k % 8) * across + double(k / 8) * up, 0.5, 5};
    return lines;
}

struct Counts {
    std::map<Verdict, int> verdicts;
    int confirmed = 0, open = 0;
};

/// The answer of one line; empty if it is right.
QString check(ExactLine& exact, const LineQuery& line, const RootSettings& settings, Verdict verdict,
              double t, Counts& counts) {
    const double speed = std::hypot(line.direction.x, line.direction.y, line.direction.z);
    const double tolerance = settings.accuracy / speed, wall = 0.01 * tolerance;
    const int before = exact.signAt(line.near + wall);
    const bool hit = verdict == Verdict::certifiedHit;
    const double end = hit ? t - tolerance : line.far - wall;
    if (before == 0 || end <= line.near + wall) return {};
    const ExactLine::Answer answer = exact.hasSign(before, line.near + wall, end);
    if (answer == ExactLine::Answer::no) return "the sign changes before";
    if (hit && exact.signAt(t + tolerance) == before && t + tolerance < line.far) {
        // Another root may be as near behind.
        bool changes = false;
        for (int k = -16; k <= 16; ++k) changes |= exact.signAt(t + k * tolerance / 16) == -before;
        if (!changes) return "no sign changes at the root";
    }
    ++(answer == ExactLine::Answer::yes ? counts.confirmed : counts.open);
    return {};
}

}  // namespace

class CertifiedAnswersTest : public QObject {
    Q_OBJECT

  private slots:
    void certifiedAnswersAreConfirmed() {
        const std::uint64_t seed = seedSetting(defaultSeed);
        const double wanted = setting("ISOSCOPE_PROOF_CHAINS", defaultLines);
        qInfo("seed %llu, %g lines", static_cast<unsigned long long>(seed), wanted);
        std::mt19937_64 random(seed);
        RandomFunctionSettings kind = continuousFunctions();
        const auto sets = instructionSets();
        Counts counts;
        std::size_t graph = 0;
        for (double searched = 0; searched < wanted; searched += double(linesAtOnce), ++graph) {
            const ForcedInstructionSet forced(sets[graph % sets.size()].first);
            kind.nodes = 4 + static_cast<int>(random() % 20);
            Function function = randomFunction(random, kind);
            function.results.resize(1);
            const std::vector<LineQuery> lines = neighbours(random);
            RootSettings settings;
            settings.open = true;
            const glm::dvec3 p = lines[30].origin + uniform(random, 0.5, 5) * lines[30].direction;
            const double value = ReferenceEvaluator(function).evaluate(std::array{p.x, p.y, p.z}, {});
            settings.threshold = std::isfinite(value) ? value + uniform(random, -0.01, 0.01) : 0;

            CertifiedRootFinder finder(Tape::compile(function), {}, settings);
            const LineTable table(lines);
            FirstRoots roots;
            RootRequest request;
            request.sufficient = 0;
            finder.findFirst(table.columns(), request, roots);
            std::vector<double> t(lines.size(), NAN);
            for (std::size_t k = 0; k < lines.size(); ++k)
                if (roots.crossings[FirstRoots::t][k] < INFINITY) t[k] = roots.crossings[FirstRoots::t][k];
            for (const FirstRoots::Other& other : roots.others) t[other.line] = other.root.t;
            for (std::size_t k = 0; k < lines.size(); ++k) {
                const Verdict verdict = finder.verdicts()[k];
                ++counts.verdicts[verdict];
                if (verdict > Verdict::certifiedMiss) continue;
                QCOMPARE(std::isnan(t[k]), verdict == Verdict::certifiedMiss);
                ExactLine exact(function, {}, lines[k], settings.threshold);
                const QString problem = check(exact, lines[k], settings, verdict, t[k], counts);
                QVERIFY2(problem.isEmpty(),
                         qPrintable(QString::asprintf("graph %zu, line %zu, %s, %s at %.17g: ", graph, k,
                                                      sets[graph % sets.size()].second, name(verdict), t[k]) +
                                    problem + "\n" + QString::fromStdString(describe(function))));
            }
        }
        for (const auto& [verdict, count] : counts.verdicts) qInfo("%s: %d", name(verdict), count);
        qInfo("%d confirmed, %d open", counts.confirmed, counts.open);
        QVERIFY(counts.open * 20 < counts.confirmed);
    }
};

QTEST_APPLESS_MAIN(CertifiedAnswersTest)
#include "certified_answers_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of the certified root finder are followed by enclosures at 200 bits that share nothing with
// core/evaluate: over the hard rays, and random functions. ISOSCOPE_PROOF_CHAINS asks for another number of
// lines and ISOSCOPE_SEED for other functions.
#include "core/roots/certified/proof_recorder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/language/parse.h"
#include "core/roots/certified/certified_root_finder.h"
#include "test_folders.h"
#include "tests/roots/hard_ray.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/proof_follower.h"
#include "tests/support/random_function.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr std::uint64_t defaultSeed = 27182818;
constexpr double defaultChains = 400;

struct Counts {
    FollowedSteps steps;
    std::map<Verdict, int> verdicts;
    std::uint64_t lines = 0, uncovered = 0;
};

/// Every operation that the checker has a rule for.
RandomFunctionSettings coveredOperations() {
    RandomFunctionSettings settings;
    settings.loops = false;
    settings.parameters = 0;
    for (int k = 0; k < operationCount; ++k)
        if (hasExactRule(static_cast<Operation>(k))) settings.operations.push_back(static_cast<Operation>(k));
    return settings;
}

/// One line searched and followed; empty if all is as claimed.
QString follow(const Function& function, const std::shared_ptr<const Tape>& tape,
               std::span<const double> parameters, const LineQuery& line, const RootSettings& settings,
               Counts& counts) {
    CertifiedRootFinder finder(tape, parameters, settings);
    finder.listPoles();
    ProofRecorder recorder;
    finder.recordInto(recorder);
    RootList roots;
    finder.find(std::span(&line, 1), {}, {&roots, 1});
    ++counts.lines;
    ++counts.verdicts[finder.verdicts()[0]];
    ExactLine exact(function, parameters, line, settings.threshold);
    if (!exact.isCovered()) {
        ++counts.uncovered;
        return {};
    }
    return followProof({line, settings, recorder.steps(), roots, finder.verdicts()[0]}, exact, counts.steps);
}

/// About the value of the function somewhere on the line, for there to be roots; 0 where it has none.
double valueOn(const LineQuery& line, const Function& function, std::mt19937_64& random) {
    const glm::dvec3 p = line.origin + uniform(random, line.near, line.far) * line.direction;
    const double value = ReferenceEvaluator(function).evaluate(std::array{p.x, p.y, p.z}, {});
    return std::isfinite(value) ? value + uniform(random, -0.1, 0.1) : 0;
}

void tell(const Counts& counts) {
    qInfo("%llu lines: %llu steps confirmed, %llu open; %llu lines without rules",
          static_cast<unsigned long long>(counts.lines),
          static_cast<unsigned long long>(counts.steps.confirmed),
          static_cast<unsigned long long>(counts.steps.open),
          static_cast<unsigned long long>(counts.uncovered));
    for (const auto& [verdict, count] : counts.verdicts) qInfo("%s: %d", name(verdict), count);
}

}  // namespace

class ProofChainTest : public QObject {
    Q_OBJECT

  private slots:
    void chainsOfHardRaysAreFollowed() {
        // The whole table where many lines are asked for.
        const bool all = qEnvironmentVariableIsSet("ISOSCOPE_PROOF_CHAINS");
        const isoscope::test::CsvTable table(all ? dataFile("hard/rays.csv")
                                                 : QStringLiteral(ISOSCOPE_TEST_DATA "/hard/rays.csv"));
        QVERIFY(table.rowCount() >= 285);
        Counts counts;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const HardRay ray(table, row);
            const ParsedFunction parsed = parseFunction(table.field(row, "function"));
            QVERIFY(parsed.ok());
            RootSettings settings = ray.settings();
            settings.maxTrace = 10;
            const QString problem = follow(parsed.value.function, Tape::compile(parsed.value.function),
                                           parsed.parameterTable, ray.line(), settings, counts);
            QVERIFY2(problem.isEmpty(), qPrintable(ray.text("case_id") + ": " + problem));
        }
        tell(counts);
        QVERIFY(counts.uncovered == 0);
        QVERIFY(counts.steps.open * 20 < counts.steps.confirmed);
    }

    /// What is changed in a proof is found.
    void falseProofsAreRefused_data() {
        QTest::addColumn<QString>("change");
        for (const char* change : {"none", "sign", "hole", "reach", "form", "error", "no root", "verdict"})
            QTest::newRow(change) << QString(change);
    }

    void falseProofsAreRefused() {
        QFETCH(QString, change);
        const ParsedFunction parsed = parseFunction("x*x+y*y+z*z-1");
        const LineQuery line{{-5, 0.1, 0.2}, {1, 0, 0}, 3.2, 6.8};
        RootSettings settings;
        settings.open = true;
        settings.maxTrace = 10;
        CertifiedRootFinder finder(Tape::compile(parsed.value.function), parsed.parameterTable, settings);
        ProofRecorder recorder;
        finder.recordInto(recorder);
        RootList roots;
        finder.find(std::span(&line, 1), {}, {&roots, 1});
        QCOMPARE(roots.size(), 2u);
        std::vector<ProofStep> steps = recorder.steps();
        Verdict verdict = finder.verdicts()[0];
        const auto root = std::ranges::find(steps, ProofRule::crossing, &ProofStep::rule);
        QVERIFY(root != steps.end() && steps.front().rule == ProofRule::form);
        ProofStep& first = steps.front();
        if (change == "sign") first.sign = -1;
        if (change == "hole") first.from = std::nextafter(first.from, 9);
        if (change == "reach") std::prev(root)->to = root->to;
        if (change == "form") first.center += 0.01 + 2 * first.error;
        if (change == "error") first.error /= 100;
        if (change == "no root") steps.erase(root);
        if (change == "verdict") verdict = Verdict::certifiedMiss;
        ExactLine exact(parsed.value.function, parsed.parameterTable, line, 0);
        FollowedSteps counts;
        const QString problem = followProof({line, settings, steps, roots, verdict}, exact, counts);
        QVERIFY2(problem.isEmpty() == (change == "none"), qPrintable(problem));
    }

    /// Lines that are searched together are written down as each alone, in another order.
    void severalLinesAreWrittenDownAsEachAlone() {
        const ParsedFunction parsed = parseFunction("x*x+y*y+z*z-1+0.3*sin(9*x)*floor(y)");
        std::vector<LineQuery> lines;
        for (int k = 0; k < 5; ++k)
            lines.push_back({{-5, 0.1 + 0.2 * k, 0.2 - 0.1 * k}, {1, 0.01 * k, 0}, 3.2 - 0.1 * k, 6.8});
        RootSettings settings;
        settings.open = true;
        settings.maxTrace = 10;
        const auto stepsOf = [&](std::span<const LineQuery> some) {
            CertifiedRootFinder finder(Tape::compile(parsed.value.function), parsed.parameterTable, settings);
            ProofRecorder recorder;
            finder.recordInto(recorder);
            std::vector<RootList> roots(some.size());
            finder.find(some, {}, roots);
            std::vector<std::array<double, 9>> steps;
            for (const ProofStep& step : recorder.steps())
                steps.push_back({static_cast<double>(step.rule), step.from, step.to,
                                 static_cast<double>(step.sign), step.start, step.length, step.center,
                                 step.slope, step.error});
            return steps;
        };
        std::vector<std::array<double, 9>> together = stepsOf(lines), apart;
        for (const LineQuery& line : lines) {
            const auto steps = stepsOf(std::span(&line, 1));
            QVERIFY(!steps.empty());
            apart.insert(apart.end(), steps.begin(), steps.end());
        }
        std::ranges::sort(together);
        std::ranges::sort(apart);
        QCOMPARE(together.size(), apart.size());
        QVERIFY(together == apart);
    }

    /// A bug once: where the piece with the last root went on to the end of the line, the part behind the
    /// root ended at the rounded sum of the piece's start and length, a unit short of it.
    void thePartBehindTheLastRootEndsWithTheLine() {
        const ParsedFunction parsed = parseFunction("z-floor(z)");
        const LineQuery line{{2.6456910186592415, 2.7275056828422581, 3.4786511434867009},
                             {-0.77043117167422936, 0.78891637946981974, 0.30236210414389908},
                             0.26735351691819842,
                             3.9422258236732595};
        RootSettings settings;
        settings.open = true;
        settings.maxTrace = 10;
        settings.threshold = 0.36652065277207041;
        Counts counts;
        const QString problem =
            follow(parsed.value.function, Tape::compile(parsed.value.function), {}, line, settings, counts);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
        QCOMPARE(counts.verdicts[Verdict::certifiedHit], 1);
    }

    /// A bug once: parts too short to be looked at were taken for parts that are not there, and what neither
    /// side of two jumps at one place has was told as two roots, 4e-15 apart.
    void partsThatAreLeftOutTellNoSign() {
        const ParsedFunction parsed =
            parseFunction("floor(mod(mod(z,-0.010949453909553026),-0.010949453909553026))");
        const LineQuery line{{-1.2463851663396737, -0.98355888153129234, 1.4249026396334905},
                             {-0.92717220580566106, -0.055777150381258411, -0.78331043392620237},
                             0.53699097795416939,
                             3.5832071325803825};
        RootSettings settings;
        settings.open = true;
        settings.maxTrace = 10;
        settings.threshold = -0.9589363135541028;
        Counts counts;
        const QString problem =
            follow(parsed.value.function, Tape::compile(parsed.value.function), {}, line, settings, counts);
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
    }

    void chainsOfRandomFunctionsAreFollowed() {
        const std::uint64_t seed = seedSetting(defaultSeed);
        const double wanted = setting("ISOSCOPE_PROOF_CHAINS", defaultChains);
        qInfo("seed %llu, %g lines", static_cast<unsigned long long>(seed), wanted);
        std::mt19937_64 random(seed);
        RandomFunctionSettings settings = coveredOperations();
        Counts counts;
        for (double graph = 0; static_cast<double>(counts.lines) < wanted; ++graph) {
            settings.nodes = 1 + static_cast<int>(random() % 12);
            Function function = randomFunction(random, settings);
            function.results.resize(1);
            const auto tape = Tape::compile(function);
            for (int k = 0; k < 5; ++k) {
                LineQuery line;
                for (int axis = 0; axis < 3; ++axis) {
                    line.origin[axis] = uniform(random, -4, 4);
                    line.direction[axis] = uniform(random, -1, 1);
                }
                line.near = uniform(random, 0, 1);
                line.far = line.near + uniform(random, 0, 6);
                RootSettings of;
                of.threshold = valueOn(line, function, random);
                of.open = true;
                of.maxTrace = 10;
                const QString problem = follow(function, tape, {}, line, of, counts);
                QVERIFY2(problem.isEmpty(),
                         qPrintable(
                             QString::asprintf("graph %g, line %d: ", graph, k) + problem + "\n" +
                             QString::asprintf("from (%.17g, %.17g, %.17g) along (%.17g, %.17g, %.17g), "
                                               "threshold %.17g\n",
                                               line.origin.x, line.origin.y, line.origin.z, line.direction.x,
                                               line.direction.y, line.direction.z, of.threshold) +
                             QString::fromStdString(describe(function))));
            }
        }
        tell(counts);
        QVERIFY(counts.steps.open * 10 < counts.steps.confirmed);
    }
};

QTEST_APPLESS_MAIN(ProofChainTest)
#include "proof_chain_test.moc"

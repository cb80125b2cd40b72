// SPDX-License-Identifier: GPL-3.0-or-later
// What `roots --proof` writes is enough for others to follow: read back from the files, and checked by
// arithmetic of 200 bits.
#include <cmath>
#include <map>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"
#include "test_folders.h"
#include "tests/roots/hard_ray.h"
#include "tests/support/program.h"
#include "tests/support/proof_follower.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::map<std::string, ProofRule> rules{
    {"form", ProofRule::form},     {"cases", ProofRule::cases},     {"undefined", ProofRule::undefined},
    {"passed", ProofRule::passed}, {"sampled", ProofRule::sampled}, {"crossing", ProofRule::crossing},
    {"jump", ProofRule::jump},     {"pole", ProofRule::pole}};
const std::map<std::string, Verdict> verdicts{{"certified-hit", Verdict::certifiedHit},
                                              {"certified-miss", Verdict::certifiedMiss},
                                              {"gap", Verdict::gap},
                                              {"budget-exceeded", Verdict::budgetExceeded},
                                              {"not-certified", Verdict::notCertified}};

/// The steps of each case of a proof.
std::map<std::string, std::vector<ProofStep>> stepsOf(const isoscope::CsvTable& table) {
    std::map<std::string, std::vector<ProofStep>> all;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        const auto number = [&](const char* column) { return table.number(row, column, 0); };
        ProofStep step;
        step.rule = rules.at(table.field(row, "rule"));
        step.from = number("from"), step.to = number("to");
        step.sign = static_cast<int>(number("sign"));
        step.start = number("start"), step.length = number("length");
        step.center = number("center"), step.slope = number("slope"), step.error = number("error");
        all[table.field(row, "case_id")].push_back(step);
    }
    return all;
}

/// The events of a row of the answer, as roots.
RootList rootsOf(const std::string& events) {
    RootList roots;
    for (const QString& event : QString::fromStdString(events).split(';', Qt::SkipEmptyParts))
        roots.push_back({event.section(':', 0, 0).toDouble(), RootKind::crossing});
    return roots;
}

}  // namespace

class RootsProofTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const QByteArray header_ = "case_id,function,threshold,container,ox,oy,oz,dx,dy,dz\n";

    QString table(const QByteArray& rows) { return writeFile(folder_.path(), "rays.csv", header_ + rows); }
    isoscope::CsvTable tableIn(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? isoscope::CsvTable::parse(file.readAll().toStdString())
                                              : isoscope::CsvTable();
    }

  private slots:
    void proofsOfHardRaysAreFollowed() {
        const QString rays = QStringLiteral(ISOSCOPE_TEST_DATA "/hard/rays.csv");
        const QString proof = folder_.filePath("proof.csv");
        const ProgramResult result = runCli({"roots", "--table", rays, "--proof", proof});
        QVERIFY2(result.status == 0, result.errors);
        const isoscope::CsvTable answers = tableOf(result);
        const std::map<std::string, std::vector<ProofStep>> steps = stepsOf(tableIn(proof));
        const isoscope::test::CsvTable table(rays);
        QCOMPARE(answers.rowCount(), table.rowCount());
        FollowedSteps counts;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const HardRay ray(table, row);
            const std::string id = table.field(row, "case_id");
            const ParsedFunction parsed = parseFunction(table.field(row, "function"));
            ExactLine line(parsed.value.function, parsed.parameterTable, ray.line(), ray.number("threshold"));
            QVERIFY(line.isCovered());
            RootSettings settings = ray.settings();
            settings.maxTrace = 100000;
            const auto found = steps.find(id);
            const std::vector<ProofStep> none;
            const QString problem =
                followProof({ray.line(), settings, found == steps.end() ? none : found->second,
                             rootsOf(answers.field(row, "roots")), verdicts.at(answers.field(row, "kind"))},
                            line, counts);
            QVERIFY2(problem.isEmpty(), qPrintable(ray.text("case_id") + ": " + problem));
        }
        qInfo("%llu steps confirmed, %llu open", static_cast<unsigned long long>(counts.confirmed),
              static_cast<unsigned long long>(counts.open));
        QVERIFY(counts.confirmed > 2000 && counts.open * 20 < counts.confirmed);
    }

    void aProofHoldsEveryRow() {
        const QString proof = folder_.filePath("two.csv");
        const ProgramResult result = runCli({"roots", "--table",
                                             table("a,x*x+y*y+z*z-1,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0\n"
                                                   "b,x*x+y*y+z*z+1,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0\n"),
                                             "--proof", proof});
        QVERIFY2(result.status == 0, result.errors);
        const auto steps = stepsOf(tableIn(proof));
        QCOMPARE(steps.size(), 2u);
        const auto& ball = steps.at("a");
        QCOMPARE(std::ranges::count(ball, ProofRule::crossing, &ProofStep::rule), 2);
        const auto& nothing = steps.at("b");
        QVERIFY(std::ranges::all_of(nothing, [](const ProofStep& step) {
            return step.rule == ProofRule::form && step.sign == 1 && step.center > step.error;
        }));
        QCOMPARE(nothing.front().from, 3.0);
        QCOMPARE(nothing.back().to, 7.0);
    }

    void answersAreTheSameWithAProof() {
        const QString rays = QStringLiteral(ISOSCOPE_TEST_DATA "/hard/rays.csv");
        const ProgramResult with =
            runCli({"roots", "--table", rays, "--proof", folder_.filePath("same.csv")});
        QCOMPARE(with.output, runCli({"roots", "--table", rays}).output);
    }

    void itReplacesProofsAlone() {
        const QString rays = table("a,x,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0\n");
        const QString foreign = writeFile(folder_.path(), "foreign.csv", "precious,data\n1,2\n");
        const ProgramResult refused = runCli({"roots", "--table", rays, "--proof", foreign});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.errors.contains("is no table of proofs"), refused.errors);
        QFile file(foreign);
        QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().startsWith("precious"));
        QCOMPARE(runCli({"roots", "--table", rays, "--proof", rays, "--force"}).status, 1);
        const QString proof = folder_.filePath("again.csv");
        for (int round = 0; round < 2; ++round)
            QCOMPARE(runCli({"roots", "--table", rays, "--proof", proof}).status, 0);
        QCOMPARE(runCli({"roots", "--table", rays, "--proof", foreign, "--force"}).status, 0);
    }

    void povraysMethodProvesNothing() {
        const ProgramResult result =
            runCli({"roots", "--table", table("a,x,0,\"sphere{<0,0,0>,2}\",-5,0,0,1,0,0\n"), "--proof",
                    folder_.filePath("none.csv"), "--solver", "lipschitz"});
        QCOMPARE(result.status, 2);
        QVERIFY2(result.errors.contains("proves nothing"), result.errors);
    }
};

QTEST_GUILESS_MAIN(RootsProofTest)
#include "roots_proof_test.moc"

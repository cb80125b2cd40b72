// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/view/explained_search.h"

#include <cmath>
#include <QTest>
#include <random>

#include "core/language/parse.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "core/roots/lipschitz/tape_field.h"

using namespace isoscope;

namespace {

/// Notes the parameters at which the root finder looks.
class RecordingField : public FieldFunction {
  public:
    RecordingField(TapeField field, const LineQuery& line, std::vector<double>& visited)
        : field_(std::move(field)), line_(line), visited_(visited) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        field_.values(x, y, z, out);
        const double square = glm::dot(line_.direction, line_.direction);
        for (std::size_t i = 0; i < out.size(); ++i)
            visited_.push_back(glm::dot(glm::dvec3(x[i], y[i], z[i]) - line_.origin, line_.direction) /
                               square);
    }

  private:
    TapeField field_;
    LineQuery line_;
    std::vector<double>& visited_;
};

struct Compiled {
    std::shared_ptr<const Tape> tape;
    std::vector<double> parameters;
};

Compiled function(const std::string& text) {
    const ParsedFunction parsed = parseFunction(text, "");
    if (!parsed.ok()) qFatal("%s", parsed.diagnostics.front().message.c_str());
    return {Tape::compile(parsed.value.function), parsed.parameterTable};
}

ExplainedSearch explain(const Compiled& f, const LineQuery& line, const RootSettings& settings) {
    TapeField field(f.tape, f.parameters);
    return explainSearch(line, settings, [&](double t) {
        const glm::dvec3 p = line.origin + t * line.direction;
        double value = 0;
        field.values(std::span(&p.x, 1), std::span(&p.y, 1), std::span(&p.z, 1), std::span(&value, 1));
        return value;
    });
}

}  // namespace

class ExplainedSearchTest : public QObject {
    Q_OBJECT

  private slots:
    void itDoesWhatTheRootFinderDoes() {
        constexpr std::uint32_t seed = 20260107;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        const std::vector<Compiled> functions{function("x*x + y*y + z*z - 0.5"),
                                              function("sin(9*x)*cos(7*y) + z"),
                                              function("f_noise3d(5*x, 5*y, 5*z) - 0.5"),
                                              function("sqrt(x - 0.3) - 0.4"), function("floor(3*x) + y")};
        std::size_t crossings = 0;
        for (int round = 0; round < 400; ++round) {
            const Compiled& f = functions[static_cast<std::size_t>(round) % functions.size()];
            RootSettings settings;
            settings.accuracy = std::pow(10.0, -2.5 + 1.5 * number(random));
            settings.maxGradient = std::pow(10.0, number(random));
            settings.open = round % 3 == 0;
            settings.maxTrace = 1 + round % 4;
            settings.positivePolarity = round % 7 == 0;
            settings.threshold = 0.1 * number(random);
            if (round % 5 == 4) settings.evaluate = {{settings.maxGradient, 1.4, 0.99}};
            const LineQuery line{{number(random), number(random), -2 + number(random)},
                                 {0.3 * number(random), 0.3 * number(random), 1 + 0.5 * number(random)},
                                 round % 11 == 0 ? 0 : 0.7,
                                 3};
            const ExplainedSearch explained = explain(f, line, settings);
            std::vector<double> visited;
            LipschitzRootFinder finder(
                std::make_unique<RecordingField>(TapeField(f.tape, f.parameters), line, visited), settings);
            RootList roots;
            finder.find(std::span(&line, 1), {}, std::span(&roots, 1));
            const QByteArray where = QByteArrayLiteral("seed ") + QByteArray::number(seed) + ", round " +
                                     QByteArray::number(round);
            QVERIFY2(explained.roots == roots, where.constData());
            QVERIFY2(explained.visited.size() == visited.size(), where.constData());
            for (std::size_t i = 0; i < visited.size(); ++i)
                QVERIFY2(std::abs(explained.visited[i].t - visited[i]) < 1e-9, where.constData());
            crossings += roots.size();
        }
        QVERIFY(crossings > 100);
    }

    void intervalsAreInOrderAndDoNotOverlap() {
        RootSettings settings;
        settings.maxGradient = 9;
        settings.maxTrace = 10;
        const ExplainedSearch explained =
            explain(function("sin(9*z)"), {{0, 0, -1}, {0, 0, 1}, 0.01, 2}, settings);
        QVERIFY(explained.complete && explained.intervals.size() > 10);
        for (std::size_t i = 1; i < explained.intervals.size(); ++i)
            QVERIFY(explained.intervals[i].low >= explained.intervals[i - 1].high);
    }

    void undefinedEndsAreNamed() {
        RootSettings settings;
        const ExplainedSearch explained =
            explain(function("sqrt(z)"), {{0, 0, -1}, {0, 0, 1}, 0.01, 2}, settings);
        QVERIFY(!explained.intervals.empty());
        QCOMPARE(explained.intervals.front().fate, IntervalFate::undefined);
    }

    void thereIsAnEnd() {
        RootSettings settings;
        settings.accuracy = 1e-12;
        settings.maxGradient = 1e12;
        const ExplainedSearch explained =
            explain(function("z + 2"), {{0, 0, -1}, {0, 0, 1}, 0.01, 2}, settings);
        QVERIFY(!explained.complete);
        QVERIFY(explained.visited.size() <= explainedPointLimit + 4);
    }
};

QTEST_APPLESS_MAIN(ExplainedSearchTest)
#include "explained_search_test.moc"

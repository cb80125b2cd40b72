// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/function/patterns/pattern.h"

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <QTest>

#include "core/evaluate/reference_evaluator.h"
#include "core/function/builtins/builtin.h"
#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

Function functionOf(const std::function<Expression(Expression, Expression, Expression)>& build) {
    FunctionGraph graph;
    const Expression x(graph, graph.variable(0)), y(graph, graph.variable(1)), z(graph, graph.variable(2));
    const Expression value = build(x, y, z);
    return finish(std::move(graph), {value.node()}, 3);
}

Function patternFunction(const Pattern& pattern, int generator = 2) {
    return functionOf(
        [&](Expression x, Expression y, Expression z) { return buildPattern(pattern, x, y, z, generator); });
}

Function builtinFunction(const Builtin& builtin, int generator) {
    return functionOf([&](Expression x, Expression y, Expression z) {
        const Expression arguments[] = {x, y, z};
        return buildBuiltin(builtin, arguments, generator);
    });
}

double valueAt(const Function& function, double x, double y, double z) {
    return ReferenceEvaluator(function).evaluate(std::vector<double>{x, y, z});
}

QString describe(const test::CsvTable& table, std::size_t row, double got) {
    QString text = QStringLiteral("row %1: got %2").arg(row + 2).arg(got, 0, 'g', 17);
    for (const char* column : {"noise_generator", "definition", "x", "y", "z", "value"})
        text += QStringLiteral(", %1 %2").arg(column, QString::fromStdString(table.field(row, column)));
    return text;
}

/// Patterns of golden/patterns.csv whose modifiers are written out here, without a parser.
std::map<std::string, Pattern> modifiedPatterns() {
    std::map<std::string, Pattern> all;
    const auto add = [&](const char* definition, PatternKind kind) -> Pattern& {
        Pattern& pattern = all[definition];
        pattern.kind = kind;
        return pattern;
    };
    add("pattern { crackle form <0.371,-0.146,-0.215> }", PatternKind::crackle).crackle.form = {0.371, -0.146,
                                                                                                -0.215};
    add("pattern { crackle metric 1.48 }", PatternKind::crackle).crackle.metric = 1.48;
    add("pattern { crackle offset 0.526 }", PatternKind::crackle).crackle.offset = 0.526;
    add("pattern { crackle solid }", PatternKind::crackle).crackle.solid = true;
    add("pattern { crackle turbulence 0.724 }", PatternKind::crackle).turbulence = {0.724, 0.724, 0.724};
    add("pattern { agate agate_turb 0.181 }", PatternKind::agate).agateTurbulence = 0.181;
    Pattern& brick = add("pattern { brick brick_size <0.58,1.38,0.92> mortar 0.157 }", PatternKind::brick);
    brick.brickSize = {0.58, 1.38, 0.92};
    brick.mortar = 0.157;
    add("pattern { hexagon }", PatternKind::hexagon);
    add("pattern { radial frequency 6 }", PatternKind::radial).frequency = 6;
    add("pattern { gradient <1.58,0.0628,0.936> }", PatternKind::gradient).gradient = {1.58, 0.0628, 0.936};
    add("pattern { spiral1 5 }", PatternKind::spiral1).arms = 5;
    add("pattern { spiral2 3 }", PatternKind::spiral2).arms = 3;
    add("pattern { mandel 50 }", PatternKind::mandel).iterations = 50;
    Pattern& ripples = add("pattern { ripples frequency 2 phase 0.3 }", PatternKind::ripples);
    ripples.frequency = 2;
    ripples.phase = 0.3;
    add("pattern { waves frequency 2.62 }", PatternKind::waves).frequency = 2.62;
    add("pattern { granite noise_generator 3 }", PatternKind::granite).noiseGenerator = 3;
    add("pattern { wrinkles noise_generator 1 }", PatternKind::wrinkles).noiseGenerator = 1;
    add("pattern { agate noise_generator 3 }", PatternKind::agate).noiseGenerator = 3;
    add("pattern { marble turbulence 0.958 }", PatternKind::marble).turbulence = {0.958, 0.958, 0.958};
    add("pattern { wood turbulence 0.187 }", PatternKind::wood).turbulence = {0.187, 0.187, 0.187};
    Pattern& bozo =
        add("pattern { bozo turbulence 0.348 octaves 3 omega 0.314 lambda 2.05 }", PatternKind::bozo);
    bozo.turbulence = {0.348, 0.348, 0.348};
    bozo.octaves = 3;
    bozo.omega = 0.314;
    bozo.lambda = 2.05;
    add("pattern { onion turbulence <0.837,0.807,0.22> }", PatternKind::onion).turbulence = {0.837, 0.807,
                                                                                             0.22};
    const auto wave = [&](const char* definition, PatternKind kind, WaveForm form, double frequency,
                          double phase, double exponent) {
        Pattern& pattern = add(definition, kind);
        pattern.wave = form;
        pattern.frequency = frequency;
        pattern.phase = phase;
        pattern.waveExponent = exponent;
    };
    wave("pattern { gradient x sine_wave }", PatternKind::gradient, WaveForm::sine, 1, 0, 1);
    wave("pattern { onion triangle_wave frequency 1.79 phase -0.513 }", PatternKind::onion,
         WaveForm::triangle, 1.79, -0.513, 1);
    wave("pattern { onion scallop_wave frequency 0.137 phase -0.431 }", PatternKind::onion, WaveForm::scallop,
         0.137, -0.431, 1);
    wave("pattern { onion cubic_wave frequency -2.78 phase 0.506 }", PatternKind::onion, WaveForm::cubic,
         -2.78, 0.506, 1);
    wave("pattern { onion poly_wave 3.63 frequency -0.313 phase 0.0874 }", PatternKind::onion, WaveForm::poly,
         -0.313, 0.0874, 3.63);
    wave("pattern { onion ramp_wave frequency 2.04 phase 0.882 }", PatternKind::onion, WaveForm::ramp, 2.04,
         0.882, 1);
    add("pattern { cells }", PatternKind::cells);
    add("pattern { cubic }", PatternKind::cubic);
    add("pattern { quilted }", PatternKind::quilted);
    Pattern& quilted = add("pattern { quilted control0 0.678 control1 0.19 }", PatternKind::quilted);
    quilted.control0 = 0.678;
    quilted.control1 = 0.19;
    return all;
}

/// The fractal ones of them.
std::map<std::string, Pattern> fractalPatterns() {
    std::map<std::string, Pattern> all;
    const auto add = [&](const char* definition, PatternKind kind, int iterations) -> Pattern& {
        Pattern& pattern = all[definition];
        pattern.kind = kind;
        pattern.iterations = iterations;
        return pattern;
    };
    add("pattern { mandel 12 exterior 1, 0.324 }", PatternKind::mandel, 12).exterior = {1, 0.324};
    add("pattern { mandel 12 interior 1, 0.393 }", PatternKind::mandel, 12).interior = {1, 0.393};
    Pattern& both = add("pattern { mandel 12 exterior 2, 1 interior 2, 1 }", PatternKind::mandel, 12);
    both.exterior = both.interior = {2, 1};
    add("pattern { mandel 10 exponent 3 }", PatternKind::mandel, 10).exponent = 3;
    add("pattern { julia <0.353,0.288>, 25 }", PatternKind::julia, 25).juliaPoint = {0.353, 0.288};
    add("pattern { julia <-0.491,0.0776>, 15 }", PatternKind::julia, 15).juliaPoint = {-0.491, 0.0776};
    Pattern& cube =
        add("pattern { julia <0.158,-0.147>, 15 exponent 3 exterior 4, 1 }", PatternKind::julia, 15);
    cube.juliaPoint = {0.158, -0.147};
    cube.exponent = 3;
    cube.exterior = {4, 1};
    add("pattern { magnet 1 mandel 20 }", PatternKind::magnetMandel, 20);
    add("pattern { magnet 2 mandel 20 }", PatternKind::magnetMandel, 20).magnetType = 2;
    add("pattern { magnet 1 julia <0.3,0.2>, 20 }", PatternKind::magnetJulia, 20).juliaPoint = {0.3, 0.2};
    Pattern& second = add("pattern { magnet 2 julia <-0.51,-0.697>, 20 }", PatternKind::magnetJulia, 20);
    second.juliaPoint = {-0.51, -0.697};
    second.magnetType = 2;
    return all;
}

/// Those with transformations and warps.
std::map<std::string, Pattern> warpedPatterns() {
    std::map<std::string, Pattern> all;
    const auto add = [&](const char* definition, PatternKind kind,
                         std::vector<PatternWarp> warps) -> Pattern& {
        Pattern& pattern = all[definition];
        pattern.kind = kind;
        pattern.warps = std::move(warps);
        return pattern;
    };
    const double third = 1 / 1.75;
    add("pattern { crackle scale 1.75 }", PatternKind::crackle,
        {TransformWarp{{third, 0, 0, 0, third, 0, 0, 0, third, 0, 0, 0}}});
    add("pattern { gradient x warp { turbulence 0.792 octaves 4 } }", PatternKind::gradient,
        {TurbulenceWarp{{0.792, 0.792, 0.792}, 4}});
    add("pattern { gradient y warp { repeat x flip x } warp { repeat 2*z offset 0.5*y } }",
        PatternKind::gradient,
        {RepeatWarp{0, 1, {0, 0, 0}, {true, false, false}}, RepeatWarp{2, 2, {0, 0.5, 0}}})
        .gradient = {0, 1, 0};
    add("pattern { bozo warp { black_hole <0.3,0.2,0.1>, 1 strength 0.7 falloff 2 } }", PatternKind::bozo,
        {BlackHoleWarp{{0.3, 0.2, 0.1}, 1, 0.7, 2}});
    add("pattern { wood warp { planar z, 0.5 } }", PatternKind::wood, {PlanarWarp{{0, 0, 1}, 0.5}});
    add("pattern { checker warp { spherical orientation z dist_exp 0.5 } }", PatternKind::checker,
        {RoundWarp{RoundWarp::Kind::spherical, {0, 0, 1}, 0.5}});
    add("pattern { checker warp { cylindrical } }", PatternKind::checker,
        {RoundWarp{RoundWarp::Kind::cylindrical}});
    add("pattern { checker warp { toroidal major_radius 0.7 } }", PatternKind::checker,
        {RoundWarp{RoundWarp::Kind::toroidal, {0, 0, 1}, 0, 0.7}});
    const Function square = functionOf([](Expression x, Expression y, Expression) { return x * x + sin(y); });
    add("pattern { function { x*x + sin(y) } }", PatternKind::function, {}).function = square;
    const Function plain = functionOf([](Expression x, Expression, Expression) { return x; });
    Pattern& wave = add("pattern { function { x } sine_wave frequency 2 }", PatternKind::function, {});
    wave.function = plain;
    wave.wave = WaveForm::sine;
    wave.frequency = 2;
    return all;
}

/// Compares the rows of golden/patterns.csv that are defined by these patterns.
void comparePatterns(const std::map<std::string, Pattern>& patterns) {
    const test::CsvTable table(test::dataFile("golden/patterns.csv"));
    std::map<std::string, int> seen;
    double worst = 0;
    int onEdge = 0;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        const auto found = patterns.find(table.field(row, "definition"));
        if (found == patterns.end()) continue;
        ++seen[found->first];
        if (table.field(row, "edge") == "1") {
            ++onEdge;
            continue;
        }
        const std::string& generator = table.field(row, "noise_generator");
        const double got =
            valueAt(patternFunction(found->second, generator.empty() ? 2 : std::stoi(generator)),
                    table.number(row, "x"), table.number(row, "y"), table.number(row, "z"));
        const double error = test::goldenError(got, table.number(row, "value"));
        if (!(error <= 1e-9)) QFAIL(qPrintable(describe(table, row, got)));
        worst = std::max(worst, error);
    }
    QCOMPARE(seen.size(), patterns.size());
    qInfo("%zu patterns, worst error %.2g; %d rows on discontinuities left out", seen.size(), worst, onEdge);
}

}  // namespace

class PatternTest : public QObject {
    Q_OBJECT

  private slots:
    void goldenRowsOfNamedFunctions() {
        const test::CsvTable table(test::dataFile("golden/patterns.csv"));
        std::map<std::string, ReferenceEvaluator> built;
        int compared = 0, onEdge = 0, edgeDiffers = 0;
        double worst = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            if (table.field(row, "kind") != "builtin") continue;
            const std::string& name = table.field(row, "definition");
            const std::string& generator = table.field(row, "noise_generator");
            const Builtin* builtin = findBuiltin(std::string_view(name));
            QVERIFY2(builtin, name.c_str());
            auto found = built.find(name + generator);
            if (found == built.end())
                found = built
                            .emplace(name + generator,
                                     builtinFunction(*builtin, generator.empty() ? 2 : std::stoi(generator)))
                            .first;
            const double got = found->second.evaluate(
                std::vector<double>{table.number(row, "x"), table.number(row, "y"), table.number(row, "z")});
            const double error = test::goldenError(got, table.number(row, "value"));
            const double tolerance = table.field(row, "component") == "gray" ? 1e-6 : 1e-9;
            if (table.field(row, "edge") == "1") {
                ++onEdge;
                edgeDiffers += error > tolerance;
                continue;
            }
            if (!(error <= tolerance)) QFAIL(qPrintable(describe(table, row, got)));
            worst = std::max(worst, error);
            ++compared;
        }
        QVERIFY(compared > 100);
        qInfo("%d rows, worst error %.2g; %d more on discontinuities, of which %d differ", compared, worst,
              onEdge, edgeDiffers);
    }

    /// Measured on POV-Ray 3.7: re^2 + im^2*factor, not |u|^2*factor; an exponent of 34 acts as 2.
    void fractalOdditiesAreKept() {
        Pattern pattern;
        pattern.kind = PatternKind::mandel;
        pattern.iterations = 1;
        pattern.interior = {6, 0.5};
        const double x = 0.3, y = 0.4375, re = x * x - y * y + x, im = 2 * x * y + y;
        QVERIFY(std::abs(valueAt(patternFunction(pattern), x, y, 0) - (re * re + im * im / 2)) < 1e-15);
        pattern.iterations = 12;
        const double usual = valueAt(patternFunction(pattern), 0.1, 0.2, 0);
        pattern.exponent = 34;
        QCOMPARE(valueAt(patternFunction(pattern), 0.1, 0.2, 0), usual);
    }

    /// Where orbits are coloured by constants from 0 to 1 nothing is folded back, and cases stay cases.
    void unitColorsNeedNoModulus() {
        const auto remainders = [](const Pattern& pattern) {
            const Function function = patternFunction(pattern);
            int count = 0;
            for (NodeId node = 0; node < function.graph->size(); ++node)
                count += (*function.graph)[node].operation == Operation::remainder;
            return count;
        };
        Pattern pattern;
        pattern.kind = PatternKind::mandel;
        pattern.iterations = 5;
        pattern.exterior = {1, 1};
        QCOMPARE(remainders(pattern), 0);
        QCOMPARE(valueAt(patternFunction(pattern), 0, 0, 0), 1);  // inside
        pattern.interior = {0, 1.25};
        QCOMPARE(remainders(pattern), 1);
        QVERIFY(std::abs(valueAt(patternFunction(pattern), 0, 0, 0) - (1.25 - 1.00001)) < 1e-15);
        pattern.interior = {0, 1};
        pattern.exterior = {2, 1};
        QCOMPARE(remainders(pattern), 1);
        pattern.exterior = {1, 1};
        pattern.frequency = 2;
        QCOMPARE(remainders(pattern), 1);
    }

    /// A bug once: with two thousand million iterations one point inside took ten seconds. Orbits close, and
    /// are as far along the turn in the end as one that is followed step by step.
    void closedOrbitsEndWhereLongOnesDo() {
        Pattern pattern;
        pattern.kind = PatternKind::mandel;
        pattern.interior = {2, 1};
        // Turns of 1, 2 and 3 steps, all between -1 and 1, where no modulus counts.
        const std::array<std::array<double, 2>, 3> points{{{-0.1, 0.2}, {-0.9, 0.1}, {-0.12, 0.74}}};
        for (const auto& [x, y] : points)
            for (int extra = 0; extra < 6; ++extra) {
                pattern.iterations = 20'000 + extra;
                std::complex<double> u(x, y);
                for (int k = 0; k < pattern.iterations; ++k)
                    u = {u.real() * u.real() - u.imag() * u.imag() + x, 2 * u.real() * u.imag() + y};
                const double found = valueAt(patternFunction(pattern), x, y, 0);
                // Values of patterns are folded into [0, 1).
                const double expected = u.real() - std::floor(u.real());
                QVERIFY2(std::abs(found - expected) < 1e-12, qPrintable(QString::number(found, 'g', 17)));
                // Six more hold whole turns of all three.
                pattern.iterations += (2'000'000'000 - 20'000) / 6 * 6;
                QCOMPARE(valueAt(patternFunction(pattern), x, y, 0), found);
            }
    }

    void goldenRowsOfModifiers() { comparePatterns(modifiedPatterns()); }

    void goldenRowsOfFractals() { comparePatterns(fractalPatterns()); }

    void goldenRowsOfWarps() { comparePatterns(warpedPatterns()); }

    void printedValuesOfTheSpecification() {
        const std::pair<const char*, double> printed[] = {
            {"f_agate", 0.6235765771281365},
            {"f_crackle", 0.3079773589011159},
            {"f_granite", 0.6861396294945036},
            {"f_ripples", 0.7092855241199372},
            {"f_waves", 0.6032056811872103},
            {"f_wrinkles", 0.49402742439143404},
            {"f_marble", 0.6},
            {"f_wood", 1},
            {"f_spiral1", 0.8096655293982669},
            {"f_spiral2", 0.3806889412034664},
            {"f_onion", 0.8602325267042626},
            {"f_leopard", 0.00018424317558011306},
            {"f_radial", 0.18554947079542172},
        };
        for (const auto& [name, value] : printed) {
            const double got = valueAt(builtinFunction(*findBuiltin(name), 2), 0.3, 0.4, -0.7);
            QVERIFY2(std::abs(got - value) < 1e-14, name);
        }
    }

    /// By POV-Ray, on the plane x = 0 and beside it, where its arcsine loses digits.
    void spiralsBeginAtTheNegativeAxis() {
        struct Row {
            double x, y, z, spiral1, spiral2, tolerance;
        };
        const Row rows[] = {
            {0, -1, 0, 0, 0, 1e-14},
            {0, 1, 0, 2e-5, 0, 1e-14},
            {0, -0.5, 0.1, 0.8, 0.40002, 1e-14},
            {0, 0.5, 0.1, 0.80002, 0.40002, 1e-14},
            {-1e-9, -0.5, 0.1, 0.80004, 0.40002, 3e-9},
            {1e-5, 0.7, 0.2, 0.200029094420547, 0.399981811444621, 1e-11},
            {-1e-5, -0.7, 0.2, 0.200049094420547, 0.399981811444621, 1e-11},
            {0, 0, 0.3, 0.6, 0.8, 1e-14},
        };
        for (const Row& row : rows)
            for (const auto& [name, value] :
                 {std::pair{"f_spiral1", row.spiral1}, std::pair{"f_spiral2", row.spiral2}}) {
                const double got = valueAt(builtinFunction(*findBuiltin(name), 2), row.x, row.y, row.z);
                QVERIFY2(std::abs(got - value) < row.tolerance,
                         qPrintable(QString("%1 at %2, %3: %4").arg(name).arg(row.x).arg(row.y).arg(got)));
            }
    }

    void exactlyOneSurvivesTheModulus() {
        const Function gradient = builtinFunction(*findBuiltin("f_gradientX"), 2);
        QCOMPARE(valueAt(gradient, 1, 0, 0), 1.0);
        QVERIFY(valueAt(gradient, 1.25, 0, 0) == 0.25);
        // Left of 0 the sawtooth is displaced by 0.00001 a unit.
        QVERIFY(std::abs(valueAt(gradient, -1.25, 0, 0) - (1 - 0.24999)) < 1e-12);
    }

    void gradientWithoutDirectionIsNaN() {
        Pattern pattern;
        pattern.kind = PatternKind::gradient;
        pattern.gradient = {0, 0, 0};
        QVERIFY(std::isnan(valueAt(patternFunction(pattern), 1.3, 2.2, 3.3)));
    }

    void wildSettingsStayBounded() {
        Pattern pattern;
        for (const int count : {-2147483647 - 1, -1, 0, 2147483647}) {
            pattern.octaves = pattern.iterations = pattern.numberOfWaves = pattern.arms = count;
            pattern.turbulence = {1e300, 1, 1};
            for (int kind = 0; kind <= static_cast<int>(PatternKind::function); ++kind) {
                pattern.kind = static_cast<PatternKind>(kind);
                const Function function = patternFunction(pattern);
                QVERIFY(function.graph->size() < 100'000);
                valueAt(function, 0.1, 0.2, 0.3);
            }
        }
    }
};

QTEST_APPLESS_MAIN(PatternTest)
#include "pattern_test.moc"

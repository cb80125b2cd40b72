// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluate/algebra/affine_crackle.h"

#include <array>
#include <cmath>
#include <limits>
#include <QTest>
#include <random>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/algebra/affine_form.h"
#include "core/evaluate/algebra/euclidean_crackle.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/function/scalar_operations.h"
#include "core/numeric/crackle_candidates.h"
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(20261123);

/// The points of a piece are rounded to doubles, by 4e-15 along an axis, and so are the distances.
constexpr double placeRounding = 3e-14;

using Forms = std::array<AffineForm, 3>;

class Random {
  public:
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    bool chance(double part) { return between(0, 1) < part; }

    CrackleSettings settings(bool euclidean) {
        CrackleSettings settings;
        const int kind = static_cast<int>(between(0, 5));
        if (kind == 1) settings.form = {1, 0, 0};
        if (kind == 2) settings.form = {0, 0, 1};
        if (kind == 3) settings.form = {between(-1, 1), between(-1, 1), between(-1, 1)};
        if (kind == 4) settings.form = {0.6, -0.4, 0.3};
        if (!euclidean) settings.metric = chance(0.2) ? 1 : chance(0.2) ? between(0.4, 1) : between(1, 6);
        // Other metrics have no values with an offset below 0.
        if (chance(0.3)) settings.offset = between(euclidean ? -1 : 0, 1);
        settings.solid = chance(0.2);
        settings.cells = chance(0.1);
        return settings;
    }
    /// Near walls of cells for some of the axes: there the 81 cells change.
    Forms piece() {
        Forms forms;
        const double length = std::pow(10, between(-7, 0)), error = chance(0.5) ? 0 : length * between(0, 1);
        for (AffineForm& p : forms) {
            p.a = between(-40, 40);
            if (chance(0.3)) p.a = std::round(p.a) + length * between(-1, 1);
            p.b = chance(0.2) ? 0 : between(-length, length);
            p.e = error * between(0, 1);
        }
        return forms;
    }
    double value(const CrackleSettings& settings, const Forms& forms, double s) {
        std::array<double, 3> at;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = chance(0.3) ? (chance(0.5) ? 1 : -1) : between(-1, 1);
            at[k] = forms[k].a + forms[k].b * s + forms[k].e * side;
        }
        return evaluateOperation(Operation::crackle, at, &settings);
    }

  private:
    std::mt19937_64 engine_{seed};
};

}  // namespace

class AffineCrackleTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void formsHoldTheValues_data() {
        QTest::addColumn<bool>("euclidean");
        QTest::addColumn<int>("rounds");
        QTest::newRow("Euclidean distances") << true << 40000;
        QTest::newRow("other metrics") << false << 3000;
    }
    void formsHoldTheValues() {
        QFETCH(bool, euclidean);
        QFETCH(int, rounds);
        Random random;
        int narrow = 0;
        for (int round = 0; round < rounds; ++round) {
            const CrackleSettings settings = random.settings(euclidean);
            QVERIFY(hasCrackleBounds(settings));
            const Forms forms = random.piece();
            const AffineForm form = affineCrackle(forms, settings);
            narrow += form.e < 0.1;
            for (int sample = 0; sample < 24; ++sample) {
                const double s = sample < 2 ? 2 * sample - 1 : random.between(-1, 1);
                const double rest = std::abs(random.value(settings, forms, s) - form.a - form.b * s);
                QVERIFY2(
                    rest <= form.e + placeRounding,
                    qPrintable(QString::asprintf("round %d: off by %.17g of %.17g", round, rest, form.e)));
            }
        }
        QVERIFY2(narrow > rounds / 2, qPrintable(QString::number(narrow)));
    }

    /// What is left open beside the slope falls with the square of the piece, but for the places where
    /// distances change their order, and those of metric 1 where they have edges.
    void formsOfShortPiecesAreStraight_data() {
        QTest::addColumn<double>("metric");
        for (const double metric : {1.0, 1.5, 2.0, 4.0}) QTest::addRow("metric %g", metric) << metric;
    }
    void formsOfShortPiecesAreStraight() {
        QFETCH(double, metric);
        CrackleSettings settings;
        settings.metric = metric;
        Random random;
        int straight = 0;
        constexpr int rounds = 2000;
        for (int round = 0; round < rounds; ++round) {
            Forms forms;
            for (AffineForm& p : forms) p = {random.between(-9, 9), random.between(-1e-3, 1e-3), 0};
            straight += affineCrackle(forms, settings).e < 2e-5;
        }
        QVERIFY2(straight > rounds * 97 / 100, qPrintable(QString::number(straight)));
    }

    /// Such patterns are constant within their cells, and jump between them.
    void formsWithinACellAreExact() {
        Random random;
        int exact[2] = {0, 0};
        constexpr int rounds = 2000;
        for (int round = 0; round < rounds; ++round) {
            CrackleSettings settings;
            (round % 2 ? settings.cells : settings.solid) = true;
            Forms forms;
            for (AffineForm& p : forms) p = {random.between(-9, 9), random.between(-1e-3, 1e-3), 1e-5};
            exact[round % 2] += affineCrackle(forms, settings).e == 0;
        }
        QVERIFY2(exact[0] > rounds / 2 * 98 / 100, qPrintable(QString::number(exact[0])));
        QVERIFY2(exact[1] > rounds / 2 * 98 / 100, qPrintable(QString::number(exact[1])));
    }

    void whatHasNoBoundsIsTold() {
        CrackleSettings settings;
        settings.metric = 0;
        QVERIFY(!hasCrackleBounds(settings));
        settings.metric = 3;
        QVERIFY(hasCrackleBounds(settings));
        settings.offset = -1;
        QVERIFY(!hasCrackleBounds(settings));
        const Forms far{{{5e18, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
        QVERIFY(!std::isfinite(affineCrackle(far, {}).e));
        const Forms wide{{{0, 100, 0}, {0, 0, 0}, {0, 0, 0}}};
        const AffineForm anything = affineCrackle(wide, {});
        QCOMPARE(anything.a - anything.e, 0.0);
        QCOMPARE(anything.a + anything.e, 1.0);
    }

    /// The ends of a piece count as the numbers they are, not as their rounded sum.
    void aPieceBeyondTheLongestReachIsLeftOpen() {
        const auto open = [](double slope, double error) {
            const Forms forms{{{0.5, slope, error}, {0.5, 0, 0}, {0.5, 0, 0}}};
            const AffineForm form = affineCrackle(forms, {});
            return form.b == 0 && form.e == 0.5;
        };
        QVERIFY(!open(std::nextafter(longestCrackleReach, 0) * (1 - 1e-13), 0));
        QVERIFY(longestCrackleReach + 1e-17 == longestCrackleReach);
        QVERIFY(open(longestCrackleReach, 1e-17));
    }

    /// Lanes that look at the same candidates are looked at together: near ones, beside far and unknown ones.
    void aLaneDoesNotDependOnTheOthers() {
        Random random;
        for (int round = 0; round < 2000; ++round) {
            const CrackleSettings settings = random.settings(round % 8 != 0);
            constexpr std::size_t room = 24;
            const auto lanes = static_cast<std::size_t>(random.between(1, room));
            std::array<std::array<std::array<double, room>, 3>, 3> columns{};
            std::array<Forms, room> pieces;
            const Forms first = random.piece();
            for (std::size_t i = 0; i < lanes; ++i) {
                pieces[i] = random.piece();
                for (std::size_t k = 0; k < 3; ++k) {
                    if (round % 2) pieces[i][k].a = first[k].a + random.between(-0.2, 0.2);
                    if (random.chance(0.01)) pieces[i][k].e = std::numeric_limits<double>::infinity();
                    columns[k][0][i] = pieces[i][k].a;
                    columns[k][1][i] = pieces[i][k].b;
                    columns[k][2][i] = pieces[i][k].e;
                }
            }
            const auto column = [&](std::size_t k) {
                return FormColumn{columns[k][0].data(), columns[k][1].data(), columns[k][2].data()};
            };
            std::array<std::array<double, room>, 3> result;
            writeAffineCrackle({column(0), column(1), column(2)}, settings, lanes,
                               {result[0].data(), result[1].data(), result[2].data()});
            for (std::size_t i = 0; i < lanes; ++i) {
                const AffineForm alone = affineCrackle(pieces[i], settings);
                QCOMPARE(std::isfinite(result[2][i]), std::isfinite(alone.e));
                if (!std::isfinite(alone.e)) continue;
                QVERIFY(result[0][i] == alone.a && result[1][i] == alone.b && result[2][i] == alone.e);
            }
        }
    }

    void boxesHoldTheValues() {
        Random random;
        for (int round = 0; round < 20000; ++round) {
            const CrackleSettings settings = random.settings(true);
            Forms forms = random.piece();
            std::array<Interval, 3> box;
            for (std::size_t k = 0; k < 3; ++k) {
                forms[k].e += std::abs(forms[k].b);
                forms[k].b = 0;
                box[k] = {forms[k].a - forms[k].e, forms[k].a + forms[k].e, false};
            }
            const Interval range = evaluateOperation(Operation::crackle, box, &settings);
            for (int sample = 0; sample < 8; ++sample) {
                const double value = random.value(settings, forms, 0);
                QVERIFY(range.low - placeRounding <= value && value <= range.high + placeRounding);
            }
        }
    }

    /// A list of a large cube does what one of a small one does: the order of what was asked for before does
    /// not matter.
    void listsDependOnThePlaceAlone() {
        Random random;
        for (int round = 0; round < 2000; ++round) {
            CrackleCube cube{{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)}, 0};
            const CrackleCandidates* found = crackleCandidates(cube, 2, 2);
            QVERIFY(found && found->always >= 2);
            const CrackleCandidates first = *found;
            crackleCandidates({cube.center, 0.2}, 2, 3);
            for (int k = 0; k < 9; ++k)
                crackleCandidates({{random.between(-90, 90), random.between(-90, 90), 0}, 0}, 2, 2);
            found = crackleCandidates(cube, 2, 2);
            QVERIFY(found && found->count == first.count && found->always == first.always);
            for (std::size_t i = 0; i < first.count; ++i) QCOMPARE(found->x[i], first.x[i]);
        }
    }

    void slopesAreThoseOfDifferences() {
        Random random;
        int agreed = 0;
        constexpr int rounds = 3000;
        for (int round = 0; round < rounds; ++round) {
            CrackleSettings settings = random.settings(round % 4 != 0);
            if (settings.metric < 1) settings.metric = 1.5;
            std::array<double, 3> at{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
            const std::array<double, 3> slopes = crackleGradient(settings, at, 1e-5);
            bool close = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::array<double, 3> low = at, high = at;
                low[axis] -= 1e-6;
                high[axis] += 1e-6;
                const double rise = evaluateOperation(Operation::crackle, high, &settings) -
                                    evaluateOperation(Operation::crackle, low, &settings);
                close = close && std::abs(rise / 2e-6 - slopes[axis]) < 1e-4;
            }
            agreed += close;
        }
        // Few points lie where the nearest points change.
        QVERIFY2(agreed > rounds * 99 / 100, qPrintable(QString::number(agreed)));
    }
};

QTEST_APPLESS_MAIN(AffineCrackleTest)
#include "affine_crackle_test.moc"

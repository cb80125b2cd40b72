// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numeric/interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <QTest>
#include <random>
#include <vector>
#include "tests/support/test_setting.h"

using namespace isoscope;

namespace {

const std::uint64_t seed = test::seedSetting(1788);
constexpr double infinite = Interval::infinite;
constexpr double largest = std::numeric_limits<double>::max();
constexpr double pi = std::numbers::pi;

/// A function of one number beside the one of intervals: where it is defined, and the places between the ends
/// of an interval where it may be extreme: `offset` + k `period`.
struct Unary {
    const char* name;
    Interval (*ofInterval)(const Interval&);
    double (*ofNumber)(double);
    double from = -infinite, to = infinite;
    double offset = 0, period = infinite;
};

const std::vector<Unary> unaries{
    {"abs", abs, [](double x) { return std::abs(x); }},
    {"square", square, [](double x) { return x * x; }},
    {"sqrt", sqrt, [](double x) { return std::sqrt(x); }, 0},
    {"exp", exp, [](double x) { return std::exp(x); }},
    {"log", log, [](double x) { return std::log(x); }, 0},
    {"log10", log10, [](double x) { return std::log10(x); }, 0},
    {"sin", sin, [](double x) { return std::sin(x); }, -infinite, infinite, pi / 2, pi},
    {"cos", cos, [](double x) { return std::cos(x); }, -infinite, infinite, 0, pi},
    {"asin", asin, [](double x) { return std::asin(x); }, -1, 1},
    {"acos", acos, [](double x) { return std::acos(x); }, -1, 1},
    {"atan", atan, [](double x) { return std::atan(x); }},
    {"sinh", sinh, [](double x) { return std::sinh(x); }},
    {"cosh", cosh, [](double x) { return std::cosh(x); }},
    {"tanh", tanh, [](double x) { return std::tanh(x); }},
    {"asinh", asinh, [](double x) { return std::asinh(x); }},
    {"acosh", acosh, [](double x) { return std::acosh(x); }, 1},
    {"atanh", atanh, [](double x) { return std::atanh(x); }, -1, 1},
    {"floor", floor, [](double x) { return std::floor(x); }},
    {"ceil", ceil, [](double x) { return std::ceil(x); }},
};

QString told(const Interval& a) {
    return QString::asprintf("[%.17g, %.17g]%s", a.low, a.high, a.maybeUndefined ? " or undefined" : "");
}

/// What an end may be beyond the number that it should be: some units in the last place.
double rounding(double end) { return std::abs(end) * 1e-14 + 1e-300; }

/// Whether `found` encloses [low, high] and no more than rounding besides.
bool fits(const Interval& found, double low, double high) {
    return found.low <= low && high <= found.high && found.low >= low - rounding(low) &&
           found.high <= high + rounding(high);
}

/// The range of `function` over [low, high], where it is defined everywhere.
std::pair<double, double> rangeOf(const Unary& function, double low, double high) {
    std::vector<double> places{low, high};
    if (low <= 0 && 0 <= high) places.push_back(0);
    if (std::isfinite(function.period))
        for (double k = std::ceil((low - function.offset) / function.period);; ++k) {
            const double place = function.offset + k * function.period;
            if (!(place <= high)) break;
            if (place >= low) places.push_back(place);
        }
    double least = infinite, most = -infinite;
    for (const double place : places) {
        const double value = function.ofNumber(place);
        least = std::min(least, value);
        most = std::max(most, value);
    }
    return {least, most};
}

/// Ends where functions have their edges, and others.
std::vector<double> ends() {
    std::vector<double> all{-40, -7.5, -3, -2, -1, -0.5, 0, 0.25, 0.5, 1, 1.5, 2, 3, 5, 17.25, 40};
    for (const double quarter : {-3., -2., -1., 1., 2., 3., 4., 5., 6., 9.}) {
        all.push_back(quarter * pi / 2 - 0.01);
        all.push_back(quarter * pi / 2 + 0.01);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<Interval> intervals() {
    const std::vector<double> all = ends();
    std::vector<Interval> result;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = i; k < all.size(); ++k) result.push_back({all[i], all[k], false});
    return result;
}

Interval undefinedToo(Interval a) {
    a.maybeUndefined = true;
    return a;
}

/// An interval with finite ends of any sign and size.
Interval anyInterval(std::mt19937& random) {
    std::uniform_real_distribution<double> exponent(-3, 3);
    std::uniform_int_distribution<int> kind(0, 5);
    const auto number = [&] { return std::pow(10, exponent(random)) * (kind(random) % 2 ? 1 : -1); };
    double low = number(), high = number();
    if (kind(random) == 0) low = 0;
    if (kind(random) == 0) high = 0;
    if (kind(random) == 0) low = high;
    return {std::min(low, high), std::max(low, high), kind(random) == 0};
}

}  // namespace

class IntervalTest : public QObject {
    Q_OBJECT

    void addUnaries() {
        QTest::addColumn<int>("index");
        for (std::size_t k = 0; k < unaries.size(); ++k)
            QTest::newRow(unaries[k].name) << static_cast<int>(k);
    }

  private slots:
    /// The range over the part of the interval where the function is defined, no wider than rounding asks
    /// for; undefined only where a part is outside.
    void rangesAreTight_data() { addUnaries(); }
    void rangesAreTight() {
        QFETCH(int, index);
        const Unary& function = unaries[static_cast<std::size_t>(index)];
        for (const Interval& a : intervals()) {
            const Interval found = function.ofInterval(a);
            const double low = std::max(a.low, function.from), high = std::min(a.high, function.to);
            if (low > high) {
                QVERIFY2(found.empty() && found.maybeUndefined, qPrintable(told(a)));
                continue;
            }
            const auto [least, most] = rangeOf(function, low, high);
            // An infinite end stands for numbers without limit.
            const auto finite = [](double end) { return std::clamp(end, -largest, largest); };
            QVERIFY2(fits({finite(found.low), finite(found.high), false}, finite(least), finite(most)),
                     qPrintable(told(a) + ": " + told(found)));
            QCOMPARE(found.maybeUndefined, a.low < function.from || a.high > function.to);
            QVERIFY(function.ofInterval(undefinedToo(a)).maybeUndefined);
        }
    }

    void whatHasNoValueStaysWithout_data() { addUnaries(); }
    void whatHasNoValueStaysWithout() {
        QFETCH(int, index);
        const Interval found = unaries[static_cast<std::size_t>(index)].ofInterval(Interval::undefined());
        QVERIFY(found.empty() && found.maybeUndefined);
    }

    void rangesKeepTheirCertainEnds() {
        // Exactly: QCOMPARE of doubles would be fuzzy.
        QVERIFY(sqrt({0, 4, false}).low == 0.0);
        QVERIFY(square({-1, 1, false}).low == 0.0);
        QVERIFY(abs({-1, 1, false}).low == 0.0);
        QVERIFY(exp({-infinite, 0, false}).low == 0.0);
        QVERIFY(exp({-1000, 0, false}).low == 0);
        QVERIFY(cosh({-1, 1, false}).low == 1.0);
        QVERIFY(tanh({-infinite, 40, false}) == (Interval{-1, 1, false}));
        QVERIFY(sin({-40, 40, false}) == (Interval{-1, 1, false}));
        QVERIFY(cos({-40, 40, false}) == (Interval{-1, 1, false}));
        // Near a peak the rounding would go beyond it.
        QVERIFY(sin({1.5, pi / 2 - 1e-8, false}).high == 1.0);
        QVERIFY(sin({-pi / 2 + 1e-8, -1.5, false}).low == -1.0);
        QVERIFY(cos({1e-8, 0.1, false}).high == 1.0);
        QVERIFY(cos({3, pi - 1e-8, false}).low == -1.0);
        QVERIFY(sin({2e9, 2e9 + 0.001, true}) == (Interval{-1, 1, true}));
        QVERIFY(cos({2e9, 2e9 + 0.001, true}) == (Interval{-1, 1, true}));
        QVERIFY(sin({-2e9, -1e9, false}) == (Interval{-1, 1, false}));
        // An end that overflows is any number that large.
        QVERIFY(exp({1000, 1001, false}) == (Interval{largest, infinite, false}));
        QVERIFY(log({0, 0, false}) == (Interval{-infinite, -largest, false}));
        QVERIFY(log({0, 0, false}).holds(-infinite));
    }

    void tangentsEndAtTheirPoles() {
        for (const double turn : {0.0, pi, -3 * pi}) {
            QVERIFY(tan({turn - 1, turn + 2, false}) == Interval::unknown());
            QVERIFY(tan({turn - 2, turn + 1, false}) == Interval::unknown());
            const Interval branch = tan({turn - 1, turn + 1.5, false});
            QVERIFY(fits(branch, std::tan(turn - 1), std::tan(turn + 1.5)) && !branch.maybeUndefined);
        }
        QVERIFY(tan({-5, 5, false}) == Interval::unknown());
        QVERIFY(tan({0, pi, false}) == Interval::unknown());
        QVERIFY(tan({2e9, 2e9, false}) == Interval::unknown());
        QVERIFY(tan({-2e9, -2e9, false}) == Interval::unknown());
        QVERIFY(tan({0, 1, true}).maybeUndefined);
        QVERIFY(tan(Interval::undefined()).empty());
    }

    void sumsAndProductsAreTight() {
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        std::mt19937 random(seed);
        const auto oneStep = [](const Interval& found, double low, double high) {
            return (found.low == low || found.low == std::nextafter(low, -infinite)) &&
                   (found.high == high || found.high == std::nextafter(high, infinite));
        };
        for (int round = 0; round < 20000; ++round) {
            const Interval a = anyInterval(random), b = anyInterval(random);
            const Interval sum = a + b, difference = a - b, product = a * b;
            QVERIFY(oneStep(sum, a.low + b.low, a.high + b.high));
            QVERIFY(sum.low == 0 || sum.low < a.low + b.low);
            QVERIFY(sum.high == 0 || sum.high > a.high + b.high);
            QVERIFY(oneStep(difference, a.low - b.high, a.high - b.low));
            const auto [least, most] =
                std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
            QVERIFY2(oneStep(product, least, most), qPrintable(told(a) + told(b) + told(product)));
            QVERIFY(product.low == 0 || product.low < least);
            QVERIFY(product.high == 0 || product.high > most);
            const bool undefined = a.maybeUndefined || b.maybeUndefined;
            QVERIFY(sum.maybeUndefined == undefined && difference.maybeUndefined == undefined &&
                    product.maybeUndefined == undefined);
            const Interval quotient = a / b;
            if (b.low <= 0 && b.high >= 0) {
                QVERIFY(quotient == Interval::unknown());
            } else {
                const auto [low, high] =
                    std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
                QVERIFY2(fits(quotient, low, high), qPrintable(told(a) + told(b) + told(quotient)));
                QCOMPARE(quotient.maybeUndefined, undefined);
            }
            QVERIFY(hull(a, b) == (Interval{std::min(a.low, b.low), std::max(a.high, b.high), undefined}));
            QVERIFY(-a == (Interval{-a.high, -a.low, a.maybeUndefined}));
        }
    }

    /// Rounding changes no sign, and a sum or a product of nothing is 0.
    void signsAreCertain() {
        constexpr double tiny = std::numeric_limits<double>::denorm_min();
        QVERIFY((Interval{0, 1, false} * Interval{0, 1, false}).low == 0);
        QVERIFY((Interval{-1, 0, false} * Interval{-1, 0, false}).low == 0);
        QVERIFY((Interval{-1, 0, false} * Interval{0, 1, false}).high == 0);
        QVERIFY((Interval{0, 1, false} * Interval{-1, 0, false}).high == 0);
        QVERIFY((Interval{tiny, 1, false} * Interval{tiny, 1, false}).low == 0);
        QVERIFY((Interval{tiny, 1, false} * Interval{-1, -tiny, false}).high == 0);
        // Beside both signs a product of 0 may be one that underflowed.
        QVERIFY((Interval{-tiny, 1, false} * Interval{0, tiny, false}).low < 0);
        QVERIFY((Interval{-1, tiny, false} * Interval{0, tiny, false}).high > 0);
        QVERIFY((Interval{0, 0, false} * Interval::all()) == (Interval{0, 0, false}));
        QVERIFY((Interval::all() * Interval{0, 0, true}) == (Interval{0, 0, true}));
        QVERIFY((Interval{0, infinite, false} * Interval{0, 1, false}) == (Interval{0, infinite, false}));
        QVERIFY((Interval{1, 1, false} - Interval{1, 1, false}) == (Interval{0, 0, false}));
        QVERIFY(!(Interval::undefined() + Interval::all()).holds(0));
        QVERIFY((Interval::all() + Interval::undefined()).empty());
        QVERIFY((Interval::all() * Interval::undefined()).empty() &&
                (Interval::undefined() * Interval::all()).empty());
        QVERIFY((Interval::all() / Interval::undefined()).empty() &&
                (Interval::undefined() / Interval::all()).empty());
    }

    void numbersAreHeldByTheirIntervals() {
        const Interval a{1, 2, false};
        QVERIFY(a.holds(1) && a.holds(1.5) && a.holds(2) && !a.holds(0.9) && !a.holds(2.1));
        QVERIFY(!a.holds(std::nan("")) && undefinedToo(a).holds(std::nan("")));
        QVERIFY(Interval::point(3) == (Interval{3, 3, false}) && Interval::point(3).isPoint());
        QVERIFY(!undefinedToo(Interval::point(3)).isPoint() && !a.isPoint());
        QVERIFY(Interval::point(std::nan("")) == Interval::undefined());
        QVERIFY((Interval{std::nan(""), 1, false}.empty()) && !a.empty() && !Interval::point(3).empty());
        QCOMPARE(a.width(), 1.0);
    }

    void powersAreTight() {
        const auto power = [](Interval base, Interval exponent) { return pow(base, exponent); };
        const auto whole = [](double n) { return Interval::point(n); };
        QVERIFY(fits(power({-2, 3, false}, whole(2)), 0, 9) && power({-2, 3, false}, whole(2)).low == 0);
        QVERIFY(fits(power({-3, -2, false}, whole(4)), 16, 81));
        QVERIFY(fits(power({-2, 3, false}, whole(3)), -8, 27));
        const double infinity = std::numeric_limits<double>::infinity();
        QVERIFY(power({-0.5, -0.25, false}, Interval::point(infinity)).holds(std::pow(-0.5, infinity)));
        QVERIFY((Interval::point(0) * Interval::point(-infinity)).holds(0 * infinity));
        QVERIFY((Interval::point(infinity) * Interval::point(0)).holds(0 * infinity));
        // Unless it is an end of which nothing is known.
        QVERIFY((Interval::point(0) * Interval{1, infinity, false}) == Interval::point(0));
        // No rounding makes them leave the domain of a root.
        QVERIFY(power({0, 3, false}, whole(5)).low == 0 && power({-3, 0, false}, whole(5)).high == 0);
        QVERIFY(power({-2, 3, false}, whole(0)) == Interval::point(1));
        QVERIFY(fits(power({2, 4, false}, whole(-1)), 0.25, 0.5));
        QVERIFY(fits(power({-4, -2, false}, whole(-3)), -0.125, -0.015625));
        QVERIFY(power({-1, 1, false}, whole(-2)) == Interval::unknown());
        QVERIFY(power({1, 2, true}, whole(2)).maybeUndefined &&
                !power({1, 2, false}, whole(2)).maybeUndefined);
        // Others ask for a base that is not negative.
        QVERIFY(fits(power({4, 9, false}, whole(0.5)), 2, 3));
        QVERIFY(fits(power({4, 9, false}, {0.5, 1.5, false}), 2, 27));
        QVERIFY(fits(power({0.25, 0.5, false}, {-1, 2, false}), 0.0625, 4));
        QVERIFY(fits(power({0, 4, false}, whole(0.5)), 0, 2) &&
                !power({0, 4, false}, whole(0.5)).maybeUndefined);
        QVERIFY(fits(power({0, 4, false}, {0.5, 2, false}), 0, 16));
        QVERIFY(fits(power({0, 0.25, false}, {0.5, 2, false}), 0, 0.5));
        QVERIFY(fits(power({-1, 4, false}, whole(0.5)), 0, 2) &&
                power({-1, 4, false}, whole(0.5)).maybeUndefined);
        QVERIFY(power({-2, -1, false}, whole(0.5)).empty());
        QVERIFY(power({-1, 4, false}, {0.5, 1.5, false}) == Interval::unknown());
        QVERIFY(power({0, 4, false}, {-0.5, 1, false}) == Interval::unknown());
        QVERIFY(power({0, 4, false}, {0, 1, false}) == Interval::unknown());
        QVERIFY(power({0, 4, false}, {0.5, 2, true}).maybeUndefined &&
                power({0, 4, true}, {0.5, 2, false}).maybeUndefined);
        QVERIFY(power(Interval::undefined(), whole(0)) == Interval::unknown());
        QVERIFY(power({1, 2, false}, Interval::undefined()) == Interval::unknown());
    }

    void anglesAreTight() {
        const double steps[]{-3, -2, -1, 0, 1, 2, 3};
        for (const double x : steps)
            for (const double y : steps) {
                for (const double width : {0.0, 0.5, 1.0}) {
                    const Interval ordinate{y, y + width, false}, abscissa{x, x + width, false};
                    const Interval found = atan2(ordinate, abscissa);
                    if (x <= 0 && y <= 0 && y + width >= 0) {
                        // Around the origin, and across the cut: the ordinate may be -0, too.
                        QVERIFY(found.holds(pi) && found.holds(-pi) && found.width() < 2 * pi + 1e-14);
                        continue;
                    }
                    double low = infinite, high = -infinite;
                    for (const double v : {y, y + width})
                        for (const double u : {x, x + width}) {
                            low = std::min(low, std::atan2(v, u));
                            high = std::max(high, std::atan2(v, u));
                        }
                    QVERIFY2(fits(found, low, high),
                             qPrintable(told(ordinate) + told(abscissa) + told(found)));
                    QVERIFY(!found.maybeUndefined && atan2(undefinedToo(ordinate), abscissa).maybeUndefined &&
                            atan2(ordinate, undefinedToo(abscissa)).maybeUndefined);
                }
            }
        QVERIFY(atan2({-1, 1, false}, {-0.0, 1, false}).holds(pi));
        QVERIFY(atan2({-1, 1, true}, {-1, 1, false}).maybeUndefined);
        QVERIFY(atan2(Interval::undefined(), {1, 2, false}).empty());
        QVERIFY(atan2({1, 2, false}, Interval::undefined()).empty());
    }

    void remaindersAreTight() {
        const auto remainder = [](Interval a, Interval b) { return mod(a, b); };
        // Without a jump they are exact.
        QVERIFY(remainder({5, 5.5, false}, Interval::point(2)) == (Interval{1, 1.5, false}));
        QVERIFY(remainder({5, 5.5, false}, Interval::point(-2)) == (Interval{1, 1.5, false}));
        QVERIFY(remainder({-5.5, -5, false}, Interval::point(2)) == (Interval{-1.5, -1, false}));
        QVERIFY(remainder({-0.5, 1, false}, Interval::point(2)) == (Interval{-0.5, 1, false}));
        // Across one, and for any divisor of a range, as far as the divisor and the dividend let them.
        QVERIFY(remainder({1, 3, false}, Interval::point(2)) == (Interval{0, 2, false}));
        QVERIFY(remainder({-3, -1, false}, Interval::point(2)) == (Interval{-2, 0, false}));
        QVERIFY(remainder({-3, 3, false}, Interval::point(2)) == (Interval{-2, 2, false}));
        QVERIFY(remainder({-3, 3, false}, {-2.5, -2, false}) == (Interval{-2.5, 2.5, false}));
        QVERIFY(remainder({0.5, 0.75, false}, {2, 3, false}) == (Interval{0, 0.75, false}));
        QVERIFY(remainder({-0.75, -0.5, false}, {2, 3, false}) == (Interval{-0.75, 0, false}));
        QVERIFY(remainder({4, 4, false}, Interval::point(2)) == (Interval{0, 2, false}));
        QVERIFY(remainder({1e16, 1e16 + 2, false}, Interval::point(3)) == (Interval{0, 3, false}));
        // A divisor that may be 0 leaves it open whether there is one.
        QVERIFY(remainder({1, 3, false}, {-1, 2, false}) == (Interval{0, 3, true}));
        QVERIFY(remainder({-3, -1, false}, {0, 2, false}) == (Interval{-3, 0, true}));
        QVERIFY(remainder({-3, 1, false}, {-2, 0, false}) == (Interval{-3, 1, true}));
        QVERIFY(remainder({1, 3, true}, {2, 3, false}).maybeUndefined &&
                remainder({1, 3, false}, {2, 3, true}).maybeUndefined);
        QVERIFY(!remainder({1, 3, false}, {2, 3, false}).maybeUndefined);
        QVERIFY(remainder({0, infinite, false}, Interval::point(2)) == (Interval{0, 2, true}));
        QVERIFY(remainder({-infinite, 0, false}, Interval::point(2)) == (Interval{-2, 0, true}));
        QVERIFY(remainder(Interval::undefined(), {2, 3, false}).empty());
        QVERIFY(remainder({2, 3, false}, Interval::undefined()).empty());
    }
};

QTEST_APPLESS_MAIN(IntervalTest)
#include "interval_test.moc"

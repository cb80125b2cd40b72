// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/polynomial/bracketed_root.h"

#include <functional>
#include <QTest>

using namespace isoscope;

namespace {

struct Search {
    double root = 0;
    int evaluations = 0;

    Search(const std::function<double(double)>& f, double a, double b) {
        root = bracketedRoot(
            [&](double t) {
                ++evaluations;
                return f(t);
            },
            a, b, f(a), f(b));
    }
};

}  // namespace

class BracketedRootTest : public QObject {
    Q_OBJECT

  private slots:
    /// Secants alone keep one end for good where a function bends: these take hundreds of steps then.
    void curvedFunctionsTakeFewSteps() {
        struct Case {
            std::function<double(double)> f;
            double from, to, root;
            int most;
        };
        const Case cases[] = {
            {[](double t) { return t - 0.3; }, -1, 2, 0.3, 3},
            {[](double t) { return std::cos(t) - t; }, 0, 1, 0.73908513321516064, 9},
            {[](double t) { return std::pow(t, 9) - 1e-3; }, 0, 2, std::pow(1e-3, 1.0 / 9), 25},
            {[](double t) { return std::exp(t) - 1e3; }, 0, 20, std::log(1e3), 40},
            {[](double t) { return std::exp(-t) - 1e-3; }, 0, 20, std::log(1e3), 40},
            {[](double t) { return std::cbrt(t - 0.1); }, 0, 1, 0.1, 60},
        };
        for (const Case& each : cases)
            for (const double sign : {1.0, -1.0})
                for (const bool mirrored : {false, true}) {
                    const auto f = [&](double t) { return sign * each.f(mirrored ? -t : t); };
                    const Search search =
                        mirrored ? Search(f, -each.to, -each.from) : Search(f, each.from, each.to);
                    const double wanted = mirrored ? -each.root : each.root;
                    QVERIFY2(std::abs(search.root - wanted) <= 1e-14 && search.evaluations <= each.most,
                             qPrintable(QString::asprintf("%.17g for %.17g after %d", search.root, wanted,
                                                          search.evaluations)));
                }
    }

    void aStepHasItsPlace() {
        const Search search([](double t) { return t < 0.7 ? -1 : 1e9; }, 0, 1);
        QVERIFY(std::abs(search.root - 0.7) < 1e-15);
        QVERIFY2(search.evaluations <= 220, qPrintable(QString::number(search.evaluations)));
    }
};

QTEST_APPLESS_MAIN(BracketedRootTest)
#include "bracketed_root_test.moc"

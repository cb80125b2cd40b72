// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <QTest>

#include "core/language/parse.h"
#include "core/roots/certified/certified_root_finder.h"
#include "tests/roots/hard_ray.h"

using namespace isoscope;
using namespace isoscope::test;

class CertifiedHardRaysTest : public QObject {
    Q_OBJECT

  private slots:
    void answersEveryHardRay() {
        const isoscope::test::CsvTable table(dataFile("hard/rays.csv"));
        QVERIFY(table.rowCount() >= 285);
        std::map<std::string, std::pair<std::shared_ptr<const Tape>, std::vector<double>>> tapes;
        std::map<Verdict, int> verdicts;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const HardRay ray(table, row);
            const std::string& body = table.field(row, "function");
            if (!tapes.contains(body)) {
                const ParsedFunction parsed = parseFunction(body);
                QVERIFY2(parsed.ok(), body.c_str());
                tapes[body] = {Tape::compile(parsed.value.function), parsed.parameterTable};
            }
            const auto& [tape, parameters] = tapes[body];
            CertifiedRootFinder finder(tape, parameters, ray.settings(), 20000);
            RootList roots;
            RootRequest request;
            request.sufficient = ray.number("t_min");
            finder.find(std::span(&ray.line(), 1), request, {&roots, 1});
            double t = NAN;
            for (const Root& root : roots)
                if (std::isnan(t) && root.t >= request.sufficient) t = root.t;
            ++verdicts[finder.verdicts()[0]];
            QVERIFY2(ray.admits(t), qPrintable(ray.text("case_id") + ": " + QString::number(t, 'g', 17)));
        }
        for (const auto& [verdict, count] : verdicts) qInfo("%s: %d", name(verdict), count);
        // A ray that needs more than 20000 enclosures is rare.
        QVERIFY(verdicts[Verdict::budgetExceeded] * 20 < static_cast<int>(table.rowCount()));
    }
};

QTEST_APPLESS_MAIN(CertifiedHardRaysTest)
#include "certified_hard_rays_test.moc"

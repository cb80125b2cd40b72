// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <QRegularExpression>
#include <QTest>

#include "core/language/parse.h"
#include "core/roots/certified_root_finder.h"
#include "core/shapes/line_interval.h"
#include "tests/support/csv_table.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// One row of hard/rays.csv and the answer to it; what is right is stated in hard/README.md.
class HardRay {
  public:
    HardRay(const isoscope::test::CsvTable& table, std::size_t row) : table_(table), row_(row) {
        line_.origin = {number("ox"), number("oy"), number("oz")};
        line_.direction = {number("dx"), number("dy"), number("dz")};
        const Ray ray{line_.origin, line_.direction};
        std::vector<double> ends;
        const QString container = text("container");
        static const QRegularExpression numbers("[-+]?[0-9.]+(e[-+]?[0-9]+)?");
        for (auto match = numbers.globalMatch(container); match.hasNext();)
            ends.push_back(match.next().captured().toDouble());
        const LineInterval inside =
            container.startsWith("box")
                ? boxInterval(ray, {ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]})
                : sphereInterval(ray, {ends[0], ends[1], ends[2]}, ends[3]);
        line_.near = std::max(inside.range.near, 0.0);
        line_.far = inside.range.far;
    }

    QString text(const char* column) const { return QString::fromStdString(table_.field(row_, column)); }
    double number(const char* column) const { return table_.number(row_, column); }
    const LineQuery& line() const { return line_; }

    RootSettings settings() const {
        RootSettings settings;
        settings.threshold = number("threshold");
        settings.accuracy = number("accuracy");
        settings.open = true;
        return settings;
    }

    /// Whether `t` (NaN for a miss) is right: the crossing that must be found, a place where a hit is
    /// admissible, a jump, or a miss where nothing must be found.
    bool admits(double t) const {
        if (std::isnan(t)) return text("expect") != "hit";
        const double slack = number("accuracy") / std::hypot(number("dx"), number("dy"), number("dz")) +
                             4 * (std::nextafter(t, INFINITY) - t);
        if (text("expect") == "hit" && number("must_lo") - slack <= t && t <= number("must_hi") + slack)
            return true;
        for (const QString& range : text("may").split(';', Qt::SkipEmptyParts)) {
            const QStringList ends = range.split("..");
            if (ends[0].toDouble() - slack <= t && t <= ends[1].toDouble() + slack) return true;
        }
        for (const QString& event : text("all_roots").split(';', Qt::SkipEmptyParts)) {
            const QStringList fields = event.split(':');
            if (fields[1] == "jump" && fields[3].toDouble() - slack <= t && t <= fields[4].toDouble() + slack)
                return true;
        }
        return false;
    }

  private:
    const isoscope::test::CsvTable& table_;
    std::size_t row_;
    LineQuery line_;
};

}  // namespace

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

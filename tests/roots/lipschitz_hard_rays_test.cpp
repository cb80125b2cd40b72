// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <glm/geometric.hpp>
#include <map>
#include <QTest>

#include "core/evaluate/point_evaluator.h"
#include "core/language/parse.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "tests/roots/hard_ray.h"
#include "tests/roots/lambda_field.h"
#include "tests/roots/plain_lipschitz.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Values that a row may take; ISOSCOPE_HARD_RAYS_VALUES=5e6 is what the method itself allows.
std::uint64_t valueLimit() {
    const char* text = std::getenv("ISOSCOPE_HARD_RAYS_VALUES");
    return text ? static_cast<std::uint64_t>(std::strtod(text, nullptr)) : 50'000;
}

/// A row, its function, and what POV-Ray's method makes of it.
class Attempt {
  public:
    Attempt(const HardRay& ray, const ParsedFunction& parsed)
        : ray_(ray), evaluator_(Tape::compile(parsed.value.function), parsed.parameterTable) {
        settings_ = ray.settings();
        settings_.maxTrace = 1;
        const double bound = ray.text("lipschitz").toDouble();
        isBounded_ = bound > 0 && std::isfinite(bound);
        // Where the slope has no bound, any setting is as wrong as another.
        settings_.maxGradient = isBounded_ ? bound * factor() : 10;
    }

    /// The first hit, NaN for a miss.
    double found() {
        const PointFunction f = [this](const glm::dvec3& p) { return value(p); };
        LipschitzRootFinder finder(std::make_unique<LambdaField>(f), settings_);
        RootList roots;
        finder.find(std::span(&ray_.line(), 1), RootRequest{0, false, {}}, {&roots, 1});
        return roots.empty() ? NAN : roots[0].t;
    }

    /// The same by docs/povray/solver.md, word by word.
    double predicted() {
        const PointFunction f = [this](const glm::dvec3& p) { return value(p); };
        double bound = settings_.maxGradient;
        const RootList roots = PlainLipschitz(f, ray_.line(), settings_, bound).roots();
        return roots.empty() ? NAN : roots[0].t;
    }

    /// Whether more values were asked for than a row may take: the answers mean nothing.
    bool exhausted() const { return values_ > 2 * valueLimit(); }

    /// Why the method gives a wrong answer `t`; empty when no reason is known.
    const char* reasonFor(double t) {
        if (!isBounded_) return "no max_gradient bounds the slope";
        if (factor() < 1) return "max_gradient is too low on purpose";
        if (!std::isnan(t))
            return ray_.isWithin(t, settings_.accuracy)
                       ? "the hit is up to accuracy behind the root, in units of t"
                       : "";
        const double h1 = std::abs(value(at(ray_.line().near))), h2 = std::abs(value(at(ray_.line().far)));
        if (!std::isfinite(h1 + h2)) return "f overflows at an end of the ray";
        const double reach =
            settings_.maxGradient * glm::length(ray_.line().direction) * (ray_.line().far - ray_.line().near);
        // The bound is listed with six digits.
        if (std::abs(h1 + h2 - reach) < 1e-5 * reach) return "the slope is the bound all along the ray";
        return "";
    }

  private:
    double factor() const {
        const QString settings = ray_.text("settings"), key = "max_gradient_factor=";
        return settings.startsWith(key) ? settings.mid(key.size()).toDouble() : 1;
    }
    glm::dvec3 at(double t) const { return ray_.line().origin + t * ray_.line().direction; }
    double value(const glm::dvec3& p) {
        // NaN ends every search at once.
        return ++values_ > 2 * valueLimit() ? NAN : evaluator_.evaluate(p.x, p.y, p.z);
    }

    const HardRay& ray_;
    PointEvaluator evaluator_;
    RootSettings settings_;
    bool isBounded_ = false;
    std::uint64_t values_ = 0;
};

}  // namespace

class LipschitzHardRaysTest : public QObject {
    Q_OBJECT

  private slots:
    /// The method answers as its description says, and every row that it loses is lost for a known reason.
    void losesWhatItsDescriptionPredicts() {
        const isoscope::test::CsvTable table(dataFile("hard/rays.csv"));
        std::map<QString, QStringList> lost;
        int right = 0, exhausted = 0;
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const HardRay ray(table, row);
            const ParsedFunction parsed = parseFunction(table.field(row, "function"));
            QVERIFY(parsed.ok());
            Attempt attempt(ray, parsed);
            const double t = attempt.found(), predicted = attempt.predicted();
            if (attempt.exhausted()) {
                ++exhausted;
                continue;
            }
            QVERIFY2(t == predicted || (std::isnan(t) && std::isnan(predicted)),
                     qPrintable(ray.text("case_id")));
            if (ray.admits(t)) {
                ++right;
                continue;
            }
            const QString reason = attempt.reasonFor(t);
            QVERIFY2(!reason.isEmpty(), qPrintable(ray.text("case_id") + ": " + QString::number(t, 'g', 17)));
            lost[reason].append(ray.text("case_id"));
        }
        for (const auto& [reason, rows] : lost)
            qInfo("%lld lost, %s: %s", static_cast<long long>(rows.size()), qPrintable(reason),
                  qPrintable(rows.join(' ')));
        qInfo("%d right; %d not decided within %llu values", right, exhausted,
              static_cast<unsigned long long>(valueLimit()));
        QVERIFY(right * 3 > static_cast<int>(table.rowCount()) * 2);
    }
};

QTEST_APPLESS_MAIN(LipschitzHardRaysTest)
#include "lipschitz_hard_rays_test.moc"

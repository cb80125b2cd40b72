// SPDX-License-Identifier: GPL-3.0-or-later
// The families of hard/rays.csv through every evaluator and every root finder on every instruction set, as a
// table: printed, and written to reports/hard_rays.csv of the build folder.
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stop_token>
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/evaluate/affine_evaluator.h"
#include "core/evaluate/box_evaluator.h"
#include "core/evaluate/gradient_evaluator.h"
#include "core/evaluate/interval_evaluator.h"
#include "core/evaluate/interval_gradient_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/evaluate/reference_evaluator.h"
#include "core/evaluate/slope_evaluator.h"
#include "core/evaluate/taylor_evaluator.h"
#include "core/language/parse.h"
#include "core/roots/certified/certified_root_finder.h"
#include "core/roots/lipschitz/lipschitz_root_finder.h"
#include "core/roots/lipschitz/tape_field.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"
#include "test_folders.h"
#include "tests/roots/hard_ray.h"
#include "tests/roots/line_table.h"
#include "tests/support/exact_line.h"
#include "tests/support/exact_pieces.h"
#include "tests/support/instruction_sets.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// A row of the table with what its function is made into.
struct Case {
    HardRay ray;
    ParsedFunction parsed;
    std::shared_ptr<const PreparedFunction> function;
};

/// What a root finder made of some rays.
struct Answers {
    int rays = 0, falseHits = 0, missed = 0, unproven = 0;
    double worst = 0;  ///< error of a root that must be found, in parts of the accuracy

    void note(const HardRay& ray, double t, Verdict verdict) {
        ++rays;
        unproven += verdict > Verdict::certifiedMiss;
        if (!ray.admits(t)) ++(std::isnan(t) ? missed : falseHits);
        if (std::isnan(t) || ray.text("expect") != "hit") return;
        const double low = ray.number("must_lo"), high = ray.number("must_hi");
        const double tolerance =
            ray.number("accuracy") / std::hypot(ray.number("dx"), ray.number("dy"), ray.number("dz"));
        // Other admissible hits come before.
        if (t < low - tolerance || t > high + tolerance) return;
        worst = std::max(worst, std::max(low - t, t - high) / tolerance);
    }
};

/// What an evaluator made of pieces of some rays.
struct Enclosed {
    int pieces = 0, violations = 0, unbounded = 0;
};

/// Asks for a stop behind so many values: POV-Ray's method may take millions.
class LimitedField : public FieldFunction {
  public:
    LimitedField(std::shared_ptr<const PreparedFunction> function, std::stop_source stop)
        : field_(std::move(function)), stop_(std::move(stop)) {}

    void values(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                std::span<double> out) override {
        constexpr std::size_t most = 30'000;
        taken_ += out.size();
        if (taken_ > most) stop_.request_stop();
        field_.values(x, y, z, out);
    }

  private:
    TapeField field_;
    std::stop_source stop_;
    std::size_t taken_ = 0;
};

constexpr std::array finders{"certified", "certified, bundles", "POV-Ray's"};
constexpr std::size_t together = BundleMarch::bundleLines;

RootSettings settingsOf(const HardRay& ray) {
    RootSettings settings = ray.settings();
    const double bound = ray.text("lipschitz").toDouble();
    const QString key = "max_gradient_factor=", given = ray.text("settings");
    const double factor = given.startsWith(key) ? given.mid(key.size()).toDouble() : 1;
    settings.maxGradient = bound > 0 && std::isfinite(bound) ? bound * factor : 10;
    return settings;
}

double firstOf(const RootList& roots, double sufficient) {
    for (const Root& root : roots)
        if (root.t >= sufficient) return root.t;
    return NAN;
}

/// The root finder by its place among `finders`, for one ray: t (NaN: none) and verdict.
std::pair<double, Verdict> find(std::size_t which, const Case& at) {
    const RootSettings settings = settingsOf(at.ray);
    RootRequest request;
    request.sufficient = at.ray.number("t_min");
    const LineQuery& line = at.ray.line();
    RootList roots;
    if (which == 2) {
        std::stop_source stop;
        request.stop = stop.get_token();
        LipschitzRootFinder finder(std::make_unique<LimitedField>(at.function, stop), settings);
        finder.find(std::span(&line, 1), request, {&roots, 1});
        return {firstOf(roots, request.sufficient),
                stop.stop_requested() ? Verdict::budgetExceeded : Verdict::notCertified};
    }
    CertifiedRootFinder finder(at.function, settings);
    if (which == 0) {
        finder.find(std::span(&line, 1), request, {&roots, 1});
        return {firstOf(roots, request.sufficient), finder.verdicts()[0]};
    }
    const LineTable lines(std::vector<LineQuery>(together, line));
    FirstRoots found;
    finder.findFirst(lines.columns(), request, found);
    double t = found.crossings[FirstRoots::t][together / 2];
    if (t == FirstRoots::none) t = NAN;
    for (const FirstRoots::Other& other : found.others)
        if (other.line == together / 2) t = other.root.t;
    return {t, finder.verdicts()[together / 2]};
}

/// Pieces of each ray.
constexpr std::size_t pieceCount = 16;

/// The ray in pieces of many lengths, here and there.
RayPieces piecesOf(const LineQuery& line) {
    RayPieces pieces;
    for (std::size_t lane = 0; lane < pieceCount; ++lane) {
        for (int axis = 0; axis < 3; ++axis) {
            pieces.origin[static_cast<std::size_t>(axis)][lane] = line.origin[axis];
            pieces.direction[static_cast<std::size_t>(axis)][lane] = line.direction[axis];
        }
        const double length = line.far - line.near;
        pieces.length[lane] = length * std::pow(0.5, double(lane));
        pieces.start[lane] = line.near + (length - pieces.length[lane]) * double(lane % 4) / 3;
    }
    return pieces;
}

/// The smallest box around a piece.
std::array<Interval, 3> boxOf(const RayPieces& pieces, std::size_t lane) {
    std::array<Interval, 3> box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const ExactRange t = ExactRange(pieces.start[lane]) + ExactRange(pieces.length[lane]);
        const ExactRange end =
            ExactRange(pieces.origin[axis][lane]) + t * ExactRange(pieces.direction[axis][lane]);
        const ExactRange begin = ExactRange(pieces.origin[axis][lane]) +
                                 ExactRange(pieces.start[lane]) * ExactRange(pieces.direction[axis][lane]);
        const auto down = [](const ExactRange& r) { return mpfr_get_d(r.low.get(), MPFR_RNDD); };
        const auto up = [](const ExactRange& r) { return mpfr_get_d(r.high.get(), MPFR_RNDU); };
        box[axis] = {std::min(down(begin), down(end)), std::max(up(begin), up(end)), false};
    }
    return box;
}

/// Whether an interval has room for the exact value, which is known to 200 bits.
bool holds(const Interval& interval, const ExactRange& value) {
    if (value.maybeUndefined) return true;
    return mpfr_cmp_d(value.high.get(), interval.low) >= 0 && mpfr_cmp_d(value.low.get(), interval.high) <= 0;
}

bool isBeyondDoubles(const ExactRange& value) {
    return mpfr_cmp_d(value.high.get(), 1e300) > 0 || mpfr_cmp_d(value.low.get(), -1e300) < 0;
}

/// The enclosures of all evaluators over pieces of one ray, held against exact values.
class EvaluatorTable {
  public:
    explicit EvaluatorTable(const Case& at)
        : at_(at),
          pieces_(piecesOf(at.ray.line())),
          exact_(at.parsed.value.function, at.parsed.parameterTable, at.ray.line(), 0) {}

    /// With the instruction set that is in force.
    std::map<std::string, Enclosed> run() {
        table_.clear();
        noteForms();
        noteIntervals();
        noteSlopes();
        noteTangents();
        notePoints();
        return table_;
    }

  private:
    /// The exact function at start + share * length of a piece; the same for every instruction set.
    const ExactJet& at(std::size_t lane, double share) {
        const auto [entry, isNew] = known_.try_emplace({lane, share});
        if (isNew) entry->second = exact_.at(pieces_.start[lane], pieces_.length[lane], share);
        return entry->second;
    }
    void note(const char* evaluator, bool bounded, bool holds) {
        Enclosed& entry = table_[evaluator];
        ++entry.pieces;
        entry.unbounded += !bounded;
        entry.violations += !holds;
    }

    void noteForms() {
        AffineEvaluator forms(at_.function);
        std::array<AffineForm, pieceCount> found;
        forms.evaluate(pieces_, found);
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            bool admitted = true;
            const bool bounded = std::abs(found[lane].e) < INFINITY;
            if (bounded)
                for (const double share : {0.0, 0.25, 1.0}) {
                    const ExactRange rest = at(lane, share).value - ExactRange(found[lane].a) -
                                            ExactRange(found[lane].b) * ExactRange(2 * share - 1);
                    admitted = admitted && holds({-found[lane].e, found[lane].e, false}, rest);
                }
            note("forms", bounded, admitted);
        }
    }

    void noteIntervals() {
        IntervalEvaluator scalar(*at_.function);
        BoxEvaluator batch(at_.function);
        IntervalGradientEvaluator gradients(*at_.function);
        BoxLanes boxes;
        std::array<Interval, pieceCount> batchRanges;
        std::array<std::array<Interval, 3>, pieceCount> sides;
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            sides[lane] = boxOf(pieces_, lane);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                boxes.low[axis][lane] = sides[lane][axis].low;
                boxes.high[axis][lane] = sides[lane][axis].high;
            }
        }
        batch.evaluate(boxes, batchRanges);
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            const Interval range = scalar.evaluate(sides[lane]);
            const IntervalGradient& gradient = gradients.evaluate(std::span<const Interval, 3>(sides[lane]));
            bool first = true, second = true, third = true;
            for (const double share : {0.25, 0.75}) {
                const ExactRange value = at(lane, share).value;
                if (isBeyondDoubles(value)) continue;
                first = first && holds(range, value);
                second = second && holds(batchRanges[lane], value);
                third = third && holds(gradient.value, value);
            }
            note("intervals", range.width() < INFINITY, first);
            note("boxes", batchRanges[lane].width() < INFINITY, second);
            note("gradients over boxes", gradient.bounded(), third);
        }
    }

    /// The slope along the ray.
    void noteSlopes() {
        if (!SlopeEvaluator::covers(*at_.function->tape())) return;
        SlopeEvaluator slopes(at_.function);
        const SlopeLanes found = slopes.evaluate(pieces_, {}, pieceCount);
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            const bool bounded =
                std::abs(found.value.error[lane]) < INFINITY && found.spread[lane] < INFINITY;
            bool admitted = true;
            for (const double share : {0.25, 0.75}) {
                const ExactJet& exact = at(lane, share);
                if (!bounded || !exact.isSloped) continue;
                const Interval range{std::nextafter(found.slope[lane] - found.spread[lane], -INFINITY),
                                     std::nextafter(found.slope[lane] + found.spread[lane], INFINITY), false};
                admitted = admitted && holds(range, exact.slope);
            }
            note("slopes", bounded, admitted);
        }
    }

    void noteTangents() {
        if (!TaylorEvaluator::covers(*at_.function->tape())) return;
        TaylorEvaluator tangents(at_.function);
        std::array<double, pieceCount> middle, reach;
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            middle[lane] = pieces_.start[lane] + pieces_.length[lane] / 2;
            reach[lane] = pieces_.length[lane] / 2;
        }
        const PieceColumns columns = pieces_.columns();
        const TaylorLanes found =
            tangents.evaluate({columns.origin, columns.direction, middle.data(), reach.data()}, pieceCount);
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            const double value = found.point.value[lane], rest = found.remainder[lane] + found.rounding[lane];
            const bool bounded = std::isfinite(value) && std::isfinite(rest);
            bool admitted = true;
            if (bounded)
                for (const double s : {-1.0, 0.4, 1.0}) {
                    const ExactRange rest = exact_.at(middle[lane], reach[lane], s).value -
                                            ExactRange(value) - ExactRange(found.slope[lane]) * ExactRange(s);
                    const double left = found.remainder[lane] * s * s + found.rounding[lane];
                    const double most = std::nextafter(left, INFINITY);
                    admitted = admitted && holds({-most, most, false}, rest);
                }
            note("tangents", bounded, admitted);
        }
    }

    /// Values at points are no enclosures: the gradient evaluator's are PointEvaluator's, and that one's
    /// those of the reference but for the last digits.
    void notePoints() {
        PointEvaluator points(at_.function);
        GradientEvaluator gradients(at_.function);
        ReferenceEvaluator reference(at_.parsed.value.function);
        std::array<double, pieceCount> x, y, z, values;
        std::array<ValueAndGradient, pieceCount> sloped;
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            const LineQuery& line = at_.ray.line();
            const glm::dvec3 p =
                line.origin + (pieces_.start[lane] + pieces_.length[lane] / 2) * line.direction;
            x[lane] = p.x, y[lane] = p.y, z[lane] = p.z;
        }
        points.evaluate(x, y, z, values);
        gradients.evaluate(x, y, z, sloped);
        IntervalEvaluator intervals(*at_.function);
        for (std::size_t lane = 0; lane < pieceCount; ++lane) {
            const double exact =
                reference.evaluate(std::array{x[lane], y[lane], z[lane]}, at_.parsed.parameterTable);
            const std::array box{Interval::point(x[lane]), Interval::point(y[lane]),
                                 Interval::point(z[lane])};
            const Interval range = intervals.evaluate(box);
            // What rounding can do is what the enclosure of the point leaves open, and as much to either
            // side.
            const double slack = std::isfinite(range.width()) ? range.width() : INFINITY;
            const bool same = std::isnan(exact)
                                  ? std::isnan(values[lane])
                                  : exact == values[lane] || std::abs(exact - values[lane]) <= slack;
            note("points", std::isfinite(values[lane]), same);
            note("gradients", std::isfinite(sloped[lane].value),
                 sloped[lane].value == values[lane] || std::isnan(values[lane]));
        }
    }

    const Case& at_;
    std::map<std::string, Enclosed> table_;
    RayPieces pieces_;
    ExactLine exact_;
    std::map<std::pair<std::size_t, double>, ExactJet> known_;
};

std::vector<Case> casesOf(const isoscope::test::CsvTable& table) {
    std::vector<Case> cases;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        ParsedFunction parsed = parseFunction(table.field(row, "function"));
        if (!parsed.ok()) return {};
        const auto function =
            PreparedFunction::of(Tape::compile(parsed.value.function), parsed.parameterTable);
        cases.push_back({HardRay(table, row), std::move(parsed), function});
    }
    return cases;
}

}  // namespace

class HardTableTest : public QObject {
    Q_OBJECT

    const isoscope::test::CsvTable table_{QStringLiteral(ISOSCOPE_TEST_DATA "/hard/rays.csv")};
    std::vector<Case> cases_;
    std::string report_;

  private slots:
    void initTestCase() {
        cases_ = casesOf(table_);
        QVERIFY(cases_.size() >= 285);
        report_ = csvLine(
            {"family", "what", "instruction_set", "rays", "false", "missed", "worst_error", "unproven"});
    }

    /// Certified answers are never wrong, whatever the instruction set.
    void everyFamilyThroughEveryRootFinder() {
        for (const auto& [set, setName] : instructionSets()) {
            const ForcedInstructionSet forced(set);
            std::set<const Case*> spent;
            for (std::size_t which = 0; which < finders.size(); ++which) {
                std::map<QString, Answers> families;
                Answers all;
                for (const Case& at : cases_) {
                    // The general search would spend its budget once for each line of the bundle.
                    if (which == 1 && spent.contains(&at)) continue;
                    const auto [t, verdict] = find(which, at);
                    const bool isSpent = verdict == Verdict::budgetExceeded;
                    if (which == 0 && isSpent) spent.insert(&at);
                    if (which == 2 && isSpent) continue;  // no answer
                    families[at.ray.text("family")].note(at.ray, t, verdict);
                    all.note(at.ray, t, verdict);
                    QVERIFY2(verdict > Verdict::certifiedMiss || at.ray.admits(t),
                             qPrintable(at.ray.text("case_id") + ' ' + setName + ' ' + finders[which]));
                }
                for (const auto& [family, answers] : families)
                    add(family.toStdString(), finders[which], setName, answers);
                qInfo("%-20s %-8s %4d rays, %2d false, %3d missed, worst error %.2g, %3d unproven",
                      finders[which], setName, all.rays, all.falseHits, all.missed, all.worst, all.unproven);
                if (which < 2) QVERIFY(all.falseHits == 0 && all.missed == 0 && all.worst <= 1);
            }
        }
    }

    /// Enclosures hold what is exact, whatever the instruction set.
    void everyFamilyThroughEveryEvaluator() {
        std::map<std::pair<std::string, std::string>, Enclosed> all;
        for (const Case& at : cases_) {
            EvaluatorTable evaluators(at);
            for (const auto& [set, setName] : instructionSets()) {
                const ForcedInstructionSet forced(set);
                for (const auto& [evaluator, entry] : evaluators.run()) {
                    Enclosed& sum = all[{evaluator, setName}];
                    sum.pieces += entry.pieces;
                    sum.violations += entry.violations;
                    sum.unbounded += entry.unbounded;
                    QVERIFY2(entry.violations == 0,
                             qPrintable(at.ray.text("case_id") + ' ' + setName + ' ' + evaluator.c_str()));
                }
            }
        }
        for (const auto& [key, entry] : all) {
            qInfo("%-20s %-8s %6d pieces, %d violations, %5d without a bound", key.first.c_str(),
                  key.second.c_str(), entry.pieces, entry.violations, entry.unbounded);
            report_ += csvLine({"all", key.first, key.second, std::to_string(entry.pieces),
                                std::to_string(entry.violations), "", "", std::to_string(entry.unbounded)});
        }
    }

    void cleanupTestCase() {
        const QString folder = QStringLiteral(ISOSCOPE_BINARY_DIR "/reports");
        QVERIFY(QDir().mkpath(folder));
        QFile file(folder + "/hard_rays.csv");
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(report_.c_str());
        qInfo("%s", qPrintable(file.fileName()));
    }

  private:
    void add(const std::string& family, const char* finder, const char* set, const Answers& answers) {
        report_ += csvLine({family, finder, set, std::to_string(answers.rays),
                            std::to_string(answers.falseHits), std::to_string(answers.missed),
                            generalNumber(answers.worst, 2), std::to_string(answers.unproven)});
    }
};

QTEST_APPLESS_MAIN(HardTableTest)
#include "hard_table_test.moc"

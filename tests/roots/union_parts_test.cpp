// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/union_parts.h"

#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/evaluate/point_evaluator.h"
#include "core/evaluate/prepared_function.h"
#include "core/roots/certified/certified_root_finder.h"
#include "tests/roots/line_table.h"
#include "tests/support/tape_of.h"
#include "tests/support/test_setting.h"

using namespace isoscope;
using test::LineTable;
using test::tapeOf;

namespace {

const std::uint64_t seed = test::seedSetting(271828);

constexpr double radius = 0.3;

std::shared_ptr<const PreparedFunction> prepared(const std::shared_ptr<const Tape>& tape) {
    return PreparedFunction::of(tape, {});
}

/// A ball of a row along x, one apart.
Expression ball(const Expression& x, const Expression& y, const Expression& z, int k) {
    return sqrt(sq(x - k) + sq(y) + sq(z)) - radius;
}

RootSettings rowSettings() {
    RootSettings settings;
    settings.region = LineRegion{glm::dvec3(-0.5, -1, -1), glm::dvec3(9.5, 1, 1)};
    return settings;
}

/// The boxes of these parts hold the balls of the row, one each, and hardly more.
void verifyRow(const UnionParts& parts) {
    QCOMPARE(parts.size(), std::size_t{10});
    std::array<bool, 10> seen{};
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const LineRegion& box = parts[k].box;
        const glm::dvec3 center = 0.5 * (box.low + box.high);
        const double place = std::round(center.x);
        seen[static_cast<std::size_t>(place)] = true;
        QVERIFY(glm::distance(center, glm::dvec3(place, 0, 0)) < radius);
        for (int axis = 0; axis < 3; ++axis) {
            const double middle = axis == 0 ? place : 0;
            QVERIFY(box.low[axis] < middle - radius && box.low[axis] > middle - 2 * radius);
            QVERIFY(box.high[axis] > middle + radius && box.high[axis] < middle + 2 * radius);
        }
        QVERIFY(parts[k].tape.instructions.size() < 14);
    }
    QVERIFY(std::ranges::all_of(seen, [](bool one) { return one; }));
}

/// A random union whose parts are balls, bars, rings, or what two of them have in common.
struct RandomUnion {
    std::shared_ptr<const Tape> tape;

    explicit RandomUnion(std::mt19937_64& random, bool negated) {
        std::uniform_real_distribution<double> anywhere(-1, 1), size(0.05, 0.25);
        tape = tapeOf([&](auto x, auto y, auto z) {
            const auto part = [&](int kind) {
                const Expression u = x - anywhere(random), v = y - anywhere(random), w = z - anywhere(random);
                const double s = size(random);
                if (kind == 0) return sqrt(sq(u) + sq(v) + sq(w)) - s;
                if (kind == 1) return max(max(abs(u), abs(v) * 2.0), abs(w)) - s;
                return sqrt(sq(sqrt(sq(u) + sq(w)) - s) + sq(v)) - 0.3 * s;
            };
            Expression least = x.number(10);
            for (int k = 0; k < 24; ++k) {
                Expression one = part(k % 3);
                if (k % 5 == 4) one = max(one, part(0));
                // Some are in a union of their own.
                if (k % 4 == 3) one = min(one, part(1)) - 0.01;
                least = min(least, one);
            }
            return negated ? -least : least;
        });
    }
};

std::vector<LineQuery> randomTile(std::mt19937_64& random) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    const auto direction = [&] {
        return glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
    };
    const glm::dvec3 eye = 3.0 * direction();
    const glm::dvec3 ahead = glm::normalize(0.7 * direction() - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.1, 1, 0.2)));
    const glm::dvec3 up = glm::cross(right, ahead);
    std::vector<LineQuery> lines;
    for (int k = 0; k < 64; ++k)
        lines.push_back({eye, ahead + 0.04 * ((k % 8 - 3.5) * right + (k / 8 - 3.5) * up), 1.5, 4.5});
    // Some begin in the middle of all, some are empty.
    if (random() % 4 == 0)
        for (LineQuery& line : lines) line.near = 3;
    lines[9].far = lines[9].near;
    return lines;
}

struct Answer {
    double t = FirstRoots::none;
    std::size_t kind = 0;
    glm::dvec3 normal{0};
};

std::vector<Answer> answersOf(LineRootFinder& finder, const std::vector<LineQuery>& lines) {
    const LineTable table(lines);
    FirstRoots roots;
    finder.findFirst(table.columns(), {0, false, {}}, roots);
    std::vector<Answer> answers(lines.size());
    std::size_t crossings = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto at = [&](FirstRoots::Column column) { return roots.crossings[column][k]; };
        if (at(FirstRoots::t) == FirstRoots::none) continue;
        answers[k] = {at(FirstRoots::t),
                      0,
                      {at(FirstRoots::normalX), at(FirstRoots::normalY), at(FirstRoots::normalZ)}};
        ++crossings;
    }
    for (const std::size_t k : roots.entryWalls) answers[k] = {lines[k].near, 1, {}};
    for (const std::size_t k : roots.exitWalls) answers[k] = {lines[k].far, 2, {}};
    for (const FirstRoots::Other& other : roots.others)
        answers[other.line] = {other.root.t, 0, glm::normalize(other.normal)};
    return answers;
}

}  // namespace

class UnionPartsTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { qInfo("seed %llu", static_cast<unsigned long long>(seed)); }

    void partsHaveBoxes() {
        const auto least = [](auto x, auto y, auto z) {
            Expression result = x.number(10);
            for (int k = 0; k < 10; ++k) result = min(result, ball(x, y, z, k));
            return result;
        };
        verifyRow(UnionParts(*prepared(tapeOf(least)), rowSettings()));
        // In the order of a tree, and behind what keeps the order of values, or turns it round.
        const auto halves = [](auto x, auto y, auto z) {
            Expression first = ball(x, y, z, 0), second = ball(x, y, z, 5);
            for (int k = 1; k < 5; ++k) {
                first = min(ball(x, y, z, k), first);
                second = min(second, ball(x, y, z, k + 5));
            }
            return -max(-first * 2.0, 2.0 * (0.25 - (second + 0.25))) + 0.5;
        };
        RootSettings settings = rowSettings();
        settings.threshold = 0.5;
        verifyRow(UnionParts(*prepared(tapeOf(halves)), settings));
        // Inside is where f is above the threshold.
        const auto greatest = [&](auto x, auto y, auto z) { return -least(x, y, z); };
        settings = rowSettings();
        settings.positivePolarity = true;
        verifyRow(UnionParts(*prepared(tapeOf(greatest)), settings));
    }

    /// What they have in common, what is not many, what no region is told of, and what is everywhere.
    void whatIsNoUnionHasNoParts() {
        const auto row = [](auto choose, double size) {
            return prepared(tapeOf([&](auto x, auto y, auto z) {
                Expression result = x.number(10);
                for (int k = 0; k < 10; ++k) result = choose(result, ball(x, y, z, k) - size);
                return result;
            }));
        };
        const auto least = [](const Expression& a, const Expression& b) { return min(a, b); };
        const auto greatest = [](const Expression& a, const Expression& b) { return max(a, b); };
        QVERIFY(!UnionParts(*row(least, 0), rowSettings()).empty());
        QVERIFY(UnionParts(*row(greatest, 0), rowSettings()).empty());
        QVERIFY(UnionParts(*row(least, 5), rowSettings()).empty());
        QVERIFY(UnionParts(*row(least, 0), RootSettings{}).empty());
        RootSettings settings = rowSettings();
        settings.positivePolarity = true;
        QVERIFY(UnionParts(*row(least, 0), settings).empty());
        // A union that is used twice is one part.
        const auto twice = prepared(tapeOf([](auto x, auto y, auto z) {
            Expression result = x.number(10);
            for (int k = 0; k < 10; ++k) result = min(result, ball(x, y, z, k));
            return min(result, sin(result * 9.0) + 2.0);
        }));
        QVERIFY(UnionParts(*twice, rowSettings()).empty());
    }

    /// Outside of its box a part is outside; inside some of them the function is the least of the parts.
    void boxesLeaveNothingOut() {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-1.6, 1.6);
        for (int round = 0; round < 8; ++round) {
            RootSettings settings;
            settings.region = LineRegion{glm::dvec3(-1.5), glm::dvec3(1.5)};
            settings.positivePolarity = round % 2 == 1;
            const auto function = prepared(RandomUnion(random, settings.positivePolarity).tape);
            const UnionParts parts(*function, settings);
            QVERIFY(parts.size() >= 20);
            PointEvaluator points(function);
            for (int k = 0; k < 2000; ++k) {
                const glm::dvec3 p{anywhere(random), anywhere(random), anywhere(random)};
                double least = 10;
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    std::array<double, 1> value;
                    points.evaluate({&p.x, 1}, {&p.y, 1}, {&p.z, 1}, value, parts[i].tape);
                    const double g = settings.signedValue(value[0]);
                    const LineRegion& box = parts[i].box;
                    bool inBox = true;
                    for (int axis = 0; axis < 3; ++axis)
                        inBox &= box.low[axis] <= p[axis] && p[axis] <= box.high[axis];
                    QVERIFY(inBox || g > 0);
                    least = std::min(least, g);
                }
                // Parts that are nowhere in the region are not there.
                const double whole = settings.signedValue(points.evaluate(p.x, p.y, p.z));
                QVERIFY(whole < 0 ? least == whole : least >= whole);
            }
        }
    }

    /// A bundle meets the parts that one of its lines meets, and knows no line to meet them sooner.
    void bundlesMeetWhatTheirLinesMeet() {
        std::mt19937_64 random(seed + 1);
        RootSettings settings;
        settings.region = LineRegion{glm::dvec3(-1.5), glm::dvec3(1.5)};
        const auto function = prepared(RandomUnion(random, false).tape);
        const UnionParts parts(*function, settings);
        std::size_t met = 0, all = 0;
        for (int round = 0; round < 200; ++round) {
            std::vector<LineQuery> lines = randomTile(random);
            if (round % 3 == 0)
                for (LineQuery& line : lines) line.direction[round % 9 / 3] = 0;
            for (LineQuery& line : lines) line.near = std::max(line.near, 1.6), line.far = 4.2;
            const LineTable table(lines);
            const LineBundle bundle = *LineBundle::around(table.columns(), 0, lines.size());
            if (!parts.cover(bundle)) continue;
            std::vector<UnionParts::Meeting> meetings;
            parts.meet(bundle, meetings);
            QVERIFY(std::ranges::is_sorted(meetings, {}, &UnionParts::Meeting::near));
            std::vector<double> near(parts.size(), INFINITY);
            for (const UnionParts::Meeting& meeting : meetings) near[meeting.part] = meeting.near;
            all += parts.size();
            met += meetings.size();
            std::uniform_real_distribution<double> depth(bundle.near, bundle.far);
            for (int k = 0; k < 2000; ++k) {
                const LineQuery& line = lines[random() % lines.size()];
                const double t = depth(random);
                if (!(line.near <= t && t <= line.far)) continue;
                const glm::dvec3 p = line.origin + t * line.direction;
                for (std::size_t i = 0; i < parts.size(); ++i) {
                    bool inBox = true;
                    for (int axis = 0; axis < 3; ++axis)
                        inBox &= parts[i].box.low[axis] <= p[axis] && p[axis] <= parts[i].box.high[axis];
                    QVERIFY(!inBox || near[i] <= t);
                }
            }
        }
        qInfo("%zu of %zu parts met", met, all);
        QVERIFY(all > 1000 && met > 0 && 2 * met < all);
    }

    /// Part by part lines come to what they come to along the whole function.
    void rootsAreThoseOfTheWholeFunction() {
        std::mt19937_64 random(seed + 2);
        std::size_t hits = 0, lines = 0, walls = 0, edges = 0;
        for (int round = 0; round < 12; ++round) {
            RootSettings settings;
            settings.positivePolarity = round % 2 == 1;
            settings.open = round % 3 == 2;
            settings.accuracy = 1e-4;
            const auto tape = RandomUnion(random, settings.positivePolarity).tape;
            CertifiedRootFinder whole(tape, {}, settings);
            settings.region = LineRegion{glm::dvec3(-1.6), glm::dvec3(1.6)};
            QVERIFY(!UnionParts(*prepared(tape), settings).empty());
            CertifiedRootFinder byParts(tape, {}, settings);
            for (int view = 0; view < 40; ++view) {
                const std::vector<LineQuery> tile = randomTile(random);
                const std::vector<Answer> expected = answersOf(whole, tile), found = answersOf(byParts, tile);
                for (std::size_t k = 0; k < tile.size(); ++k) {
                    // Lines that graze a part may be settled otherwise.
                    if (whole.verdicts()[k] > Verdict::certifiedMiss) continue;
                    const QByteArray where = QByteArray::number(round) + ' ' + QByteArray::number(view) +
                                             ' ' + QByteArray::number(static_cast<int>(k));
                    QVERIFY2(found[k].kind == expected[k].kind, where);
                    QCOMPARE(byParts.verdicts()[k], whole.verdicts()[k]);
                    ++lines;
                    walls += found[k].kind != 0;
                    if (expected[k].t == FirstRoots::none) {
                        QCOMPARE(found[k].t, expected[k].t);
                        continue;
                    }
                    ++hits;
                    QVERIFY2(std::abs(found[k].t - expected[k].t) < 1e-3 * settings.accuracy, where);
                    edges += found[k].kind == 0 && !(glm::dot(found[k].normal, expected[k].normal) > 0.9999);
                }
            }
        }
        qInfo("%zu lines, %zu hits, %zu walls, %zu other normals", lines, hits, walls, edges);
        // On an edge it is that of either face.
        QVERIFY(edges < hits / 1000);
        QVERIFY(hits > 2000 && walls > 20 && lines > 3 * hits / 2);
    }

    /// The same of all roots of lines.
    void listsAreThoseOfTheWholeFunction() {
        std::mt19937_64 random(seed + 3);
        std::size_t lines = 0, all = 0, walls = 0;
        for (int round = 0; round < 12; ++round) {
            RootSettings settings;
            settings.positivePolarity = round % 2 == 1;
            settings.open = round % 3 == 2;
            settings.accuracy = 1e-4;
            settings.maxTrace = 10;
            const auto tape = RandomUnion(random, settings.positivePolarity).tape;
            CertifiedRootFinder whole(tape, {}, settings);
            settings.region = LineRegion{glm::dvec3(-1.6), glm::dvec3(1.6)};
            CertifiedRootFinder byParts(tape, {}, settings);
            for (int view = 0; view < 40; ++view) {
                const std::vector<LineQuery> tile = randomTile(random);
                std::vector<RootList> expected(tile.size()), found(tile.size());
                // One by one, by nothing but the whole tape.
                for (std::size_t k = 0; k < tile.size(); ++k) {
                    whole.find({&tile[k], 1}, {}, {&expected[k], 1});
                    if (whole.verdicts()[0] > Verdict::certifiedMiss) expected[k] = {{-1, RootKind::pole}};
                }
                byParts.find(tile, {}, found);
                const std::vector<Verdict> verdicts(byParts.verdicts().begin(), byParts.verdicts().end());
                for (std::size_t k = 0; k < tile.size(); ++k) {
                    if (!expected[k].empty() && expected[k][0].kind == RootKind::pole) continue;
                    if (verdicts[k] > Verdict::certifiedMiss) continue;
                    // Alone they have a tape of their own.
                    if (k % 2 == 1) byParts.find({&tile[k], 1}, {}, {&found[k], 1});
                    if (k % 2 == 1 && byParts.verdicts()[0] > Verdict::certifiedMiss) continue;
                    ++lines;
                    QCOMPARE(found[k].size(), expected[k].size());
                    for (std::size_t i = 0; i < found[k].size(); ++i) {
                        QCOMPARE(found[k][i].kind, expected[k][i].kind);
                        QVERIFY(std::abs(found[k][i].t - expected[k][i].t) < 1e-3 * settings.accuracy);
                        ++all;
                        walls += found[k][i].kind != RootKind::crossing;
                    }
                }
            }
        }
        qInfo("%zu lines, %zu roots, %zu of them walls", lines, all, walls);
        QVERIFY(lines > 20000 && all > 5000 && walls > 20);
    }

    /// 64 times as many balls on the same sphere need no more enclosures.
    void manyPartsCostWhatIsSeen() {
        const auto enclosures = [](int count) {
            const auto tape = tapeOf([count](auto x, auto y, auto z) {
                Expression least = x.number(10);
                for (int k = 0; k < count; ++k) {
                    const double height = 1 - 2 * (k + 0.5) / count, wide = std::sqrt(1 - height * height);
                    least =
                        min(least, sqrt(sq(x - 1.6 * wide * std::cos(2.39996 * k)) + sq(y - 1.6 * height) +
                                        sq(z - 1.6 * wide * std::sin(2.39996 * k))) -
                                       0.22 * std::sqrt(64.0 / count));
                }
                return least;
            });
            RootSettings settings;
            settings.region = LineRegion{glm::dvec3(-2), glm::dvec3(2)};
            CertifiedRootFinder finder(tape, {}, settings);
            std::vector<LineQuery> lines;
            for (int k = 0; k < 96 * 96; ++k) {
                const int tile = k / 64, u = tile % 12 * 8 + k % 8, v = tile / 12 * 8 + k / 8 % 8;
                lines.push_back({{(u - 47.5) / 24, (v - 47.5) / 24, -4}, {0, 0, 1}, 2, 6});
            }
            answersOf(finder, lines);
            return static_cast<double>(finder.report().evaluations) / static_cast<double>(lines.size());
        };
        const double few = enclosures(64), many = enclosures(4096);
        qInfo("%g and %g enclosures a line", few, many);
        QVERIFY(many < few);
    }
};

QTEST_MAIN(UnionPartsTest)
#include "union_parts_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// What POV-Ray's normals of the Julia sets of functions are not, which its own root finder repeats
// (golden_catalogue_test compares them) and ours does not.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <QTest>
#include <set>

#include "core/language/parse.h"
#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

/// Far below the features of these sets, far above the rounding of a hit.
constexpr double apart = 1e-6;

std::optional<Hit> firstHit(const Shape& shape, const Ray& ray, RootFinder finder = RootFinder::certified) {
    TraceContext context({}, finder);
    NearestHit nearest;
    shape.nearest(std::span(&ray, 1), context, std::span(&nearest, 1));
    return nearest.found ? std::optional<Hit>(nearest.hit) : std::nullopt;
}

/// The normal of the surface itself: of the plane through the hits of four rays beside one another. Empty
/// where those do not lie in one plane, at creases and at the edges of what is seen.
std::optional<glm::dvec3> measuredNormal(const Shape& shape, const Ray& ray) {
    const glm::dvec3 beside = std::abs(ray.direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = apart * glm::normalize(glm::cross(ray.direction, beside));
    const glm::dvec3 v = apart * glm::normalize(glm::cross(ray.direction, u));
    std::array<glm::dvec3, 4> points;
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec3 moved = (k < 2 ? u : v) * (k % 2 == 0 ? 1.0 : -1.0);
        const std::optional<Hit> hit = firstHit(shape, {ray.origin + moved, ray.direction});
        if (!hit) return std::nullopt;
        points[k] = hit->point;
    }
    const glm::dvec3 middle = (points[0] + points[1] - points[2] - points[3]) / 2.0;
    const glm::dvec3 across = glm::cross(points[1] - points[0], points[3] - points[2]);
    if (!(glm::length(across) > 0) || glm::length(middle) > 1e-3 * apart) return std::nullopt;
    return glm::normalize(across);
}

struct Counts {
    int measured = 0, ours = 0, povrays = 0;
};

}  // namespace

class JuliaNormalsTest : public QObject {
    Q_OBJECT

  private slots:
    /// With one iteration the surface is the sphere of radius 4 for every function. POV-Ray 3.7 hits it, and
    /// answers with these normals, which are not the sphere's but follow a rule of its own.
    void povrayIsOffOnASphere() {
        struct Case {
            const char* function;
            glm::dvec3 point, povrays;
        };
        const glm::dvec3 point(1.06904494, 2.13808988, 3.20713482);
        const std::array<Case, 3> cases{{{"exp", point, {-0.93980050, 0.24163507, 0.24163507}},
                                         {"reciprocal", point, {-0.52026598, 0.34684399, -0.78039897}},
                                         {"sin", point, {0.55079041, -0.59018214, -0.59018214}}}};
        for (const Case& one : cases) {
            const ParseResult parsed =
                parseScene("#declare Shape = julia_fractal { <0, 0, 0, 0> hypercomplex " +
                           std::string(one.function) + " max_iteration 1 precision 10000 }");
            const ShapePointer shape = declaredShape(parsed, "Shape");
            QVERIFY(shape);
            const std::optional<Hit> hit = firstHit(*shape, {1.5 * one.point, -one.point});
            QVERIFY(hit);
            QVERIFY(glm::distance(hit->point, one.point) < 1e-4);
            QVERIFY(glm::distance(hit->normal, glm::normalize(one.point)) < 1e-7);
            QVERIFY(glm::distance(one.povrays, glm::normalize(one.point)) > 0.5);
            const std::optional<Hit> known =
                firstHit(*shape, {1.5 * one.point, -one.point}, RootFinder::lipschitz);
            QVERIFY(known && glm::distance(known->point, one.point) < 1e-4);
            QVERIFY(glm::distance(known->normal, one.povrays) < 1e-4);
        }
    }

    /// What trace() of POV-Ray 3.7.0.10 answers for a slice off the origin; golden/rays.csv has none of a
    /// function.
    void povraysRootFinderAnswersForSlices() {
        struct Case {
            Ray ray;
            glm::dvec3 point, normal;
        };
        const std::array<Case, 4> cases{{{{{0.359375, 4.796875, -3.578125}, {0.140625, -6.53125, 1.625}},
                                          {0.5216825639, -2.741409635, -1.702570928},
                                          {0.248457862, -0.6881458496, -0.6817066675}},
                                         {{{2.953125, -4.890625, -1.84375}, {-2.40625, 6.359375, 1.9375}},
                                          {0.7299152841, 0.9850006778, -0.05363308588},
                                          {0.3828379215, 0.6532376517, -0.6532347941}},
                                         {{{-0.609375, 1.796875, 5.6875}, {1.484375, -0.28125, -4.828125}},
                                          {0.9936180633, 1.493149999, 0.4735541415},
                                          {0.7167999101, 0.493032915, -0.4930683863}},
                                         {{{-4.734375, -2.765625, -2.421875}, {6.15625, 4.734375, 3.109375}},
                                          {0.05762785332, 0.9195954684, -0.001548685761},
                                          {-0.6051823773, 0.5628526228, 0.5629842051}}}};
        const ParseResult parsed = parseScene(
            "#declare Shape = julia_fractal { <0.1, 0.3, -0.2, 0.1> hypercomplex exp max_iteration 5 "
            "precision 10000 slice <0.2, -0.1, 0.4, 1>, 0.3 }");
        const ShapePointer shape = declaredShape(parsed, "Shape");
        QVERIFY(shape);
        for (const Case& one : cases) {
            const std::optional<Hit> hit = firstHit(*shape, one.ray, RootFinder::lipschitz);
            QVERIFY(hit);
            QVERIFY(glm::distance(hit->point, one.point) < 1e-8);
            QVERIFY(glm::distance(hit->normal, one.normal) < 1e-6);
        }
    }

    /// Our normals are those of the surface, measured by hits beside one another, also where it is a cut of
    /// the function (ln, pwr and the inverse ones). POV-Ray's never are.
    void oursAreThoseOfTheSurface_CONF_95() {
        const test::CsvTable rays(test::dataFile("golden/rays.csv"));
        std::map<std::string, Counts> shapes;
        std::map<std::string, ShapePointer> parsed;
        for (std::size_t row = 0; row < rays.rowCount(); ++row) {
            // Five rays a row are slow enough for every third.
            if (test::hasSharedData() && row % 3 != 0) continue;
            const std::string& name = rays.field(row, "shape");
            if (!name.starts_with("julia_hyper_") || name.starts_with("julia_hyper_sqr") ||
                rays.field(row, "hit") != "1" || rays.field(row, "fragile") == "1" ||
                rays.field(row, "nfragile") == "1")
                continue;
            ShapePointer& shape = parsed[name];
            if (!shape) {
                const QString file = test::dataFile("golden/shapes/" + QString::fromStdString(name) + ".inc");
                shape = declaredShape(parseSceneFile(file.toStdString()), "Shape");
            }
            QVERIFY(shape);
            const auto vector = [&](const char* prefix) {
                const std::string p(prefix);
                return glm::dvec3(rays.number(row, p + "x"), rays.number(row, p + "y"),
                                  rays.number(row, p + "z"));
            };
            const Ray ray{vector("o"), vector("d")};
            const std::optional<Hit> hit = firstHit(*shape, ray);
            const std::optional<glm::dvec3> normal = measuredNormal(*shape, ray);
            if (!hit || !normal) continue;
            const auto agrees = [&](const glm::dvec3& other) {
                return glm::length(glm::cross(other, *normal)) < 1e-2;
            };
            Counts& counts = shapes[name];
            ++counts.measured;
            counts.ours += agrees(hit->normal);
            counts.povrays += agrees(vector("n"));
        }
        Counts all;
        for (const auto& [name, counts] : shapes) {
            qInfo("%-24s %3d normals measured: ours agree in %3d rows, POV-Ray's in %3d", name.c_str(),
                  counts.measured, counts.ours, counts.povrays);
            all.measured += counts.measured;
            all.ours += counts.ours;
            all.povrays += counts.povrays;
        }
        qInfo("%d normals: ours agree in %d, POV-Ray's in %d", all.measured, all.ours, all.povrays);
        QVERIFY(all.measured > (test::hasSharedData() ? 400 : 20));
        QCOMPARE(all.ours, all.measured);
        QVERIFY(all.povrays <= 0.01 * all.measured);
    }
};

QTEST_APPLESS_MAIN(JuliaNormalsTest)
#include "julia_normals_test.moc"

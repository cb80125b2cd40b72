// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/combined/csg.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/shapes/combined/clipped_shape.h"
#include "core/shapes/combined/inverse_shape.h"
#include "core/shapes/combined/placed_shape.h"
#include "core/shapes/patches/triangle.h"
#include "core/shapes/solids/box.h"
#include "core/shapes/solids/cone.h"
#include "core/shapes/solids/disc.h"
#include "core/shapes/solids/plane.h"
#include "core/shapes/solids/quadric.h"
#include "core/shapes/solids/sphere.h"

using namespace isoscope;

namespace {

ShapePointer sphereAt(double x, MaterialId material = noMaterial) {
    return std::make_shared<PlacedShape>(std::make_shared<Sphere>(glm::dvec3(0), 1),
                                         Transform::translation({x, 0, 0}), material);
}

ShapePointer csg(CsgOperation operation, std::vector<ShapePointer> parts) {
    return std::make_shared<Csg>(operation, std::move(parts));
}

/// x^2 + z^2 < y^2 with 0 < y < 1, of endless parts.
ShapePointer quadricCone() {
    return csg(CsgOperation::intersection,
               {std::make_shared<Quadric>(glm::dvec3(1, -1, 1), glm::dvec3(0), glm::dvec3(0), 0),
                std::make_shared<Plane>(glm::dvec3(0, 1, 0), 1),
                std::make_shared<InverseShape>(std::make_shared<Plane>(glm::dvec3(0, 1, 0), 0))});
}

/// t of all hits of the x axis from x = -10, less 10.
std::vector<double> alongX(const Shape& shape) {
    TraceContext context;
    HitList hits;
    shape.intersect({{-10, 0, 0}, {1, 0, 0}}, {}, context, hits);
    std::vector<double> result;
    for (const Hit& hit : hits) result.push_back(hit.t - 10);
    return result;
}

using Numbers = std::vector<double>;

}  // namespace

class CsgTest : public QObject {
    Q_OBJECT

  private slots:
    void unionKeepsInnerSurfaces() {
        QCOMPARE(alongX(*csg(CsgOperation::union_, {sphereAt(0.5), sphereAt(-0.5)})),
                 (Numbers{-1.5, -0.5, 0.5, 1.5}));
    }

    void mergeDropsInnerSurfaces() {
        QCOMPARE(alongX(*csg(CsgOperation::merge, {sphereAt(0.5), sphereAt(-0.5)})), (Numbers{-1.5, 1.5}));
    }

    /// It ended with the box around the disc.
    void theInsideOfADiscHasNoEnd() {
        const auto disc = std::make_shared<Disc>(glm::dvec3(0), glm::dvec3(1, 0, 0), 0.1);
        TraceContext context;
        const ShapePointer merged = csg(CsgOperation::merge, {disc, sphereAt(0)});
        QVERIFY(merged->contains({-50, 70, 0}, context));
        QCOMPARE(alongX(*merged), (Numbers{1}));
        // But it cuts off what it is intersected with, as in POV-Ray.
        const ShapePointer shared = csg(CsgOperation::intersection, {disc, sphereAt(0)});
        QVERIFY(shared->contains({-0.5, 0.5, 0}, context));
        QCOMPARE(shared->bounds().high.y, 0.1);
    }

    /// min_extent and max_extent of POV-Ray, to five digits.
    void boundsOfDiscsAreThoseOfPovray() {
        const std::pair<glm::dvec3, glm::dvec3> reaches[] = {
            {{0, 0, 1}, {1, 1, 0.001}},
            {{0, 0, -1}, {1, 1, 0.001}},
            {{0, 1, 0}, {1, 0.001, 1}},
            {{0, 1, 1}, {1, 0.70781, 0.70781}},
            {{1, 1, 0}, {1.00071, 1.00071, 1.41421}},
            {{1, 1, 1}, {1.00058, 1.00058, 1.15528}},
            {{1, 2, 3}, {1.03991, 0.92125, 0.80259}},
            {{-1, 2, -3}, {1.36062, 1.16268, 0.80259}},
        };
        for (const auto& [normal, reach] : reaches) {
            const Bounds bounds = Disc(glm::dvec3(0), normal, 1).bounds();
            QVERIFY(bounds.low == -bounds.high);
            QVERIFY(glm::length(bounds.high - reach) < 2e-5);
        }
    }

    /// Rounding made the box too small there.
    void discsCloseToTheNegativeZAxisKeepTheirBounds() {
        for (double tilt = 1e-12; tilt < 1e-3; tilt *= 1.01) {
            const Bounds bounds = Disc(glm::dvec3(0), {tilt, 0, -1}, 1).bounds();
            QVERIFY(bounds.high.x > 1 - 1e-6 && bounds.high.y > 1 - 1e-6);
        }
    }

    void intersectionKeepsWhatIsShared() {
        QCOMPARE(alongX(*csg(CsgOperation::intersection, {sphereAt(0.5), sphereAt(-0.5)})),
                 (Numbers{-0.5, 0.5}));
    }

    void differenceCutsAndTurnsNormalsOutwards() {
        const ShapePointer shape = csg(CsgOperation::difference, {sphereAt(0, 7), sphereAt(0.5, 8)});
        QCOMPARE(alongX(*shape), (Numbers{-1, -0.5}));
        TraceContext context;
        HitList hits;
        shape->intersect({{-10, 0, 0}, {1, 0, 0}}, {}, context, hits);
        QCOMPARE(hits[0].normal, glm::dvec3(-1, 0, 0));
        QCOMPARE(hits[1].normal, glm::dvec3(1, 0, 0));
        QCOMPARE(hits[0].material, 7);
        QCOMPARE(hits[1].material, 8);
        QVERIFY(shape->contains({-0.9, 0, 0}, context));
        QVERIFY(!shape->contains({0, 0, 0}, context));
    }

    /// The walls of one sphere inside the other used to stand in the hole.
    void whatIsCutOutHasNoWallsInside() {
        const ShapePointer box = std::make_shared<Box>(glm::dvec3(-5), glm::dvec3(5));
        const ShapePointer pair = csg(CsgOperation::union_, {sphereAt(0.5), sphereAt(-0.5)});
        QCOMPARE(alongX(*csg(CsgOperation::difference, {box, pair})), (Numbers{-5, -1.5, 1.5, 5}));
        const ShapePointer placed = std::make_shared<PlacedShape>(pair, Transform::translation({1, 0, 0}));
        QCOMPARE(alongX(*csg(CsgOperation::difference, {box, placed})), (Numbers{-5, -0.5, 2.5, 5}));
        const ShapePointer nested = csg(CsgOperation::union_, {pair, sphereAt(1.5)});
        QCOMPARE(alongX(InverseShape(nested)), (Numbers{-1.5, 2.5}));
        QCOMPARE(alongX(*csg(CsgOperation::intersection, {box, pair})), (Numbers{-1.5, -0.5, 0.5, 1.5}));
    }

    void inverseLeavesClipsAsTheyAre() {
        const ShapePointer left = std::make_shared<Plane>(glm::dvec3(1, 0, 0), 0.25);
        const ShapePointer clipped =
            std::make_shared<ClippedShape>(sphereAt(0), std::vector<ShapePointer>{left});
        const ShapePointer inverse = inverseOf(clipped);
        TraceContext context;
        QVERIFY(inverse->contains({-2, 0, 0}, context));
        QVERIFY(!inverse->contains({0, 0, 0}, context));
        QVERIFY(!inverse->contains({2, 0, 0}, context));
        QCOMPARE(inverseOf(inverseOf(sphereAt(0)))->contains({0, 0, 0}, context), true);
    }

    /// All of space was outside of them, so that nothing was cut off by a difference.
    void patchesHaveNoOutside() {
        const ShapePointer patch = std::make_shared<Triangle>(
            Triangle::Corners{glm::dvec3(0, 5, 0), glm::dvec3(0, 6, 0), glm::dvec3(0, 5, 1)});
        TraceContext context;
        QVERIFY(!inverseOf(patch)->contains({0, 0, 0}, context));
        const ShapePointer pair = csg(CsgOperation::union_, {sphereAt(5), patch});
        QVERIFY(!inverseOf(pair)->contains({0, 0, 0}, context));
        QVERIFY(inverseOf(csg(CsgOperation::union_, {sphereAt(5)}))->contains({0, 0, 0}, context));
        QCOMPARE(alongX(*csg(CsgOperation::difference, {sphereAt(0), patch})), Numbers{});
    }

    /// Which of equal hits shows, as measured on POV-Ray.
    void ofEqualHitsPovraysShows() {
        const ShapePointer red = sphereAt(0, 1), green = sphereAt(0, 2), blue = sphereAt(0, 3);
        const ShapePointer all = std::make_shared<Box>(glm::dvec3(-5), glm::dvec3(5));
        const ShapePointer pair = csg(CsgOperation::union_, {red, green});
        const auto shown = [](const ShapePointer& shape) {
            TraceContext context;
            NearestHit hit;
            const Ray ray{{-3, 0, 0}, {1, 0, 0}};
            shape->nearest({&ray, 1}, context, {&hit, 1});
            return hit.hit.material;
        };
        using enum CsgOperation;
        QCOMPARE(shown(pair), 1);
        QCOMPARE(shown(csg(union_, {blue, pair})), 3);
        QCOMPARE(shown(csg(merge, {red, green})), 2);
        QCOMPARE(shown(csg(merge, {red, green, blue})), 3);
        QCOMPARE(shown(csg(merge, {blue, csg(merge, {red, green})})), 1);
        QCOMPARE(shown(csg(merge, {pair, blue})), 3);
        QCOMPARE(shown(csg(union_, {blue, csg(merge, {red, green})})), 3);
        QCOMPARE(shown(csg(merge, {csg(intersection, {pair, all})})), 2);
        QCOMPARE(shown(csg(difference, {csg(difference, {pair, sphereAt(9)}), sphereAt(9)})), 2);
        QCOMPARE(shown(std::make_shared<ClippedShape>(pair, std::vector<ShapePointer>{all})), 2);
    }

    /// Rounding on the common surface used to leave holes in it.
    void sharedWallsHaveNoHoles() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> number(-1, 1);
        const ShapePointer sphere = std::make_shared<Sphere>(glm::dvec3(0.1, 0.2, 0.3), 0.9);
        const ShapePointer same = std::make_shared<Sphere>(glm::dvec3(0.1, 0.2, 0.3), 0.9);
        const ShapePointer large = std::make_shared<Box>(glm::dvec3(-2), glm::dvec3(2));
        const auto twice = csg(CsgOperation::intersection, {sphere, same});
        const auto joined = csg(CsgOperation::merge, {sphere, same});
        const auto cut = csg(CsgOperation::difference, {large, sphere, same});
        for (int k = 0; k < 500; ++k) {
            const Ray ray{{number(random), number(random), -1.5},
                          {0.3 * number(random), 0.3 * number(random), 1}};
            TraceContext context;
            HitList expected;
            sphere->intersect(ray, {}, context, expected);
            const auto places = [&](const Shape& shape) {
                HitList hits;
                shape.intersect(ray, {}, context, hits);
                std::vector<double> result;
                for (const Hit& hit : hits)
                    if (result.empty() || hit.t != result.back()) result.push_back(hit.t);
                return result;
            };
            Numbers wanted;
            for (const Hit& hit : expected) wanted.push_back(hit.t);
            QCOMPARE(places(*twice), wanted);
            QCOMPARE(places(*joined), wanted);
            HitList whole;
            large->intersect(ray, {}, context, whole);
            for (const Hit& hit : whole) wanted.push_back(hit.t);
            std::sort(wanted.begin(), wanted.end());
            QCOMPARE(places(*cut), wanted);
        }
    }

    /// nearest() asks no further than it has to.
    void theNearestIsTheFirstOfAll() {
        const unsigned seed = std::random_device{}();
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        const auto place = [&] { return glm::dvec3(number(random), number(random), number(random)); };
        const auto part = [&]() -> ShapePointer {
            return std::make_shared<PlacedShape>(
                quadricCone(), Transform::rotation(90.0 * place()).then(Transform::translation(place())));
        };
        for (const CsgOperation operation :
             {CsgOperation::merge, CsgOperation::intersection, CsgOperation::difference})
            for (int k = 0; k < 200; ++k) {
                const ShapePointer shape =
                    csg(operation, {part(), csg(CsgOperation::difference, {part(), sphereAt(0.5)}), part()});
                const Ray ray{4.0 * place(), place()};
                TraceContext context;
                HitList all;
                shape->intersect(ray, {}, context, all);
                NearestHit nearest;
                shape->nearest({&ray, 1}, context, {&nearest, 1});
                QCOMPARE(nearest.found, !all.empty());
                if (nearest.found) QCOMPARE(nearest.hit.t, all.front().t);
                QVERIFY(context.partHits.empty());
            }
    }

    /// Endless parts used to be asked about every ray.
    void partsThatBoundEachOtherAreNotAskedFromAfar() {
        const ShapePointer cone = quadricCone();
        QVERIFY(!cone->bounds().finite());
        const Bounds box = cone->boundsWithin({});
        QVERIFY(box.finite());
        QVERIFY(glm::distance(box.low, glm::dvec3(-1, 0, -1)) < 1e-6);
        QVERIFY(glm::distance(box.high, glm::dvec3(1, 1, 1)) < 1e-6);
        TraceContext context;
        for (const ShapePointer& shape :
             {cone, ShapePointer(std::make_shared<PlacedShape>(cone, Transform::rotation({0, 45, 0})))}) {
            HitList hits;
            shape->intersect({{-5, 1.1, 0}, {1, 0, 0}}, {}, context, hits);
            QCOMPARE(context.rays, std::uint64_t{0});
        }
        HitList hits;
        cone->intersect({{-5, 0.5, 0}, {1, 0, 0}}, {}, context, hits);
        QCOMPARE(hits.size(), std::size_t{2});
        QCOMPARE(context.rays, std::uint64_t{3});
    }

    void materialOfThePartWinsOverTheWhole() {
        const ShapePointer parts = csg(CsgOperation::union_, {sphereAt(-2, 3), sphereAt(2)});
        const PlacedShape whole(parts, Transform(), 9);
        TraceContext context;
        HitList hits;
        whole.intersect({{-10, 0, 0}, {1, 0, 0}}, {}, context, hits);
        QCOMPARE(hits[0].material, 3);
        QCOMPARE(hits[2].material, 9);
    }

    void inverseSwapsInsideAndOutside() {
        const InverseShape inverse(sphereAt(0));
        TraceContext context;
        QVERIFY(!inverse.contains({0, 0, 0}, context));
        QVERIFY(inverse.contains({2, 0, 0}, context));
        std::vector<NearestHit> nearest(1);
        const std::vector<Ray> rays{{{-10, 0, 0}, {1, 0, 0}}};
        inverse.nearest(rays, context, nearest);
        QCOMPARE(nearest[0].hit.normal, glm::dvec3(1, 0, 0));
    }

    void movedTwiceIsMovedOnce() {
        const ShapePointer inner =
            std::make_shared<PlacedShape>(sphereAt(1, 3), Transform::scaling({1, 2, 1}), 4);
        const PlacedShape outer(inner, Transform::translation({1, 0, 0}), 5);
        QVERIFY(!dynamic_cast<const PlacedShape*>(outer.shape().get()));
        QCOMPARE(outer.material(), 3);
        QCOMPARE(alongX(outer), (Numbers{1, 3}));
        QCOMPARE(outer.bounds().high, glm::dvec3(3, 2, 1));
    }

    void clippingLeavesOpenCuts() {
        const auto half = std::make_shared<Plane>(glm::dvec3(1, 0, 0), 0);
        const ClippedShape clipped(sphereAt(0), {half});
        QCOMPARE(alongX(clipped), (Numbers{-1}));
        TraceContext context;
        QVERIFY(clipped.contains({-0.5, 0, 0}, context));
        QVERIFY(!clipped.contains({0.5, 0, 0}, context));
        QCOMPARE(clipped.bounds().high.x, 0.0);
    }

    void noPartsAreEmpty() {
        for (const CsgOperation operation : {CsgOperation::union_, CsgOperation::merge,
                                             CsgOperation::intersection, CsgOperation::difference}) {
            const ShapePointer empty = csg(operation, {});
            TraceContext context;
            QVERIFY(alongX(*empty).empty());
            QVERIFY(!empty->contains({0, 0, 0}, context));
        }
    }

    void intervalAndKnownHitsAreHonoured() {
        const ShapePointer two = csg(CsgOperation::union_, {sphereAt(-2), sphereAt(2)});
        TraceContext context;
        HitList hits;
        two->intersect({{-10, 0, 0}, {1, 0, 0}}, {8, 12}, context, hits);
        QCOMPARE(hits.size(), std::size_t(2));
        const std::vector<Ray> rays(2, {{-10, 0, 0}, {1, 0, 0}});
        std::vector<NearestHit> nearest(2);
        nearest[0].found = true;
        nearest[0].hit.t = 5;
        nearest[0].hit.material = 77;
        two->nearest(rays, context, nearest);
        QCOMPARE(nearest[0].hit.material, 77);
        QCOMPARE(nearest[1].hit.t, 7.0);
        context.nearLimit = 8;
        nearest.assign(2, {});
        two->nearest(rays, context, nearest);
        QCOMPARE(nearest[1].hit.t, 9.0);
    }

    void nearestAndAllHitsAgreeWithIntersect() {
        const unsigned seed = 99;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-2, 2);
        const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
        std::size_t found = 0;
        for (int round = 0; round < 60; ++round) {
            std::vector<ShapePointer> parts;
            for (int k = 0; k < 4; ++k) {
                ShapePointer part = std::make_shared<Sphere>(point(), 1.2);
                if (k == 1) part = std::make_shared<Box>(point(), point());
                if (k == 2) part = std::make_shared<Plane>(point(), 0.3);
                part = std::make_shared<PlacedShape>(part, Transform::rotation(40.0 * point()), k);
                if (k == 3) part = csg(CsgOperation::difference, {part, parts[0]});
                if (round % 3 == 0 && k == 1) part = std::make_shared<InverseShape>(part);
                if (round % 5 == 0 && k == 0)
                    part = std::make_shared<ClippedShape>(part, std::vector<ShapePointer>{sphereAt(0)});
                parts.push_back(part);
            }
            const ShapePointer shape = csg(static_cast<CsgOperation>(round % 4), parts);
            std::vector<Ray> rays;
            for (int k = 0; k < 100; ++k) rays.push_back({2.0 * point(), point()});
            TraceContext context;
            std::vector<HitList> all(rays.size());
            std::vector<NearestHit> nearest(rays.size());
            shape->allHits(rays, context, all);
            shape->nearest(rays, context, nearest);
            const Bounds bounds = shape->bounds();
            for (std::size_t k = 0; k < rays.size(); ++k) {
                HitList hits;
                shape->intersect(rays[k], {}, context, hits);
                QCOMPARE(all[k].size(), hits.size());
                QCOMPARE(nearest[k].found, !hits.empty());
                found += hits.size();
                for (std::size_t i = 0; i < hits.size(); ++i) {
                    QCOMPARE(all[k][i].t, hits[i].t);
                    QCOMPARE(all[k][i].normal, hits[i].normal);
                    QCOMPARE(all[k][i].material, hits[i].material);
                    QVERIFY(i == 0 || hits[i - 1].t <= hits[i].t);
                    QVERIFY(std::abs(glm::length(hits[i].normal) - 1) < 1e-12);
                    for (int axis = 0; axis < 3; ++axis)
                        QVERIFY(bounds.low[axis] - 1e-9 <= hits[i].point[axis] &&
                                hits[i].point[axis] <= bounds.high[axis] + 1e-9);
                }
                if (!hits.empty()) {
                    QCOMPARE(nearest[k].hit.t, hits[0].t);
                    // Of equal hits unions show the first, but hand on the last to what they are part of.
                    if (hits.size() < 2 || hits[1].t != hits[0].t)
                        QCOMPARE(nearest[k].hit.normal, hits[0].normal);
                }
            }
        }
        QVERIFY(found > 1000);
    }

    /// 10 000 parts: the same answers as from all of them, by asking a few.
    void manyPartsAreFoundByATree() {
        const unsigned seed = std::random_device()();
        qInfo("random seed %u", seed);
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> flat(-1, 1);
        const auto point = [&] { return glm::dvec3(flat(random), flat(random), flat(random)); };
        std::vector<ShapePointer> parts;
        for (int i = 0; i < 10'000; ++i) {
            const glm::dvec3 at = point();
            if (i % 2 == 0)
                parts.push_back(std::make_shared<Sphere>(at, 0.02));
            else
                parts.push_back(std::make_shared<Cone>(at, 0.01, at + 0.05 * point(), 0.01, false));
        }
        const Csg joined(CsgOperation::union_, parts);
        std::vector<Ray> rays;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 from = 3.0 * point();
            rays.push_back({from, point() - from});
        }
        TraceContext context;
        std::vector<NearestHit> found(rays.size()), wanted(rays.size());
        joined.nearest(rays, context, found);
        const double asked = static_cast<double>(context.rays) / static_cast<double>(rays.size());
        for (const ShapePointer& part : parts) part->nearest(rays, context, wanted);
        int hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            QCOMPARE(found[i].found, wanted[i].found);
            if (!found[i].found) continue;
            QCOMPARE(found[i].hit.t, wanted[i].hit.t);
            ++hits;
        }
        qInfo("%.1f of 10000 parts asked a ray, %d hits", asked, hits);
        QVERIFY(hits > 100);
        QVERIFY(asked < 10);
    }

    void treesKeepAllHitsOfUnionsAndMerges() {
        std::mt19937_64 random(7);
        std::uniform_real_distribution<double> flat(-1, 1);
        const auto point = [&] { return glm::dvec3(flat(random), flat(random), flat(random)); };
        std::vector<ShapePointer> parts, few;
        for (int i = 0; i < 40; ++i) parts.push_back(std::make_shared<Sphere>(point(), 0.4));
        // Without a tree: unions of few parts in one another.
        for (std::size_t i = 0; i < parts.size(); i += 8)
            few.push_back(csg(CsgOperation::union_,
                              std::vector<ShapePointer>(parts.begin() + static_cast<long>(i),
                                                        parts.begin() + static_cast<long>(i) + 8)));
        const ShapePointer together = csg(CsgOperation::union_, parts),
                           nested = csg(CsgOperation::union_, few);
        const ShapePointer merged = csg(CsgOperation::merge, parts);
        for (int i = 0; i < 200; ++i) {
            const Ray ray{3.0 * point(), point()};
            TraceContext context;
            HitList one, other, outer;
            together->intersect(ray, {}, context, one);
            nested->intersect(ray, {}, context, other);
            merged->intersect(ray, {}, context, outer);
            QCOMPARE(one.size(), other.size());
            for (std::size_t k = 0; k < one.size(); ++k) QCOMPARE(one[k].t, other[k].t);
            // What a merge shows are the hits outside of all other spheres.
            std::size_t visible = 0;
            for (const Hit& hit : one) {
                int inside = 0;
                for (const ShapePointer& part : parts)
                    inside += part->contains(hit.point - 1e-9 * hit.normal, context);
                visible += inside == 1;
            }
            QCOMPARE(outer.size(), visible);
        }
    }
};

QTEST_APPLESS_MAIN(CsgTest)
#include "csg_test.moc"

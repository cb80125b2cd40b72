// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/isosurface/parametric.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>
#include <random>

#include "core/language/parse.h"
#include "core/shapes/solids/sphere.h"
#include "core/shapes/solids/torus.h"

using namespace isoscope;

namespace {

const char* const sphereText =
    "parametric { function { sin(u)*cos(v) } function { sin(u)*sin(v) } function { cos(u) } "
    "<0, 0>, <pi, 2*pi> contained_by { box { -1.1, 1.1 } } }";
const char* const torusText =
    "parametric { function { (1 + 0.35*cos(u))*cos(v) } function { 0.35*sin(u) } "
    "function { (1 + 0.35*cos(u))*sin(v) } <0, 0>, <2*pi, 2*pi> contained_by { box { -1.5, 1.5 } } "
    "accuracy 1e-5 max_gradient 6 precompute 14 x, y, z }";

struct Parsed {
    ShapePointer shape;
    std::shared_ptr<const std::vector<double>> parameters;
};

Parsed parsed(const std::string& object) {
    const ParseResult result = parseScene("#version 3.7;\n#declare Shape = " + object);
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.severity == Severity::error) qWarning("%s", diagnostic.message.c_str());
    return {declaredShape(result, "Shape"), result.scene->parameterTable};
}

HitList hitsOf(const Parsed& surface, const Ray& ray) {
    TraceContext context(surface.parameters, RootFinder::certified);
    HitList hits;
    surface.shape->intersect(ray, {}, context, hits);
    return hits;
}

/// Rays from a sphere of radius 4 to points near the origin.
std::vector<Ray> someRays(std::size_t count) {
    const unsigned seed = std::random_device()();
    qInfo("random seed %u", seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> flat(-1.3, 1.3);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const glm::dvec3 from =
            4.0 * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        rays.push_back({from, 0.5 * (glm::dvec3(flat(random), flat(random), flat(random)) - from)});
    }
    return rays;
}

/// All hits of `surface` against those of the same body in closed form, but for rays that graze it.
void compareWith(const Parsed& surface, const Shape& body, int least) {
    TraceContext context;
    int compared = 0;
    for (const Ray& ray : someRays(3000)) {
        HitList wanted;
        body.intersect(ray, {}, context, wanted);
        const bool grazes = std::any_of(wanted.begin(), wanted.end(), [&](const Hit& hit) {
            return std::abs(glm::dot(hit.normal, ray.direction)) < 1e-3 * glm::length(ray.direction);
        });
        if (grazes) continue;
        const HitList found = hitsOf(surface, ray);
        QCOMPARE(found.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            QVERIFY2(std::abs(found[i].t - wanted[i].t) < 1e-9,
                     qPrintable(QString("t is off by %1").arg(found[i].t - wanted[i].t)));
            QVERIFY(std::abs(std::abs(glm::dot(found[i].normal, wanted[i].normal)) - 1) < 1e-9);
        }
        compared += static_cast<int>(wanted.size());
    }
    QVERIFY(compared > least);
}

}  // namespace

class ParametricTest : public QObject {
    Q_OBJECT

  private slots:
    void sphereIsTheSphere() { compareWith(parsed(sphereText), Sphere({0, 0, 0}, 1), 1000); }

    void torusIsTheTorus() {
        // POV-Ray's own torus lies in the x-z plane, too.
        compareWith(parsed(torusText), Torus(1, 0.35), 1000);
    }

    void polesAndSeamsAreClosed() {
        const Parsed sphere = parsed(sphereText), torus = parsed(torusText);
        QCOMPARE(hitsOf(sphere, {{0, 0, -4}, {0, 0, 1}}).size(), std::size_t(2));
        // v = 0 and v = 2 pi are the same place of the surface, and one hit.
        const HitList onSeam = hitsOf(torus, {{4, 0, 0}, {-1, 0, 0}});
        QCOMPARE(onSeam.size(), std::size_t(4));
        QVERIFY(std::abs(onSeam[0].t - 2.65) < 1e-12);
    }

    void nearestIsTheFirstHit() {
        const Parsed torus = parsed(torusText);
        const std::vector<Ray> rays = someRays(300);
        TraceContext context(torus.parameters, RootFinder::certified);
        std::vector<NearestHit> nearest(rays.size());
        torus.shape->nearest(rays, context, nearest);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const HitList all = hitsOf(torus, rays[i]);
            QCOMPARE(nearest[i].found, !all.empty());
            if (!all.empty()) QVERIFY(std::abs(nearest[i].hit.t - all[0].t) < 1e-12);
        }
    }

    void containersCutTheSurface() {
        const Parsed half = parsed(
            "parametric { function { u } function { v } function { 0 } <-3, -3>, <3, 3> "
            "contained_by { sphere { <1, 0, 0>, 0.5 } } }");
        QCOMPARE(hitsOf(half, {{1.4, 0, -1}, {0, 0, 1}}).size(), std::size_t(1));
        QCOMPARE(hitsOf(half, {{1.4, 0.4, -1}, {0, 0, 1}}).size(), std::size_t(0));
        QCOMPARE(half.shape->bounds().low, glm::dvec3(0.5, -0.5, -0.5));
    }

    void normalsAreUCrossV() {
        const Parsed sheet =
            parsed("parametric { function { u } function { v } function { 0 } <-1, -1>, <1, 1> }");
        QCOMPARE(hitsOf(sheet, {{0.3, 0.2, -1}, {0, 0, 1}})[0].normal, glm::dvec3(0, 0, 1));
    }

    void patchesContainNothing() {
        TraceContext context;
        QVERIFY(!parsed(sphereText).shape->contains({0, 0, 0}, context));
    }

    /// Jumps, poles, NaN and touching rays cost a limited number of evaluations, and nothing crashes.
    void hostileFunctionsEnd_data() {
        QTest::addColumn<QString>("z");
        for (const char* z : {"floor(10*u)", "1/u", "sqrt(u)", "ln(u*v)", "u*u", "sin(1e6*u*v)", "0/0*u",
                              "select(u, -1, 1)", "pow(u, 1/3)", "1e300*exp(1000*u)", "f_noise3d(u, v, 0)"})
            QTest::newRow(z) << QString(z);
    }
    void hostileFunctionsEnd() {
        QFETCH(QString, z);
        const Parsed surface =
            parsed("parametric { function { u } function { v } function { " + z.toStdString() +
                   " } <-1, -1>, <1, 1> contained_by { box { -2, 2 } } }");
        if (!surface.shape) return;  // 0/0 is refused already
        for (const Ray& ray :
             {Ray{{-3, 0.1, 0}, {1, 0, 0}}, Ray{{0, 0, -3}, {0, 0, 1}}, Ray{{0.2, 0.1, -3}, {0.01, 0.02, 1}},
              Ray{{0, 0, 0}, {0, 0, 0}}, Ray{{NAN, 0, 0}, {1, 0, 0}}}) {
            TraceContext context(surface.parameters, RootFinder::certified);
            HitList hits;
            surface.shape->intersect(ray, {}, context, hits);
            QVERIFY(context.evaluations < 20u * Parametric::cellLimit);
            for (const Hit& hit : hits) QVERIFY(std::isfinite(hit.t) && !std::isnan(hit.normal.x));
        }
    }

    /// One tangent plane, smooth sheets beside a jump: the sheets are there, the jump is not bridged.
    void jumpsAreNotBridged() {
        const Parsed stairs =
            parsed("parametric { function { u } function { v } function { floor(u) } <-0.7, -1>, <0.8, 1> }");
        QCOMPARE(hitsOf(stairs, {{0.3, 0.1, -3}, {0, 0, 1}}).size(), std::size_t(1));
        QCOMPARE(hitsOf(stairs, {{-0.3, 0.1, -3}, {0, 0, 1}}).size(), std::size_t(1));
        QCOMPARE(hitsOf(stairs, {{-3, 0.1, -0.5}, {1, 0, 0}}).size(), std::size_t(0));
    }
};

QTEST_APPLESS_MAIN(ParametricTest)
#include "parametric_test.moc"

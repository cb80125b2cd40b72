// SPDX-License-Identifier: GPL-3.0-or-later
// What the manual says of single shapes, held against formulas instead of pictures.
#include <cmath>
#include <glm/geometric.hpp>
#include <QTest>

#include "core/virtualight/grids.h"
#include "core/virtualight/primitive_parser.h"
#include "core/virtualight/profile_curve.h"
#include "tests/virtualight/example_texts.h"

using namespace isoscope;
using namespace isoscope::virtualight;

namespace {

/// The t of all places where a ray meets what the text shows.
std::vector<double> hitsOf(const std::string& text, const glm::dvec3& origin, const glm::dvec3& direction) {
    const ParseResult parsed = test::readText(text);
    if (!parsed.ok() || parsed.scene->objects.size() != 1) return {NAN};
    TraceContext context(parsed.scene->parameterTable, RootFinder::certified);
    HitList hits;
    parsed.scene->objects[0].shape->intersect({origin, direction}, {0, 1e9}, context, hits);
    std::vector<double> places;
    for (const Hit& hit : hits) places.push_back(hit.t);
    return places;
}

bool inside(const std::string& text, const glm::dvec3& point) {
    const ParseResult parsed = test::readText(text);
    TraceContext context(parsed.scene->parameterTable, RootFinder::certified);
    return parsed.scene->objects.size() == 1 && parsed.scene->objects[0].shape->contains(point, context);
}

bool same(const std::vector<double>& found, const std::vector<double>& wanted, double tolerance = 1e-9) {
    if (found.size() != wanted.size()) return false;
    for (std::size_t k = 0; k < found.size(); ++k)
        if (!(std::abs(found[k] - wanted[k]) <= tolerance)) return false;
    return true;
}

}  // namespace

class ShapesTest : public QObject {
    Q_OBJECT

  private slots:
    void basisMatricesAddUpToOne_CONF_59() {
        for (int basis = 1; basis <= 4; ++basis) {
            BicubicShape patch;
            patch.basis = basis;
            patch.uSteps = patch.vSteps = 7;
            // Hermite's last two rows and columns are slopes, not places.
            patch.points.fill({1, 2, 3});
            if (basis == 4)
                for (int row = 0; row < 4; ++row)
                    for (int column = 0; column < 4; ++column)
                        if (row > 1 || column > 1)
                            patch.points[static_cast<std::size_t>(4 * row + column)] = glm::dvec3(0);
            const auto grid = gridOf(patch, {});
            for (const glm::dvec3& point : grid->points)
                QVERIFY2(
                    glm::distance(point, glm::dvec3(1, 2, 3)) < 1e-13,
                    qPrintable(
                        QString("basis %1: %2 %3 %4").arg(basis).arg(point.x).arg(point.y).arg(point.z)));
        }
    }

    /// The corner of a B-spline is (1 4 1)/6 of its neighbours, that of Catmull-Rom the second point,
    /// Bezier's the first.
    void cornersOfTheBases_VL_BICUBIC() {
        BicubicShape patch;
        for (int k = 0; k < 16; ++k)
            patch.points[static_cast<std::size_t>(k)] = {k / 4, k % 4,
                                                         (k / 4) * (k % 4) + 0.1 * (k % 4) * (k % 4)};
        const auto corner = [&](int basis) {
            patch.basis = basis;
            return gridOf(patch, {})->points.front();
        };
        QVERIFY(glm::distance(corner(1), patch.points[0]) < 1e-14);
        QVERIFY(glm::distance(corner(3), patch.points[5]) < 1e-14);
        glm::dvec3 blended(0);
        const double weights[] = {1. / 6, 4. / 6, 1. / 6};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                blended +=
                    weights[row] * weights[column] * patch.points[static_cast<std::size_t>(4 * row + column)];
        QVERIFY(glm::distance(corner(2), blended) < 1e-14);
        patch.basis = 1;
        QCOMPARE(gridOf(patch, {})->points.back(), patch.points[15]);
    }

    void bezierPointsMakeTheSamePatch_CONF_76() {
        BicubicShape patch;
        for (int k = 0; k < 16; ++k)
            patch.points[static_cast<std::size_t>(k)] = {k / 4 + 0.1 * k, std::sin(k), std::cos(3 * k)};
        patch.uSteps = 5;
        patch.vSteps = 6;
        for (int basis = 1; basis <= 4; ++basis) {
            patch.basis = basis;
            BicubicShape bezier = patch;
            bezier.basis = 1;
            bezier.points = bezierPoints(patch);
            const auto one = gridOf(patch, {}), other = gridOf(bezier, {});
            for (std::size_t i = 0; i < one->points.size(); ++i)
                QVERIFY(glm::distance(one->points[i], other->points[i]) < 1e-12);
        }
    }

    void capsAreNotDrawn_VL_CONE_VL_CYL_VL_PARABOLOID_CONF_67() {
        // Along the axis there is nothing to meet; across it two walls.
        QVERIFY(hitsOf("Shape [ Cylinder((0,0,0), (0,2,0), 1) ]", {0.3, -5, 0.2}, {0, 1, 0}).empty());
        QVERIFY(same(hitsOf("Shape [ Cylinder((0,0,0), (0,2,0), 1) ]", {-5, 1, 0}, {1, 0, 0}), {4, 6}));
        QVERIFY(same(hitsOf("Shape [ Cone((0,0,0), 2, (0,2,0), 1) ]", {0.5, -5, 0}, {0, 1, 0}), {}));
        QVERIFY(same(hitsOf("Shape [ Paraboloid((0,0,0), (0,4,0), 2) ]", {0, 9, 0}, {0, -1, 0}), {9}));
        // q^2 = radius^2 s / H: at a quarter of the height half the radius.
        QVERIFY(same(hitsOf("Shape [ Paraboloid((0,0,0), (0,4,0), 2) ]", {-5, 1, 0}, {1, 0, 0}), {4, 6}));
        QVERIFY(hitsOf("Shape [ Paraboloid((0,0,0), (0,4,0), 2) ]", {-5, 4.1, 0}, {1, 0, 0}).empty());
    }

    void ringAndDisk_VL_RING_VL_DISK() {
        QVERIFY(same(hitsOf("Shape [ Ring((0,1,0), (0,1,0), 2, 1) ]", {1.5, 5, 0}, {0, -1, 0}), {4}));
        QVERIFY(hitsOf("Shape [ Ring((0,1,0), (0,1,0), 2, 1) ]", {0.5, 5, 0}, {0, -1, 0}).empty());
        QVERIFY(same(hitsOf("Shape [ Disk((0,1,0), (0,1,0), 2) ]", {0.5, 5, 0}, {0, -1, 0}), {4}));
    }

    void torusAroundItsAxis_VL_TORUS_CONF_90() {
        QVERIFY(same(hitsOf("Shape [ Torus((0,0,7), (0,0,1), 3, 1) ]", {3, 0, 0}, {0, 0, 1}), {6, 8}));
        // Along a line through the middle the tube is met four times: major 3 to its middle, minor 1.
        QVERIFY(same(hitsOf("Shape [ Torus((0,0,7), (1,0,0), 3, 1) ]", {0, 0, 0}, {0, 0, 1}), {3, 5, 9, 11}));
    }

    void superquadricOfOneIsASphere_VL_SUPERQUADRIC_CONF_60() {
        QVERIFY(same(hitsOf("Shape [ Superquadric(1, 1) ]", {0.6, 0, -5}, {0, 0, 1}), {4.2, 5.8}));
        // |z|^(2/h) with h = 0.5 and w = 1: z^4 = 1 - (x^2 + y^2)^2.
        const double z = std::pow(1 - 0.36 * 0.36, 0.25);
        QVERIFY(same(hitsOf("Shape [ Superquadric(0.5, 1) ]", {0.6, 0, -5}, {0, 0, 1}), {5 - z, 5 + z}));
    }

    void profilesTurnPointsBesideTheCurveIntoParabolas() {
        Profile profile;
        profile.method = ProfileMethod::conditional;
        profile.points = {{{0, 0}, true}, {{2, 0}, false}, {{2, 2}, false}, {{0, 2}, true}, {{-1, 2}, true}};
        const std::vector<ProfileArc> arcs = arcsOf(profile);
        QCOMPARE(arcs.size(), std::size_t(3));
        // Between two points beside it the curve passes halfway.
        QVERIFY(arcs[0].points[2] == glm::dvec2(2, 1) && arcs[1].points[0] == glm::dvec2(2, 1));
        QVERIFY(!arcs[0].straight && !arcs[1].straight && arcs[2].straight);
        QVERIFY(glm::distance(pieceOf(arcs[0]).at(0.5), glm::dvec2(1.5, 0.25)) < 1e-15);
        profile.method = ProfileMethod::polynomial;
        QCOMPARE(arcsOf(profile).size(), std::size_t(3));
        QVERIFY(arcsOf(profile)[2].points[1] == glm::dvec2(0, 2));
        profile.method = ProfileMethod::straight;
        QCOMPARE(arcsOf(profile).size(), std::size_t(4));
    }

    void profilePointsSayOnOrOff_VL_SOR_CONF_58() {
        const auto text = [](const std::string& point) {
            return "Shape [ SurfaceOfRevolution(CONDITIONAL, 3, (0,1,0), {0,0}, " + point + ", {0,2}) ]";
        };
        // On the curve it is a corner of radius 2; off it the parabola reaches half of that.
        for (const char* point : {"{1 : 2,1}", "{ON : 2,1}", "{2,1}"})
            QVERIFY(inside(text(point), {1.99, 1, 0}) && !inside(text(point), {2.01, 1, 0}));
        for (const char* point : {"{0 : 2,1}", "{OFF : 2,1}"}) {
            QVERIFY(same(hitsOf(text(point), {-9, 1, 0}, {1, 0, 0}), {8, 10}, 1e-6));
            QVERIFY(inside(text(point), {0.99, 1, 0}) && !inside(text(point), {1.01, 1, 0}));
        }
    }

    void extrusionGoesAlongItsDirection_VL_EXTRUDE_CONF_65() {
        const std::string box =
            "Shape [ ExtrudedSurface(STRAIGHT, 5, (0,0,2), {0,0},{1,0},{1,1},{0,1},{0,0}) ]";
        QVERIFY(inside(box, {0.5, 0.5, 1}) && !inside(box, {0.5, 0.5, 2.1}) && !inside(box, {0.5, 1.1, 1}));
        // Closed profiles are closed at their ends too.
        QVERIFY(same(hitsOf(box, {0.5, 0.5, -5}, {0, 0, 1}), {5, 7}));
        // Not closed by itself: from below nothing is met, from the side one wall.
        const std::string strip = "Shape [ ExtrudedSurface(STRAIGHT, 2, (0,3,0), {0,0},{1,0}) ]";
        QCOMPARE(hitsOf(strip, {0.5, 1, -5}, {0, 0, 1}).size(), std::size_t(1));
        QVERIFY(hitsOf(strip, {0.5, 3.1, -5}, {0, 0, 1}).empty());
    }

    void heightFieldsFollowTheirFunction_VL_HF_VL_IMPLPLANARHF_VL_IMPLSPHHF_CONF_66() {
        const std::string plane = "Shape [ ImplicitPlanarHeightField(-1, 3, 0, 2, x + 10*z, 8, 8) ]";
        QVERIFY(same(hitsOf(plane, {2.2, 100, 1.3}, {0, -1, 0}), {100 - 15.2}));
        QVERIFY(hitsOf(plane, {3.1, 100, 1}, {0, -1, 0}).empty());
        const std::string ball = "Shape [ ImplicitSphericalHeightField(2, 0.5, 3, 64, 32, SmoothNormal) ]";
        QVERIFY(same(hitsOf(ball, {0.01, 10, 0.013}, {0, -1, 0}), {6.5, 13.5}, 1e-3));
        // u and v, theta and phi are the same angles.
        const auto with = [](const char* f) {
            return hitsOf(std::string("Shape [ ImplicitSphericalHeightField(2, 1, ") + f + ", 64, 32) ]",
                          {0.3, 0.7, 10}, {0, 0, -1});
        };
        QCOMPARE(with("0.2*cos(3*u)*sin(v)"), with("0.2*cos(3*theta)*sin(phi)"));
        QCOMPARE(with("0.2*cos(3*u)*sin(v)").size(), std::size_t(2));
        // The function sees the point of the sphere as Po.
        QVERIFY(same(hitsOf("Shape [ ImplicitSphericalHeightField(2, 1, Po.y/4, 64, 32) ]", {0.01, 10, 0.013},
                            {0, -1, 0}),
                     {7.5, 11.5}, 1e-3));
    }

    void fieldsOfImagesUseRawValues_VL_PLANARHF_CONF_80() {
        const ParseResult parsed = test::readExample("planar_height_field.vl");
        QVERIFY(parsed.ok());
        const Bounds bounds = parsed.scene->objects[0].shape->bounds();
        QVERIFY(bounds.low.x == 0 && std::abs(bounds.high.x - 10) < 1e-12 &&
                std::abs(bounds.high.z - 10) < 1e-12);
        // 40 to 240 of 255, times 0.0075.
        QVERIFY(bounds.low.y > 0.2 && bounds.high.y < 255 * 0.0075 && bounds.high.y > 1.2);
    }

    /// Of the heights of an image the text's scale makes distances from the center.
    void fieldsAroundSpheres_VL_SPHERICALHF() {
        const ParseResult parsed = test::readExample("spherical_height_field.vl");
        QVERIFY(parsed.ok());
        const Bounds bounds = parsed.scene->objects[0].shape->bounds();
        const double across = bounds.high.y - bounds.low.y;
        QVERIFY(std::isfinite(across) && across > 0);
        TraceContext context(parsed.scene->parameterTable, RootFinder::certified);
        const glm::dvec3 middle = (bounds.low + bounds.high) / 2.0;
        for (const glm::dvec3& direction : {glm::dvec3(1, 0.3, 0.2), glm::dvec3(-0.4, -1, 0.1)}) {
            HitList hits;
            parsed.scene->objects[0].shape->intersect({middle, direction}, {0, 1e9}, context, hits);
            QCOMPARE(hits.size() % 2, std::size_t(1));
        }
    }

    void boxLiesBetweenItsCorners_VL_BOX() {
        const char* box = "Shape [ Box((-1,-2,-3), (1,2,4)) ]";
        QVERIFY(same(hitsOf(box, {0, 0, -10}, {0, 0, 1}), {7, 14}));
        QVERIFY(same(hitsOf(box, {0, -10, 0}, {0, 1, 0}), {8, 12}));
        QVERIFY(inside(box, {0.9, 1.9, 3.9}) && !inside(box, {1.1, 0, 0}));
        QVERIFY(same(hitsOf("Shape [ Box((-1,-2,-3), (1,2,4)) Translate(1,0,0) ]", {-10, 0, 0}, {1, 0, 0}),
                     {10, 12}));
    }

    void implicitSurfacesEndAtTheirBound_VL_IMPLICIT() {
        const auto text = [](const char* bound) {
            return "Shape [ ImplicitSurface(x^2 + y^2 + z^2 - 1) Bound(" + std::string(bound) + ") ]";
        };
        QVERIFY(same(hitsOf(text("(-2,-2,-2), (2,2,2)"), {0, 0, -5}, {0, 0, 1}), {4, 6}, 1e-6));
        // In a Solid, its far side counts too.
        QVERIFY(same(hitsOf("Declare A = " + text("(-2,-2,-2), (2,2,2)") +
                                " Solid [ A - Shape [ Box((-2,-2,-2), (2,2,0)) ] ]",
                            {0, 0, -5}, {0, 0, 1}),
                     {5, 6}, 1e-6));
        const std::vector<double> cut = hitsOf(text("(-2,-2,-0.5), (2,2,2)"), {0, 0, -5}, {0, 0, 1});
        QVERIFY(!cut.empty() && cut.front() >= 4.5 - 1e-9 && std::abs(cut.back() - 6) < 1e-6);
        QVERIFY(!test::readText("Shape [ ImplicitSurface(x^2 - 1) ]").diagnostics.empty());
    }

    void nurbsPassThroughTheirCorners_VL_NURBS() {
        // Orders 2 and uniform knots make a bilinear patch; here a square at z = 1.
        const char* square =
            "Shape [ NURBS(2, 2, [0, 0, 1, 1], 2, 2, [0, 0, 1, 1], [[(-1,-1,1), (-1,1,1)], [(1,-1,1), "
            "(1,1,1)]]) "
            "]";
        QVERIFY(same(hitsOf(square, {0.913, 0.827, -2}, {0, 0, 1}), {3}, 1e-9));
        QVERIFY(hitsOf(square, {1.1, 0, -2}, {0, 0, 1}).empty());
    }

    void patchesBlendTheirNormals_VL_TRIPATCH() {
        const ParseResult parsed =
            test::readText("Shape [ TriangularPatch((0,0,0), (0,0,2), (1,0,0), (1,0,0), (0,1,0), (0,1,0)) ]");
        QVERIFY(parsed.ok());
        TraceContext context;
        HitList hits;
        parsed.scene->objects[0].shape->intersect({{0.25, 0.25, -1}, {0, 0, 1}}, {}, context, hits);
        QCOMPARE(hits.size(), std::size_t(1));
        QCOMPARE(hits[0].t, 1.0);
        QVERIFY(glm::distance(glm::abs(hits[0].normal), glm::normalize(glm::dvec3(0.25, 0.25, 0.5))) < 1e-9);
    }

    /// The manual's sections 3.8.1 to 3.8.23 are in the order of the alphabet; it refers to three of them by
    /// numbers that are one too low.
    void sectionsOfTheManual_CONF_56_CONF_57() {
        const std::vector<std::string> names{"BicubicPatch",
                                             "Blobby",
                                             "Box",
                                             "Cone",
                                             "Cylinder",
                                             "Disk",
                                             "ExtrudedSurface",
                                             "ImplicitPlanarHeightField",
                                             "ImplicitSphericalHeightField",
                                             "ImplicitSurface",
                                             "NURBS",
                                             "Paraboloid",
                                             "ParametricSurface",
                                             "PlanarHeightField",
                                             "Polygon",
                                             "PolynomialSurface",
                                             "Ring",
                                             "Sphere",
                                             "SphericalHeightField",
                                             "Superquadric",
                                             "SurfaceOfRevolution",
                                             "Torus",
                                             "TriangularPatch"};
        QCOMPARE(names.size(), std::size_t(23));
        for (const std::string& name : names) QVERIFY2(PrimitiveParser::isPrimitive(name), name.c_str());
        QCOMPARE(names[8 - 1], std::string("ImplicitPlanarHeightField"));
        QCOMPARE(names[9 - 1], std::string("ImplicitSphericalHeightField"));
        QCOMPARE(names[14 - 1], std::string("PlanarHeightField"));
    }

    /// The manual's z has sin(2v) under the fraction where Boy's surface has sin(3v). The example keeps to
    /// the manual; with sin(3v) the cross-cap closes: u = pi/2 is one point.
    void boysSurfaceAsPrintedAndAsKnown_CONF_62() {
        const auto height = [](double u, double v, double turns) {
            return std::sqrt(2.0) * std::cos(u) * std::cos(u) /
                   (std::sqrt(2.0) - std::sin(2 * u) * std::sin(turns * v));
        };
        const ParseResult parsed = test::readExample("parametric_surface.vl");
        QVERIFY(parsed.ok());
        const Bounds printed = parsed.scene->objects[0].shape->bounds();
        double highest = 0, highestKnown = 0;
        for (int i = -200; i <= 200; ++i)
            for (int k = -200; k <= 200; ++k) {
                const double u = i * std::acos(0) / 200, v = k * std::acos(0) / 200;
                highest = std::max(highest, height(u, v, 2));
                highestKnown = std::max(highestKnown, height(u, v, 3));
            }
        QVERIFY(std::abs(printed.high.z - highest) < 0.05 * highest);
        QVERIFY(highestKnown > 0);
    }

    void parametricSurfaceKeepsToItsDomain_VL_PARAMETRIC_CONF_61() {
        const std::string quarter =
            "Declare s = cos(u)\nShape [ ParametricSurface(s, sin(u), v) RenderBound(0, PI_TWO, 0, 3) "
            "ShapeSubdivision(200) ]";
        QVERIFY(same(hitsOf(quarter, {5, 0.5, 1}, {-1, 0, 0}), {5 - std::sqrt(0.75)}, 1e-4));
        QVERIFY(hitsOf(quarter, {5, 0.5, 3.1}, {-1, 0, 0}).empty());
        QVERIFY(hitsOf(quarter, {-5, -0.5, 1}, {1, 0, 0}).empty());
    }

    void blobbyFieldsAddUp_VL_BLOBBY_CONF_73() {
        // Two of strength 1/2 at the same place are one of strength 1.
        const auto at = [](const char* parts) {
            return hitsOf(std::string("Shape [ Blobby(0.25, ") + parts + ") ]", {0, 0, -5}, {0, 0, 1});
        };
        const double reach = std::sqrt(0.5);
        const std::vector<double> wanted{5 - reach, 5 + reach};
        QVERIFY(same(at("Sphere((0,0,0), 1, 0.5), Sphere((0,0,0), 1, 0.5)"), wanted));
        QVERIFY(same(at("Sphere((0,0,0), 1, 1), Sphere((9,0,0), 1, -1)"), wanted));
        QVERIFY(same(at("Plane((0,0,2), 0, 1, 1), Sphere((9,0,0), 1, -1)"), wanted));
        QVERIFY(same(at("Cylinder((-3,0,0), (3,0,0), 1, 1), Sphere((9,0,0), 1, 1)"), wanted));
    }

    /// The same hits whichever solver the text names, and none.
    void solversAgree_VL_SOLVER_VL_POLY_CONF_63_data() {
        QTest::addColumn<QString>("primitive");
        QTest::newRow("torus") << "Torus((0,0,7), (1,1,0), 3, 1)";
        QTest::newRow("blobby") << "Blobby(0.3, Sphere((0,0,5), 2, 1), Sphere((1,0,6), 2, 1))";
        QTest::newRow("revolved")
            << "SurfaceOfRevolution(POLYNOMIAL, 5, (0,1,0), {0,-2},{2,-1},{0.5,0},{2,1},{0,2})";
        QTest::newRow("quartic") << "PolynomialSurface(x^4 + y^4 + z^4 - 5*(x^2 + y^2 + z^2) + 10)";
        QTest::newRow("sextic") << "PolynomialSurface(x^6 + y^6 + z^6 - 40)";
    }
    void solversAgree_VL_SOLVER_VL_POLY_CONF_63() {
        QFETCH(QString, primitive);
        const auto shape = [&](const char* solver) {
            return "Shape [ " + primitive.toStdString() + " " + solver + " ]";
        };
        int met = 0;
        for (int k = 0; k < 40; ++k) {
            const glm::dvec3 origin(-3 + 0.151 * k, 2 - 0.0971 * k, -20), direction(0.013, 0.021, 1);
            const std::vector<double> wanted = hitsOf(shape(""), origin, direction);
            met += static_cast<int>(wanted.size());
            for (const char* solver : {"FerrariSolver", "VietaSolver", "SturmSolver"})
                QVERIFY2(same(hitsOf(shape(solver), origin, direction), wanted, 1e-7), solver);
        }
        QVERIFY(met > 20);
    }
};

QTEST_GUILESS_MAIN(ShapesTest)
#include "shapes_test.moc"

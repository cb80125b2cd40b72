// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/isosurface_mesh.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <QTest>
#include <random>

#include "core/mesh/contour/polygon_mesh.h"
#include "core/mesh/files/mesh_file.h"
#include "tests/support/mesh_case.h"
#include "tests/support/mesh_checker.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const std::string box2 = "box { -2, 2 }";

/// The distance to a torus around the y axis, with radii 1 and 0.4.
double torusDistance(const glm::dvec3& p) {
    return std::abs(std::hypot(std::hypot(p.x, p.z) - 1, p.y) - 0.4);
}

double nearestCorner(const TriangleMesh& mesh, const glm::dvec3& corner) {
    double least = HUGE_VAL;
    for (const glm::dvec3& p : mesh.points) least = std::min(least, glm::distance(p, corner));
    return least;
}

}  // namespace

class IsosurfaceMeshTest : public QObject {
    Q_OBJECT

  private slots:
    void genusIsThatOfTheSurface_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("tolerance");
        QTest::addColumn<int>("pieces");
        QTest::addColumn<int>("genus");
        const auto row = [](const char* name, const std::string& text, double tolerance, int pieces,
                            int genus) {
            QTest::newRow(name) << QString::fromStdString(text) << tolerance << pieces << genus;
        };
        row("sphere", statement("x*x + y*y + z*z - 1", box2), 0.02, 1, 0);
        row("two spheres", statement("min(f_sphere(x-1,y,z,0.7), f_sphere(x+1,y,z,0.7))", box2), 0.02, 2, 0);
        row("shell", statement("abs(f_sphere(x,y,z,1)) - 0.2", box2), 0.02, 2, 0);
        row("torus", statement("f_torus(x, y, z, 1, 0.4)", box2), 0.02, 1, 1);
        row("linked tori",
            statement("min(f_torus(x,y,z,1,0.25), sqrt(pow(sqrt(pow(x-1,2)+y*y)-1,2)+z*z)-0.25)",
                      "box { -2.5, 2.5 }"),
            0.02, 2, 2);
        row("double torus", statement("pow(x*pow(x-1,2)*(x-2)+y*y,2) + z*z - 0.01", "box { -1, 3 }"), 0.02, 1,
            2);
        row("gyroid in a box", statement("sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)", "box { -6, 6 }"),
            0.1, 1, 27);
        row("frame of a cube",
            statement("max(max(abs(x),max(abs(y),abs(z)))-1, 0.6-min(max(abs(x),abs(y)),min(max(abs(y),abs(z)"
                      "),max(abs(z),abs(x)))))",
                      box2),
            0.02, 1, 5);
        row("lens cut by a sphere", statement("f_sphere(x-1,y,z,1)", "sphere { 0, 1 }"), 0.02, 1, 0);
    }
    void genusIsThatOfTheSurface() {
        QFETCH(QString, text);
        QFETCH(double, tolerance);
        QFETCH(int, pieces);
        QFETCH(int, genus);
        const SceneMesh made = meshOf(text.toStdString(), tolerance);
        QCOMPARE(made.problem, std::string());
        const CheckedMesh checked = checkMesh(made.mesh);
        QCOMPARE(checked.fault, std::string());
        QCOMPARE(static_cast<int>(checked.pieces), pieces);
        QCOMPARE(static_cast<int>(checked.genus()), genus);
        QVERIFY(made.report.form.watertight() && made.report.form.manifold());
        QCOMPARE(made.report.form.euler(), checked.euler());
        QCOMPARE(made.report.form.genus(), checked.genus());
        QCOMPARE(made.report.form.pieces, checked.pieces);
        QVERIFY(made.report.keepsTolerance());
        QVERIFY(enclosedVolume(made.mesh) > 0);
    }

    /// Samples of the mesh by the known distance, and samples of the surface by that to all triangles.
    void aTorusIsWithinTheTolerance() {
        constexpr unsigned seed = 22;
        qInfo("seed %u", seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0, 1);
        for (const double tolerance : {0.05, 0.01}) {
            const SceneMesh made = meshOf(statement("f_torus(x, y, z, 1, 0.4)", box2), tolerance);
            QCOMPARE(made.problem, std::string());
            double most = 0;
            for (const Triangle& t : made.mesh.triangles) {
                const double u = std::sqrt(share(random)), v = share(random);
                most = std::max(most, torusDistance((1 - u) * made.mesh.points[t[0]] +
                                                    u * (1 - v) * made.mesh.points[t[1]] +
                                                    u * v * made.mesh.points[t[2]]));
            }
            for (int i = 0; i < 200; ++i) {
                const double a = 2 * std::numbers::pi * share(random),
                             b = 2 * std::numbers::pi * share(random);
                const double r = 1 + 0.4 * std::cos(b);
                const glm::dvec3 place(r * std::cos(a), 0.4 * std::sin(b), r * std::sin(a));
                double least = HUGE_VAL;
                for (const Triangle& t : made.mesh.triangles)
                    least =
                        std::min(least, distanceToTriangle(place, made.mesh.points[t[0]],
                                                           made.mesh.points[t[1]], made.mesh.points[t[2]]));
                most = std::max(most, least);
            }
            qInfo("tolerance %g: %zu triangles, %.5f off, %.5f told", tolerance, made.mesh.triangles.size(),
                  most, made.report.distance);
            QVERIFY(most <= tolerance);
            QVERIFY(made.report.distance <= tolerance);
        }
    }

    void sharpEdgesAreKept() {
        // A cube turned out of the lattice.
        const SceneMesh made = meshOf(
            statement("max(abs(x*0.8+z*0.6), max(abs(y), abs(z*0.8-x*0.6))) - 1", "sphere { 0, 3 }"), 0.01);
        QCOMPARE(made.problem, std::string());
        QCOMPARE(checkMesh(made.mesh).fault, std::string());
        // A corner whose leaf has no crossing on one of its faces is found to the tolerance, the others as
        // they are.
        int exact = 0;
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0})
                for (const double c : {-1.0, 1.0}) {
                    const double off = nearestCorner(made.mesh, {0.8 * a - 0.6 * c, b, 0.6 * a + 0.8 * c});
                    QVERIFY(off < 0.01);
                    exact += off < 1e-4 ? 1 : 0;
                }
        qInfo("%d corners exact, volume %.6f", exact, enclosedVolume(made.mesh));
        QVERIFY(exact >= 4);
        QVERIFY(std::abs(enclosedVolume(made.mesh) - 8) < 1e-3);
        // Faces keep their normals up to the edge.
        for (const glm::dvec3& n : made.mesh.normals) {
            const glm::dvec3 own(n.x * 0.8 + n.z * 0.6, n.y, n.z * 0.8 - n.x * 0.6);
            QVERIFY(std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)}) > 0.999);
        }
    }

    void theContainerClosesTheMesh() {
        const SceneMesh half = meshOf(statement("y", "box { <-1,-1,-2>, <1,3,2> }"), 0.02);
        QCOMPARE(half.problem, std::string());
        QCOMPARE(checkMesh(half.mesh).fault, std::string());
        QVERIFY(std::abs(enclosedVolume(half.mesh) - 8) < 1e-3);
        QVERIFY(half.report.wallTriangles > 0);
        for (const double x : {-1.0, 1.0})
            for (const double z : {-2.0, 2.0})
                for (const double y : {-1.0, 0.0}) QVERIFY(nearestCorner(half.mesh, {x, y, z}) < 1e-4);
        const SceneMesh ball = meshOf(statement("-1", "sphere { <1,2,3>, 0.5 }"), 0.01);
        QCOMPARE(checkMesh(ball.mesh).fault, std::string());
        for (const glm::dvec3& p : ball.mesh.points)
            QVERIFY(std::abs(glm::distance(p, glm::dvec3(1, 2, 3)) - 0.5) < 0.01);
    }

    void anOpenIsosurfaceEndsAtTheContainer() {
        const SceneMesh tube = meshOf(statement("x*x + z*z - 0.25", "box { -1, 1 }", "open"), 0.02);
        QCOMPARE(tube.problem, std::string());
        const CheckedMesh checked = checkMesh(tube.mesh, true);
        QCOMPARE(checked.fault, std::string());
        QCOMPARE(checked.euler(), 0l);
        QCOMPARE(tube.report.form.borders, std::size_t(2));
        QCOMPARE(tube.report.form.genus(), 0l);
        QVERIFY(!tube.report.form.watertight() && tube.report.form.manifold());
        double low = 0, high = 0;
        for (const glm::dvec3& p : tube.mesh.points) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
            QVERIFY(std::abs(std::hypot(p.x, p.z) - 0.5) < 0.02);
        }
        QVERIFY(std::abs(low + 1) < 0.02 && std::abs(high - 1) < 0.02);
    }

    void jumpsAndNoiseDoNotTearIt() {
        for (const char* function :
             {"f_noise3d(25*x, 25*y, 25*z) - 0.5", "floor(3*x) + floor(3*y) + floor(3*z)",
              "select(mod(abs(floor(4*x)+floor(4*y)+floor(4*z)),2)-0.5, -1, 1)", "sqrt(x) - y", "x/y - 1",
              "sin(40*x*y*z)"}) {
            const SceneMesh made = meshOf(statement(function, "box { -1, 1 }"), 0.1);
            QCOMPARE(made.problem, std::string());
            const CheckedMesh checked = checkMesh(made.mesh);
            QVERIFY2(checked.fault.empty(), (std::string(function) + ": " + checked.fault).c_str());
            QVERIFY2(made.report.keepsTolerance(), function);
        }
    }

    /// As in pictures: rays pass through what has no value.
    void whereThereIsNoValueThereIsNoSolid() {
        const SceneMesh half =
            meshOf(statement("x*x + y*y + z*z - 1 + 0.5*sqrt(x)", "box { -1.2, 1.2 }"), 0.03);
        QCOMPARE(checkMesh(half.mesh).fault, std::string());
        QCOMPARE(half.report.form.pieces, std::size_t(1));
        QVERIFY(std::abs(enclosedVolume(half.mesh) - 1.24) < 0.03);
        for (const glm::dvec3& p : half.mesh.points) QVERIFY(p.x > -0.031);
    }

    /// 0/0 in a plane of the lattice is neither a hole of the ball nor something beside it.
    void singlePointsWithoutAValueTakeTheOneBeside() {
        const SceneMesh ball = meshOf(statement("(x*x + y*y + z*z - 0.5)*sin(x)/x", "box { -1, 1 }"), 0.02);
        const CheckedMesh checked = checkMesh(ball.mesh);
        QCOMPARE(checked.fault, std::string());
        QCOMPARE(checked.euler(), 2l);
        QVERIFY(std::abs(enclosedVolume(ball.mesh) - 4.0 / 3 * std::numbers::pi * std::pow(0.5, 1.5)) < 0.02);
    }

    /// Along the joints of bricks each leaf that is split leaves its neighbour too coarse.
    void leavesAreSplitAlongAJointToItsEnd() {
        const SceneMesh made =
            meshOf(statement("-f_brick(x, y, z)", "sphere { 0, 5 }", "threshold -0.5"), 0.04);
        QCOMPARE(checkMesh(made.mesh).fault, std::string());
        QVERIFY2(made.report.keepsTolerance(), qPrintable(QString::number(made.report.distance)));
    }

    /// Filaments of the Mandelbrot set enter one coarse leaf after the other, more than a hundred of them.
    void itGoesOnUntilAllIsWithinTheTolerance() {
        const SceneMesh made =
            meshOf(statement("-f_mandel(x, y, z)", "sphere { 0, 2 }", "threshold -0.5"), 0.02);
        QCOMPARE(made.problem, std::string());
        QVERIFY(!made.report.limited);
        QVERIFY2(made.report.keepsTolerance(), qPrintable(QString::number(made.report.distance)));
    }

    void theSameBytesForAnyNumberOfThreads() {
        const std::string text = statement("f_noise3d(4*x, 4*y, 4*z) - 0.5 + 0.2*max(x, y)",
                                           "sphere { 0, 1 }", "pigment { bozo scale 0.3 }");
        const SceneMesh one = meshOf(text, 0.02, 1), four = meshOf(text, 0.02, 4);
        QVERIFY(!one.mesh.colors.empty());
        for (const MeshFormat format : {MeshFormat::ply, MeshFormat::obj, MeshFormat::gltf})
            QVERIFY(meshFile(one.mesh, format).content == meshFile(four.mesh, format).content);
    }

    void transformsAndMirrorsKeepTheOutside() {
        const SceneMesh made = meshOf(
            statement("f_sphere(x, y, z, 1)", box2, "scale <-1, 2, 3> rotate 30*y translate 5*x"), 0.02);
        QCOMPARE(made.problem, std::string());
        QCOMPARE(checkMesh(made.mesh).fault, std::string());
        QVERIFY(std::abs(enclosedVolume(made.mesh) / (8 * std::numbers::pi) - 1) < 0.01);
        QVERIFY(made.report.tolerance <= 0.0201);
        for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t)
            QVERIFY(glm::dot(made.mesh.normals[made.mesh.cornerNormals[t][0]],
                             made.mesh.points[made.mesh.triangles[t][0]] - glm::dvec3(5, 0, 0)) > 0);
    }

    void pointsHaveTheColoursOfTheTexture() {
        const SceneMesh made =
            meshOf("global_settings { assumed_gamma 1 }" +
                       statement("f_sphere(x, y, z, 1)", box2,
                                 "pigment { gradient x color_map { [0.5 rgb x] [0.5 rgb z] } scale 4 "
                                 "translate -2*x }"),
                   0.02);
        QCOMPARE(made.mesh.colors.size(), made.mesh.points.size());
        for (std::size_t i = 0; i < made.mesh.points.size(); ++i)
            if (std::abs(made.mesh.points[i].x) > 0.01)
                QCOMPARE(made.mesh.colors[i], made.mesh.points[i].x < 0 ? 0xffff0000u : 0xff0000ffu);
        const SceneMesh plain =
            meshOf(statement("f_sphere(x,y,z,1)", box2, "pigment { srgb <1,0.5,0> }"), 0.1);
        QCOMPARE(plain.mesh.colors.front(), 0xffff8000u);
    }

    // A ball that reached through the face of a coarser leaf, but not to its corners, came to two pieces.
    void aBulgeThroughACoarserFaceIsNoPieceOfItsOwn() {
        const SceneMesh made = meshOf(R"(
isosurface {
  function {
    min(10
      #declare I = 0;
      #while (I < 64)
        #declare A = I*2.39996;
        #declare H = 1 - 2*(I + 0.5)/64;
        #declare R = 1.6*sqrt(1 - H*H);
        , f_sphere(x - R*cos(A), y - 1.6*H, z - R*sin(A), 0.22)
        #declare I = I + 1;
      #end
    )
  }
  contained_by { sphere { 0, 2 } }
})",
                                      0.008);
        QCOMPARE(made.problem, std::string());
        const CheckedMesh checked = checkMesh(made.mesh);
        QCOMPARE(checked.fault, std::string());
        QCOMPARE(checked.pieces, std::size_t(64));
        QCOMPARE(checked.genus(), 0L);
    }

    void aStopEndsIt() {
        const ParseResult parsed = parseScene(statement("sin(9*x)*sin(9*y)*sin(9*z)", box2));
        std::stop_source source;
        SceneMeshSettings settings;
        settings.tolerance = 1e-3;
        double last = -1;
        bool grows = true;
        const SceneMesh made = meshScene(
            *parsed.scene, placedIsosurfaces(*parsed.scene), settings,
            [&](double done) {
                grows = grows && done >= last && done <= 1;
                last = done;
                source.request_stop();
            },
            source.get_token());
        QCOMPARE(made.problem, std::string("stopped"));
        QVERIFY(made.mesh.triangles.empty() && grows && last >= 0);
    }

    void aLimitIsToldAndTheMeshStaysWhole() {
        const ParseResult parsed = parseScene(statement("sin(9*x)*sin(9*y)*sin(9*z) + 0.1", box2));
        SceneMeshSettings settings;
        settings.tolerance = 1e-3;
        settings.cellLimit = 60'000;
        const SceneMesh made = meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
        QCOMPARE(made.problem, std::string());
        QVERIFY(made.report.limited && made.report.cells <= settings.cellLimit);
        QCOMPARE(checkMesh(made.mesh).fault, std::string());
    }

    /// Both limits keep the mesh whole; where not even the coarsest one would do there is none.
    void aLimitOfMemoryIsTold() {
        const ParseResult parsed = parseScene(statement("sin(9*x)*sin(9*y)*sin(9*z) + 0.1", box2));
        SceneMeshSettings settings;
        settings.tolerance = 1e-3;
        settings.memory = 200'000'000;
        const SceneMesh made = meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
        QCOMPARE(made.problem, std::string());
        QVERIFY(made.report.limited);
        QCOMPARE(checkMesh(made.mesh).fault, std::string());
        // What is made of the mesh counts, too.
        settings.bytesOfTriangle = 1000;
        const SceneMesh smaller = meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
        QCOMPARE(smaller.problem, std::string());
        QVERIFY(smaller.report.form.triangles < made.report.form.triangles);
        settings.memory = 1000;
        const SceneMesh none = meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
        QVERIFY2(none.problem.find("more than 0 MB of memory") != std::string::npos, none.problem.c_str());
        // It was said that there is no surface.
        settings = {};
        settings.cellLimit = 100;
        const SceneMesh few = meshScene(*parsed.scene, placedIsosurfaces(*parsed.scene), settings);
        QVERIFY2(few.problem.find("too few boxes") != std::string::npos, few.problem.c_str());
    }

    void whatCannotBeMeshedIsNamed() {
        QVERIFY(meshOf(statement("x", "box { <0,0,0>, <1,1,0> }"), 0.1).problem.find("volume") !=
                std::string::npos);
        QVERIFY(meshOf(statement("x", "box { -1, 1 }"), 1e-9).problem.find("tolerance") != std::string::npos);
        QVERIFY(meshOf(statement("1", "box { -1, 1 }"), 0.1).problem.find("no surface") != std::string::npos);
        QVERIFY(meshOf("sphere { 0, 1 }", 0.1).problem.find("no isosurface") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(IsosurfaceMeshTest)
#include "isosurface_mesh_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes for POV-Ray written in VirtuaLight's notation: read again they are met by the same rays at the same
// places.
#include <QTest>

#include "core/exchange/virtualight_writer.h"
#include "core/virtualight/scene_reader.h"

using namespace isoscope;

namespace {

std::string problems(const ParseResult& parsed) {
    std::string text;
    for (const Diagnostic& diagnostic : parsed.diagnostics)
        if (diagnostic.severity == Severity::error) text += toString(diagnostic, *parsed.sources) + "\n";
    return text;
}

/// Where a ray meets the objects of a scene first; infinity where it meets none.
double nearest(const Scene& scene, const Ray& ray) {
    TraceContext context(scene.parameterTable, RootFinder::certified);
    double best = INFINITY;
    for (const SceneObject& object : scene.objects) {
        HitList hits;
        object.shape->intersect(ray, {0, 1e6}, context, hits);
        for (const Hit& hit : hits) best = std::min(best, hit.t);
    }
    return best;
}

}  // namespace

class VirtualightWriterTest : public QObject {
    Q_OBJECT

  private slots:
    void raysMeetTheSamePlaces_data() {
        QTest::addColumn<QString>("object");
        const auto add = [](const char* name, const char* object) { QTest::newRow(name) << QString(object); };
        add("sphere", "sphere { <0.2, 0, 0.1>, 1.1 }");
        add("ellipsoid", "sphere { 0, 1 scale <1, 0.5, 1.5> rotate <20, -30, 40> translate <0.2, 0.1, 0> }");
        add("mirrored", "box { <0, -0.5, -0.3>, <1.2, 1, 0.4> scale <-1, 1, 1> rotate <0, 90, 30> }");
        add("upside_down", "box { <0, -0.5, -0.3>, <1.2, 1, 0.4> rotate <10, -90, 0> }");
        add("box", "box { <-1, -0.5, -0.3>, <0.7, 1, 0.4> rotate 30*z }");
        add("cone", "cone { <0, -1, 0>, 1, <0.3, 1, 0.2>, 0.2 }");
        add("cone_open", "cone { <0, -1, 0>, 1, <0.3, 1, 0.2>, 0.2 open }");
        add("cylinder", "cylinder { <-1, 0, 0>, <1, 0.5, 0.3>, 0.5 }");
        add("torus", "torus { 1, 0.35 rotate <-30, 0, 20> }");
        add("disc", "disc { 0, <0.3, 1, -1>, 1.2, 0.4 }");
        add("superellipsoid", "superellipsoid { <0.3, 0.7> rotate <20, 30, 0> }");
        add("plane", "plane { <0.2, 1, -0.3>, -0.4 }");
        add("quadric", "quadric { <1, 0.6, 1>, <0.1, 0, 0.2>, <0, 0.3, 0>, -0.8 }");
        add("quartic",
            "poly { 4, <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.32, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, "
            "1.68, 0, 0, 0, 0, 1, 0, -2.32, 0, 0.7056> }");
        add("blob",
            "blob { threshold 0.6 sphere { <0.75, 0, 0>, 1, 1 } sphere { <-0.375, 0.65, 0>, 1, 1 } "
            "cylinder { <-0.4, -0.6, 0.4>, <0.4, -0.6, -0.6>, 0.7, 1.2 } }");
        add("blob_of_one", "blob { threshold 0.3 sphere { 0, 1, 1 } }");
        add("csg",
            "difference { merge { torus { 0.9, 0.3 } cylinder { -0.9*y, 0.9*y, 0.35 } } "
            "cone { <0, 1.2, 0>, 0.3, 0, 0.1 } box { <0.2, -2, -2>, <2, 2, 0> } rotate <-20, 30, 0> }");
        add("clipped", "sphere { 0, 1 clipped_by { box { <-2, -0.3, -2>, 2 } } }");
        add("inverse", "intersection { sphere { 0, 1.2 } sphere { <0.5, 0.5, -0.5>, 0.8 inverse } }");
        add("isosurface",
            "isosurface { function { x*x + 2*y*y + sin(3*z) } threshold 0.4 max_gradient 8 "
            "contained_by { box { -1, 1 } } rotate 20*y }");
        add("isosurface_open",
            "isosurface { function { abs(x) + y*y - z*z*z } threshold 0.4 max_gradient 8 open "
            "contained_by { sphere { 0, 1.1 } } }");
        add("union", "union { sphere { -0.5*x, 0.5 } sphere { 0.5*x, 0.5 } scale 1.2 }");
    }
    void raysMeetTheSamePlaces() {
        QFETCH(QString, object);
        const ParseResult scene = parseScene("#version 3.7;\n" + object.toStdString());
        QVERIFY2(scene.ok(), problems(scene).c_str());
        const std::string text = virtualightText(*scene.scene);
        QVERIFY2(!QString::fromStdString(text).contains("left out, it has"), text.c_str());
        const ParseResult again = virtualight::parseVirtualight(text);
        QVERIFY2(again.ok(), (problems(again) + text).c_str());
        int met = 0, different = 0;
        for (int k = 0; k < 900; ++k) {
            const Ray ray{{-1.47 + 0.1 * (k % 30), -1.46 + 0.1 * (k / 30), -6}, {0.02, 0.01, 1}};
            const double wanted = nearest(*scene.scene, ray), found = nearest(*again.scene, ray);
            met += std::isfinite(wanted);
            different += !(wanted == found || std::abs(wanted - found) < 1e-5);
        }
        QVERIFY2(met > 60, qPrintable(QString::number(met)));
        // A ray that grazes an edge may see it or not.
        QVERIFY2(different <= 3, qPrintable(QString::number(different)));
    }

    void whatHasNoEquivalentIsNamed() {
        const ParseResult scene = parseScene(
            "sphere_sweep { linear_spline 2, 0, 1, x, 1 }\nsphere { 0, 1 matrix <1, 0.5, 0, 0, 1, 0, 0, 0, "
            "1, 0, 0, 0> }\nsphere { 0, 2 }\n");
        QVERIFY2(scene.ok(), problems(scene).c_str());
        const QString text = QString::fromStdString(virtualightText(*scene.scene));
        QVERIFY2(text.contains("// sphere_sweep: left out") && text.contains("// sphere: left out"),
                 qPrintable(text));
        const ParseResult again = virtualight::parseVirtualight(text.toStdString());
        QVERIFY(again.ok());
        QCOMPARE(again.scene->objects.size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(VirtualightWriterTest)
#include "virtualight_writer_test.moc"

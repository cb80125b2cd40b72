// SPDX-License-Identifier: GPL-3.0-or-later
// Every built-in with its defaults: closed, manifold, and within the tolerance.
#include <map>
#include <QTest>

#include "tests/support/builtin_scene.h"
#include "tests/support/mesh_case.h"
#include "tests/support/mesh_checker.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Of those whose form is known, in their containers.
const std::map<std::string, long> knownGenus{
    {"f_sphere", 0},      {"f_torus", 1},      {"f_torus2", 1},         {"f_ellipsoid", 0},
    {"f_rounded_box", 0}, {"f_glob", 0},       {"f_superellipsoid", 0}, {"f_dupin_cyclid", 1},
    {"f_blob", 0},        {"f_blob2", 0},      {"f_paraboloid", 0},     {"f_heart", 0},
    {"f_bifolia", 1},     {"f_algbr_cyl1", 0}, {"f_hunt_surface", 2},   {"f_quartic_paraboloid", 0}};

}  // namespace

class BuiltinMeshTest : public QObject {
    Q_OBJECT

  private slots:
    void isClosedAndManifold_data() {
        QTest::addColumn<QString>("name");
        for (const Builtin& builtin : builtins())
            if (!builtin.name.empty() && builtin.pointArguments == 3)
                QTest::newRow(builtin.name.c_str()) << QString::fromStdString(builtin.name);
    }

    void isClosedAndManifold() {
        QFETCH(QString, name);
        const ParseResult parsed = parseScene("#version 3.7; #include \"functions.inc\"\n" +
                                              builtinStatement(*findBuiltin(name.toStdString())));
        QVERIFY(parsed.ok());
        const std::vector<PlacedIsosurface> surfaces = placedIsosurfaces(*parsed.scene);
        QCOMPARE(surfaces.size(), std::size_t(1));
        const auto known = knownGenus.find(name.toStdString());
        SceneMeshSettings settings;
        settings.tolerance =
            (known != knownGenus.end() ? 5 : 15) * usualTolerance(surfaces[0].shape->settings().container);
        settings.threads = 2;
        settings.colors = false;
        const SceneMesh made = meshScene(*parsed.scene, surfaces, settings);
        QCOMPARE(made.problem, std::string());
        const CheckedMesh checked = checkMesh(made.mesh);
        QCOMPARE(checked.fault, std::string());
        QVERIFY2(made.report.keepsTolerance(), qPrintable(QString::number(made.report.distance)));
        QVERIFY(enclosedVolume(made.mesh) > 0);
        if (known != knownGenus.end()) QCOMPARE(checked.genus(), known->second);
    }
};

QTEST_APPLESS_MAIN(BuiltinMeshTest)
#include "builtin_mesh_test.moc"

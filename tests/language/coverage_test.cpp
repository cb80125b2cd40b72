// SPDX-License-Identifier: GPL-3.0-or-later
// The checklist of the tutorials (data/spec/coverage_ids.txt, one ID a line): which tests hold which group of
// its rows. The table here is the statement; the test sees to it that every test it names is there, and that
// the golden catalogue has shapes of the group. Prints rows covered / rows.
#include <algorithm>
#include <QFile>
#include <QTest>
#include <map>
#include <string>
#include <vector>

#include "tests/support/csv_table.h"

using namespace isoscope;

namespace {

struct Group {
    const char* rows;    ///< what the IDs begin with
    const char* file;    ///< under tests
    const char* test;    ///< the slot in it
    const char* shapes;  ///< what names of golden/shapes.csv begin with; "" for groups without shapes there
};

constexpr const char* catalogue = "shapes/golden_catalogue_test.cpp";
constexpr const char* isosurfaces = "isosurfacesAgreeWithPovray";
constexpr const char* others = "otherShapesAgreeWithPovray";

const std::vector<Group> groups{
    {"FN-", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"FN-PAT-", "language/function_golden_test.cpp", "patternsAndNamedPatterns", ""},
    {"FCSG-", catalogue, isosurfaces, "iso"},
    {"FCSG-EX-", "language/example_scenes_test.cpp", "scenes", ""},
    {"ISO-", catalogue, isosurfaces, "iso"},
    {"ISO-EX-", "language/example_scenes_test.cpp", "scenes", ""},
    {"XF-", "shapes/transform_test.cpp", "axesTurnAsInPovray", ""},
    {"XF-EX-", "language/example_scenes_test.cpp", "scenes", ""},
    {"INC-", catalogue, others, "mac_"},
    {"INC-ALIGN", "language/golden_macros_test.cpp", "agreeWithPovray", "mac_align"},
    {"INC-CENTER", "language/golden_macros_test.cpp", "agreeWithPovray", "mac_center"},
    {"INC-EXTENTS", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"INC-ISECT", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"INC-TEXT", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"INC-BEVEL", catalogue, others, "mac_bevelled"},
    {"INC-CIRCLETEXT", catalogue, others, "mac_circle_text"},
    {"INC-HF", catalogue, others, "mac_hf_"},
    {"OLD-", catalogue, others, "old_"},
    {"S2-", catalogue, others, "sh2_"},
    {"SQ-", catalogue, others, "shq_"},
    {"PRIM-GEN", "render/shape_pictures_test.cpp", "looksAsInPovray", ""},
    {"PRIM-BLOB", catalogue, others, "blob_"},
    {"PRIM-BOX", catalogue, others, "box_"},
    {"PRIM-CONE", catalogue, others, "cone_"},
    {"PRIM-CYL", catalogue, others, "cylinder_"},
    {"PRIM-HF", catalogue, others, "hf_"},
    {"PRIM-JULIA", catalogue, others, "julia_"},
    {"PRIM-SPLINE", catalogue, others, "lathe_"},
    {"PRIM-LATHE", catalogue, others, "lathe_"},
    {"PRIM-PRISM", catalogue, others, "prism_"},
    {"PRIM-SPHERE", catalogue, others, "sphere_"},
    {"PRIM-SWEEP", catalogue, others, "sweep_"},
    {"PRIM-SUPER", catalogue, others, "superellipsoid_"},
    {"PRIM-SOR", catalogue, others, "sor_"},
    {"PRIM-TEXT", catalogue, others, "text_"},
    {"PRIM-TORUS", catalogue, others, "torus_"},
    {"PATCH-", catalogue, others, "triangle_"},
    {"PATCH-STRI", catalogue, others, "smooth_triangle_"},
    {"INF-PLANE", catalogue, others, "plane_"},
    {"INF-POLY", catalogue, others, "poly"},
    {"INF-QUADRIC", catalogue, others, "quadric_"},
    {"INF-GEN", "language/shape_parsers_test.cpp", "explainsMistakes", ""},
    {"CONF-01", catalogue, others, "lathe_quadratic"},
    {"CONF-02", catalogue, others, "lathe_cubic"},
    {"CONF-03", catalogue, others, "julia_defaults"},
    {"CONF-05", catalogue, others, "julia_hyper_"},
    {"CONF-06", catalogue, others, "julia_hyper_sqr"},
    {"CONF-08", catalogue, others, "hf_function"},
    {"CONF-10", catalogue, others, "prism_"},
    {"CONF-13", catalogue, others, "superellipsoid_"},
    {"CONF-14", catalogue, others, "plane_negative"},
    {"CONF-15", catalogue, others, "sor_"},
    {"CONF-29", catalogue, others, "mac_hf_"},
    {"CONF-30", catalogue, others, "mac_hf_cylinder"},
    {"CONF-31", catalogue, others, "mac_round_"},
    {"CONF-32", catalogue, others, "mac_round_cone"},
    {"CONF-33", catalogue, others, "old_cone_"},
    {"CONF-34", catalogue, others, "old_paraboloid_z"},
    {"CONF-35", catalogue, others, "old_hyperboloid"},
    {"CONF-36", catalogue, others, "sh2_square_"},
    {"CONF-37", catalogue, others, "shq_bicorn"},
    {"CONF-38", catalogue, others, "shq_helix"},
    {"CONF-39", catalogue, others, "shq_lemniscate"},
    {"CONF-40", catalogue, others, "shq_hyperbolic_torus"},
    {"CONF-41", catalogue, others, "shq_quartic_paraboloid"},
    {"CONF-42", catalogue, others, "shq_sinsurf"},
    {"CONF-43", catalogue, others, "shq_glob_5"},
    {"CONF-44", catalogue, others, "shq_devils_curve"},
    {"CONF-69", catalogue, others, "poly7_"},
    {"CONF-72", catalogue, others, "julia_quat_few_iterations"},
    {"CONF-74", catalogue, others, "old_ellipsoid"},
    {"CONF-78", catalogue, others, "mac_supertorus"},
    {"CONF-83", catalogue, others, "sh2_pyramid2"},
    {"CONF-86", catalogue, others, "prism_quadratic"},
    {"CONF-91", catalogue, others, "shq_"},
    {"CONF-26", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"CONF-27", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"CONF-28", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"CONF-77", "language/golden_macros_test.cpp", "agreeWithPovray", ""},
    {"CONF-04", "language/shape_parsers_test.cpp", "precisionOfJuliaSetsIsOneAtLeast", ""},
    {"CONF-87", "language/shape_parsers_test.cpp", "sturmTakesAnOptionalNumber", ""},
    {"CONF-94", "language/shape_parsers_test.cpp", "hypercomplexCubeIsACube", ""},
    {"CONF-95", "shapes/julia_normals_test.cpp", "oursAreThoseOfTheSurface", "julia_hyper_"},
    {"CONF-45", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-46", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-47", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-48", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-49", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-50", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-51", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-52", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-53", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-54", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-55", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-84", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-88", "function/builtin_test.cpp", "goldenRowsWithConstantParameters", "isof_"},
    {"CONF-19", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-20", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-21", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-22", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-16", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-17", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-23", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-24", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-25", "language/example_scenes_test.cpp", "scenes", ""},
    {"CONF-85", "language/example_scenes_test.cpp", "scenes", ""},
    {"VL-SOLVER", "roots/polynomial_roots_test.cpp", "closedFormsAgreeWhereTheyApply", ""},
    {"VL-SOLVER", "virtualight/shapes_test.cpp", "solversAgree", ""},
    {"VL-GEN", "virtualight/document_parser_test.cpp", "expressions", ""},
    {"VL-GEN-EX", "virtualight/document_parser_test.cpp", "constantsOfTheArchiveFile", ""},
    {"VL-BICUBIC", "virtualight/shapes_test.cpp", "cornersOfTheBases", ""},
    {"VL-BLOBBY", "virtualight/shapes_test.cpp", "blobbyFieldsAddUp", ""},
    {"VL-BOX", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"VL-CONE", "virtualight/shapes_test.cpp", "capsAreNotDrawn", ""},
    {"VL-CYL", "virtualight/shapes_test.cpp", "capsAreNotDrawn", ""},
    {"VL-DISK", "virtualight/shapes_test.cpp", "ringAndDisk", ""},
    {"VL-EXTRUDE", "virtualight/shapes_test.cpp", "extrusionGoesAlongItsDirection", ""},
    {"VL-HF", "virtualight/shapes_test.cpp", "heightFieldsFollowTheirFunction", ""},
    {"VL-IMPLPLANARHF", "virtualight/shapes_test.cpp", "heightFieldsFollowTheirFunction", ""},
    {"VL-IMPLSPHHF", "virtualight/shapes_test.cpp", "heightFieldsFollowTheirFunction", ""},
    {"VL-PLANARHF", "virtualight/shapes_test.cpp", "fieldsOfImagesUseRawValues", ""},
    {"VL-SPHERICALHF", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"VL-IMPLICIT-", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"VL-NURBS", "shapes/nurbs_surface_test.cpp", "rationalSurfaceIsRound", ""},
    {"VL-PARABOLOID", "virtualight/shapes_test.cpp", "capsAreNotDrawn", ""},
    {"VL-PARAMETRIC", "virtualight/shapes_test.cpp", "parametricSurfaceKeepsToItsDomain", ""},
    {"VL-POLYGON", "virtualight/document_parser_test.cpp", "mistakes", ""},
    {"VL-POLY-", "virtualight/shapes_test.cpp", "solversAgree", ""},
    {"VL-RING", "virtualight/shapes_test.cpp", "ringAndDisk", ""},
    {"VL-SPHERE-", "virtualight/document_parser_test.cpp", "mistakes", ""},
    {"VL-SUPERQUADRIC", "virtualight/shapes_test.cpp", "superquadricOfOneIsASphere", ""},
    {"VL-TORUS", "virtualight/shapes_test.cpp", "torusAroundItsAxis", ""},
    {"VL-SOR", "virtualight/shapes_test.cpp", "profilePointsSayOnOrOff", ""},
    {"VL-TRIPATCH", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"VL-CSG", "virtualight/document_parser_test.cpp", "setOperators", ""},
    {"VL-CSG-EX", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"CONF-56", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"CONF-58", "virtualight/shapes_test.cpp", "profilePointsSayOnOrOff", ""},
    {"CONF-59", "virtualight/shapes_test.cpp", "basisMatricesAddUpToOne", ""},
    {"CONF-60", "virtualight/shapes_test.cpp", "superquadricOfOneIsASphere", ""},
    {"CONF-61", "virtualight/shapes_test.cpp", "parametricSurfaceKeepsToItsDomain", ""},
    {"CONF-63", "virtualight/shapes_test.cpp", "solversAgree", ""},
    {"CONF-64", "virtualight/pictures_test.cpp", "furtherTextsLookAsTheirExport", ""},
    {"CONF-65", "virtualight/shapes_test.cpp", "extrusionGoesAlongItsDirection", ""},
    {"CONF-66", "virtualight/shapes_test.cpp", "heightFieldsFollowTheirFunction", ""},
    {"CONF-67", "virtualight/shapes_test.cpp", "capsAreNotDrawn", ""},
    {"CONF-69", "virtualight/document_parser_test.cpp", "mistakes", ""},
    {"CONF-70", "shapes/nurbs_surface_test.cpp", "rationalSurfaceIsRound", ""},
    {"CONF-71", "virtualight/document_parser_test.cpp", "setOperators", ""},
    {"CONF-73", "virtualight/shapes_test.cpp", "blobbyFieldsAddUp", ""},
    {"CONF-75", "virtualight/pictures_test.cpp", "examplesLookAsTheirExport", ""},
    {"CONF-76", "virtualight/shapes_test.cpp", "bezierPointsMakeTheSamePatch", ""},
    {"CONF-80", "virtualight/shapes_test.cpp", "fieldsOfImagesUseRawValues", ""},
    {"CONF-81", "virtualight/document_parser_test.cpp", "notationIsKnownByEndingOrContent", ""},
    {"CONF-82", "virtualight/document_parser_test.cpp", "expressions", ""},
    {"CONF-90", "virtualight/shapes_test.cpp", "torusAroundItsAxis", ""},
};

std::vector<std::string> identifiers() {
    QFile file(test::dataFile("spec/coverage_ids.txt"));
    if (!file.open(QIODevice::ReadOnly)) {
        file.setFileName(QStringLiteral(ISOSCOPE_TEST_DATA "/spec/coverage_ids.txt"));
        if (!file.open(QIODevice::ReadOnly)) return {};
    }
    std::vector<std::string> ids;
    for (const QByteArray& line : file.readAll().split('\n'))
        if (!line.trimmed().isEmpty()) ids.push_back(line.trimmed().toStdString());
    return ids;
}

}  // namespace

class CoverageTest : public QObject {
    Q_OBJECT

  private slots:
    void groupOfRows_data() {
        QTest::addColumn<int>("number");
        for (std::size_t k = 0; k < groups.size(); ++k) QTest::newRow(groups[k].rows) << static_cast<int>(k);
    }

    void groupOfRows() {
        QFETCH(int, number);
        const Group& group = groups[static_cast<std::size_t>(number)];
        const std::vector<std::string> ids = identifiers();
        QVERIFY(std::any_of(ids.begin(), ids.end(),
                            [&](const std::string& id) { return id.starts_with(group.rows); }));
        QFile source(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tests/") + group.file);
        QVERIFY2(source.open(QIODevice::ReadOnly), group.file);
        QVERIFY2(source.readAll().contains(QByteArray("void ") + group.test + "()"), group.test);
        const test::CsvTable shapes(test::dataFile("golden/shapes.csv"));
        int found = 0;
        for (std::size_t row = 0; row < shapes.rowCount(); ++row)
            found += shapes.field(row, "shape").starts_with(group.shapes);
        QVERIFY2(found > 0, group.shapes);
    }

    void rowsCoveredOfAll() {
        const std::vector<std::string> ids = identifiers();
        QCOMPARE(ids.size(), std::size_t(1418));
        std::map<std::string, int> open;
        int covered = 0;
        for (const std::string& id : ids) {
            const bool held = std::any_of(groups.begin(), groups.end(),
                                          [&](const Group& group) { return id.starts_with(group.rows); });
            covered += held;
            if (!held) ++open[id.substr(0, id.rfind('-'))];
        }
        for (const auto& [area, count] : open) qInfo("no test: %s (%d rows)", area.c_str(), count);
        qInfo("%d / %zu rows covered", covered, ids.size());
        QVERIFY(covered >= 1403);
    }
};

QTEST_APPLESS_MAIN(CoverageTest)
#include "coverage_test.moc"

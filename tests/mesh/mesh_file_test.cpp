// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_file.h"

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <QTemporaryDir>
#include <QTest>
#include <sstream>
#include <zip.h>

#include "core/shapes/trace_context.h"
#include "tests/support/mesh_case.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const SceneMesh& example() {
    static const SceneMesh made =
        meshOf(statement("max(f_sphere(x,y,z,1), x-0.3)", "box { -2, 2 }",
                         "pigment { gradient y color_map { [0 rgb x] [1 rgb z] } } translate <0,0,3>") +
                   statement("f_torus(x,y,z,1,0.3)", "box { -2, 2 }", "pigment { rgb y }"),
               0.03);
    return made;
}

template <class Number>
Number numberAt(const std::string& bytes, std::size_t at) {
    Number value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

std::string entryOf(const std::string& archive, const char* name) {
    zip_source_t* source = zip_source_buffer_create(archive.data(), archive.size(), 0, nullptr);
    zip_t* zip = zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (zip == nullptr) return {};
    zip_stat_t size;
    std::string text;
    if (zip_file_t* file = zip_fopen(zip, name, 0); file != nullptr && zip_stat(zip, name, 0, &size) == 0) {
        text.resize(size.size);
        if (zip_fread(file, text.data(), size.size) != static_cast<zip_int64_t>(size.size)) text.clear();
        zip_fclose(file);
    }
    zip_close(zip);
    return text;
}

}  // namespace

class MeshFileTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QCOMPARE(example().problem, std::string()); }

    void endingsSayTheFormat() {
        QVERIFY(meshFormat("a/b.STL") == MeshFormat::stl && meshFormat("x.3mf") == MeshFormat::threeMf);
        QVERIFY(meshFormat("x.inc") == MeshFormat::povray && meshFormat("x.glb") == MeshFormat::gltf);
        QVERIFY(!meshFormat("x.png") && !meshFormat("stl"));
    }

    void stlHasATriangleInFiftyBytes() {
        const TriangleMesh& mesh = example().mesh;
        const std::string bytes = meshFile(mesh, MeshFormat::stl).content;
        QCOMPARE(bytes.size(), 84 + 50 * mesh.triangles.size());
        QCOMPARE(numberAt<std::uint32_t>(bytes, 80), static_cast<std::uint32_t>(mesh.triangles.size()));
        // Up is z, and the corners go the other way round with it.
        const Triangle& t = mesh.triangles[5];
        const glm::dvec3 p = mesh.points[t[0]];
        const std::size_t at = 84 + 5 * 50 + 12;
        QCOMPARE(numberAt<float>(bytes, at), static_cast<float>(p.x));
        QCOMPARE(numberAt<float>(bytes, at + 4), static_cast<float>(p.z));
        QCOMPARE(numberAt<float>(bytes, at + 8), static_cast<float>(p.y));
        QCOMPARE(numberAt<float>(bytes, at + 12), static_cast<float>(mesh.points[t[2]].x));
    }

    void plyHasPointsNormalsAndColours() {
        const TriangleMesh& mesh = example().mesh;
        const std::string bytes = meshFile(mesh, MeshFormat::ply).content;
        const std::string end = "end_header\n";
        const std::size_t body = bytes.find(end) + end.size();
        QVERIFY(bytes.find("element vertex " + std::to_string(mesh.points.size())) < body);
        QVERIFY(bytes.find("property uchar red") < body);
        QCOMPARE(bytes.size(), body + 27 * mesh.points.size() + 13 * mesh.triangles.size());
        QCOMPARE(numberAt<std::uint8_t>(bytes, body + 24), static_cast<std::uint8_t>(mesh.colors[0] >> 16));
        QCOMPARE(numberAt<std::uint32_t>(bytes, bytes.size() - 12), mesh.triangles.back()[0]);
    }

    void objNamesEachIsosurface() {
        const TriangleMesh& mesh = example().mesh;
        const std::string text = meshFile(mesh, MeshFormat::obj).content;
        QCOMPARE(count(text, "\nv "), mesh.points.size());
        QCOMPARE(count(text, "\nvn "), mesh.normals.size());
        QCOMPARE(count(text, "\nf "), mesh.triangles.size());
        QCOMPARE(count(text, "\no "), std::size_t(2));
        std::istringstream first(text.substr(text.find("\nv ") + 3));
        double x, y, z, red;
        first >> x >> y >> z >> red;
        QVERIFY(std::abs(z + mesh.points[0].z) < 1e-6 && std::abs(y - mesh.points[0].y) < 1e-6);
    }

    void gltfIsWholeAndPartsSharpPoints() {
        const TriangleMesh& mesh = example().mesh;
        const std::string bytes = meshFile(mesh, MeshFormat::gltf).content;
        QCOMPARE(bytes.substr(0, 4), std::string("glTF"));
        QCOMPARE(numberAt<std::uint32_t>(bytes, 8), static_cast<std::uint32_t>(bytes.size()));
        const std::size_t textSize = numberAt<std::uint32_t>(bytes, 12);
        const auto json = nlohmann::json::parse(bytes.substr(20, textSize));
        QCOMPARE(json["meshes"].size(), std::size_t(2));
        QCOMPARE(json["buffers"][0]["byteLength"].get<std::size_t>(), bytes.size() - 28 - textSize);
        std::size_t points = 0, corners = 0, end = 0;
        for (const auto& object : json["meshes"]) {
            const auto& primitive = object["primitives"][0];
            points += json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()]["count"]
                          .get<std::size_t>();
            corners += json["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>();
            QVERIFY(primitive["attributes"].contains("COLOR_0"));
        }
        for (const auto& view : json["bufferViews"]) {
            QCOMPARE(view["byteOffset"].get<std::size_t>(), end);
            QCOMPARE(end % 4, std::size_t(0));
            end += view["byteLength"].get<std::size_t>();
        }
        QCOMPARE(corners, 3 * mesh.triangles.size());
        QVERIFY(points > mesh.points.size());  // the ball has a sharp edge
    }

    void threeMfIsAnArchiveWithColours() {
        const TriangleMesh& mesh = example().mesh;
        const std::string bytes = meshFile(mesh, MeshFormat::threeMf).content;
        QVERIFY(!entryOf(bytes, "[Content_Types].xml").empty() && !entryOf(bytes, "_rels/.rels").empty());
        const std::string model = entryOf(bytes, "3D/3dmodel.model");
        QCOMPARE(count(model, "<vertex "), mesh.points.size());
        QCOMPARE(count(model, "<triangle "), mesh.triangles.size());
        QCOMPARE(count(model, "<object "), std::size_t(2));
        QVERIFY(count(model, "<m:color ") > 10 && count(model, "<m:color color=\"#00FF00\"") == 1);
        QVERIFY(bytes == meshFile(mesh, MeshFormat::threeMf).content);
    }

    void povrayDrawsTheSameSilhouette() {
        if (!hasPovray()) QSKIP(povrayIsMissing);
        QTemporaryDir folder;
        const std::string scene =
            "#version 3.7; global_settings { assumed_gamma 1 }\n#include \"functions.inc\"\n"
            "camera { location <1,2,-6> look_at <0,0,1> right 4/3*x angle 45 }\n"
            "background { rgb <0,0,1> }\n";
        const std::string look = "pigment { rgb x } finish { ambient 0 emission 1 diffuse 0 } ";
        const std::string surfaces =
            statement("max(f_sphere(x,y,z,1), x-0.3)", "box { -2, 2 }", "max_gradient 2 translate <0,0,3>") +
            statement("f_torus(x,y,z,1,0.3)", "box { -2, 2 }", "max_gradient 2");
        const SceneMesh made = meshOf(surfaces, 0.02);
        const QString file =
            writeFile(folder.path(), "mesh.inc",
                      QByteArray::fromStdString(meshFile(made.mesh, MeshFormat::povray).content));
        const PovrayRun run;
        const Image mesh = povrayPicture(
            scene + "#include \"" + file.toStdString() + "\"\nobject { Isoscope_Mesh " + look + "}\n", run);
        const Image traced = povrayPicture(scene + "union { " + surfaces + look + "}\n", run);
        QCOMPARE(mesh.pixels.size(), traced.pixels.size());
        std::size_t same = 0, covered = 0;
        for (std::size_t i = 0; i < mesh.pixels.size(); ++i) {
            same += (mesh.pixels[i][0] > 0.5f) == (traced.pixels[i][0] > 0.5f) ? 1 : 0;
            covered += traced.pixels[i][0] > 0.5f ? 1 : 0;
        }
        const double share = static_cast<double>(same) / static_cast<double>(mesh.pixels.size());
        qInfo("%.2f %% of the pixels agree, %zu are covered", 100 * share, covered);
        QVERIFY(covered > 1000 && share > 0.99);
    }
};

QTEST_APPLESS_MAIN(MeshFileTest)
#include "mesh_file_test.moc"

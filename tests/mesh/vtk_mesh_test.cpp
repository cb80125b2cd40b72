// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK reads of our files: closed, and with the silhouette of the ray traced solid.
#include <cmath>
#include <glm/geometric.hpp>
#include <QTemporaryDir>
#include <QTest>
#include <vtkFeatureEdges.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include "core/exchange/read_scene.h"
#include "core/mesh/files/mesh_file.h"
#include "core/mesh/scene_mesh.h"
#include "test_folders.h"
#include "tests/support/program.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

constexpr int width = 240, height = 180;

/// A pinhole that looks at a ball from above and the right.
struct View {
    glm::dvec3 eye, ahead, right, up;

    View(const glm::dvec3& center, double radius) {
        ahead = glm::normalize(glm::dvec3(-0.5, -0.45, 0.8));
        eye = center - 3.2 * radius * ahead;
        right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), ahead));
        up = glm::cross(ahead, right);
    }
    Ray ray(int x, int y) const {
        const double u = (x + 0.5 - width / 2.0) / height, v = (height / 2.0 - y - 0.5) / height;
        return {eye, ahead + 0.75 * (u * right + v * up), static_cast<std::uint32_t>(0)};
    }
    glm::dvec2 pixel(const glm::dvec3& p) const {
        const glm::dvec3 way = p - eye;
        const double depth = 0.75 * glm::dot(way, ahead);
        return {glm::dot(way, right) / depth * height + width / 2.0 - 0.5,
                height / 2.0 - 0.5 - glm::dot(way, up) / depth * height};
    }
};

std::vector<char> tracedCover(const Scene& scene, const View& view) {
    std::vector<Ray> rays;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            rays.push_back(view.ray(x, y));
            rays.back().sample = Ray::noSample;
        }
    TraceContext context(scene.parameterTable, RootFinder::certified);
    std::vector<NearestHit> hits(rays.size());
    for (const SceneObject& object : scene.objects) object.shape->nearest(rays, context, hits);
    std::vector<char> cover;
    for (const NearestHit& hit : hits) cover.push_back(hit.found ? 1 : 0);
    return cover;
}

std::vector<char> meshCover(vtkPolyData* mesh, const View& view) {
    std::vector<char> cover(static_cast<std::size_t>(width) * height, 0);
    vtkNew<vtkIdList> corners;
    for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t) {
        mesh->GetCellPoints(t, corners);
        glm::dvec2 p[3];
        for (int k = 0; k < 3; ++k) {
            double place[3];
            mesh->GetPoint(corners->GetId(k), place);
            p[k] = view.pixel({place[0], place[2], place[1]});  // z is up in the file
        }
        const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
        const double area = cross(p[1] - p[0], p[2] - p[0]);
        if (area == 0) continue;
        const int left = std::max(0, int(std::floor(std::min({p[0].x, p[1].x, p[2].x}))));
        const int last = std::min(width - 1, int(std::ceil(std::max({p[0].x, p[1].x, p[2].x}))));
        const int top = std::max(0, int(std::floor(std::min({p[0].y, p[1].y, p[2].y}))));
        const int bottom = std::min(height - 1, int(std::ceil(std::max({p[0].y, p[1].y, p[2].y}))));
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= last; ++x) {
                const glm::dvec2 at(x, y);
                bool in = true;
                for (int k = 0; k < 3; ++k) in = in && cross(p[(k + 1) % 3] - p[k], at - p[k]) * area >= 0;
                if (in) cover[static_cast<std::size_t>(y) * width + x] = 1;
            }
    }
    return cover;
}

vtkIdType openEdges(vtkPolyData* mesh) {
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(mesh);
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->Update();
    return edges->GetOutput()->GetNumberOfCells();
}

}  // namespace

class VtkMeshTest : public QObject {
    Q_OBJECT

  private slots:
    void readsWhatIsWritten_data() {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"sphere", "torus", "csg", "gyroid", "klein", "barth", "blend", "noise", "terrain"})
            QTest::newRow(name) << QString(name);
    }

    void readsWhatIsWritten() {
        QFETCH(QString, name);
        const ParseResult parsed =
            readSceneFile(std::string(ISOSCOPE_SOURCE_DIR "/tests/bench/") + name.toStdString() + ".pov");
        QVERIFY(parsed.ok());
        const std::vector<PlacedIsosurface> surfaces = placedIsosurfaces(*parsed.scene);
        SceneMeshSettings settings;
        settings.threads = 2;
        settings.tolerance = 2 * usualTolerance(surfaces.at(0).shape->settings().container);
        const SceneMesh made = meshScene(*parsed.scene, surfaces, settings);
        QCOMPARE(made.problem, std::string());
        QVERIFY(made.report.form.watertight() && made.report.form.manifold() && made.report.keepsTolerance());
        QTemporaryDir folder;
        const auto write = [&](const char* file, MeshFormat format) {
            return writeFile(folder.path(), file,
                             QByteArray::fromStdString(meshFile(made.mesh, format).content))
                .toLocal8Bit();
        };
        vtkNew<vtkSTLReader> stl;
        stl->SetFileName(write("m.stl", MeshFormat::stl));
        stl->Update();
        vtkNew<vtkPLYReader> ply;
        ply->SetFileName(write("m.ply", MeshFormat::ply));
        ply->Update();
        vtkNew<vtkOBJReader> obj;
        obj->SetFileName(write("m.obj", MeshFormat::obj));
        obj->Update();
        const auto triangles = static_cast<vtkIdType>(made.mesh.triangles.size());
        QCOMPARE(ply->GetOutput()->GetNumberOfPolys(), triangles);
        QCOMPARE(obj->GetOutput()->GetNumberOfPolys(), triangles);
        QCOMPARE(ply->GetOutput()->GetNumberOfPoints(), static_cast<vtkIdType>(made.mesh.points.size()));
        QCOMPARE(openEdges(ply->GetOutput()), vtkIdType(0));
        // The reader of STL joins points by their places.
        QCOMPARE(stl->GetOutput()->GetNumberOfPolys(), triangles);
        QCOMPARE(openEdges(stl->GetOutput()), vtkIdType(0));

        const Bounds bounds = parsed.scene->objects.at(0).shape->bounds();
        const View view(0.5 * (bounds.low + bounds.high), 0.5 * glm::distance(bounds.low, bounds.high));
        const std::vector<char> traced = tracedCover(*parsed.scene, view);
        const std::vector<char> drawn = meshCover(stl->GetOutput(), view);
        std::size_t same = 0, covered = 0;
        for (std::size_t i = 0; i < traced.size(); ++i) {
            same += traced[i] == drawn[i] ? 1 : 0;
            covered += traced[i];
        }
        const double share = static_cast<double>(same) / static_cast<double>(traced.size());
        qInfo("%-8s %7zu triangles, %zu pixels covered, %.3f %% agree", qPrintable(name),
              made.mesh.triangles.size(), covered, 100 * share);
        QVERIFY(covered > 500);
        QVERIFY(share > 0.99);
    }
};

QTEST_APPLESS_MAIN(VtkMeshTest)
#include "vtk_mesh_test.moc"

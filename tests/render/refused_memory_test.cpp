// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <new>

#include "core/exchange/picture_file.h"
#include "core/exchange/png.h"
#include "core/language/parse.h"
#include "core/mesh/scene_mesh.h"
#include "core/render/render_image.h"
#include "tests/support/refusing_new.h"
#include "tests/support/scene_picture.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace isoscope;
using namespace isoscope::test;

namespace {

const char* const everything = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <-3, 5, -6> rgb 1 area_light x, y, 2, 2 }
light_source { <3, 5, -6> rgb 0.5 spotlight point_at 0 }
isosurface { function { x*x + y*y + z*z - 1 + 0.3*f_noise3d(3*x, 3*y, 3*z) + 0.1*floor(2*x) }
  contained_by { box { -1.5, 1.5 } } max_gradient 6
  texture { pigment { granite color_map { [0 rgb 0] [1 rgb 1] } } normal { bumps 0.5 }
    finish { phong 1 reflection 0.2 } } }
difference { box { -0.7, 0.7 } sphere { 0, 0.8 } pigment { checker rgb 1, rgb x } translate 1.5*x }
union { sphere { 0, 0.5 } torus { 0.5, 0.1 } cylinder { 0, y, 0.2 } translate -1.5*x
  pigment { rgbf <1, 0.9, 0.8, 0.7> } interior { ior 1.3 } }
blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, x, 1, 1 } translate y pigment { bozo } }
sky_sphere { pigment { gradient y } } fog { distance 30 color rgb 0.5 }
plane { y, -1.5 pigment { hexagon rgb 1, rgb 0.5, rgb 0 } }
)";

}  // namespace

/// Memory that is refused at any one moment of drawing, of writing a picture and of making a mesh: nothing,
/// or what there is on every day; never a crash. The next one is as always. By one thread, whose allocations
/// are counted.
class RenderRefusedMemoryTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    /// Refuses the 1st, 2nd, ... allocation of `make`: the first and the last 150 one by one, fewer between.
    /// `isUsual` tells a result of every day, `isNone` one that memory was refused to.
    template <class Make, class IsUsual, class IsNone>
    static void refuseEach(const Make& make, const IsUsual& isUsual, const IsNone& isNone) {
        make();
        asked = 0;
        QVERIFY(isUsual(make()));
        const long all = asked;
        int none = 0, usual = 0;
        constexpr long ends = 150;
        for (long at = 0; at < all;
             at += at < ends || at > all - ends ? 1 : std::min(1 + at / 20, all - ends - at + 1)) {
            bool happened = false;
            const auto result = refusing(at, happened, make);
            if (!happened) break;
            QVERIFY2(isNone(result) || isUsual(result), ("allocation " + std::to_string(at)).c_str());
            ++(isNone(result) ? none : usual);
        }
        QVERIFY(isUsual(make()));
        qInfo("%ld allocations; refused: %d gave nothing, %d the usual result", all, none, usual);
        QVERIFY(none > 0);
    }

    static RenderRequest requestOf(const ParseResult& parsed, RootFinder finder) {
        RenderRequest request = requestFor(parsed, 32, 24);
        request.rootFinder = finder;
        return request;
    }

  private slots:
    void pictures_data() {
        QTest::addColumn<bool>("certified");
        QTest::addColumn<bool>("antialias");
        QTest::newRow("as POV-Ray") << false << false;
        QTest::newRow("exact") << true << false;
        QTest::newRow("exact, smooth") << true << true;
    }

    void pictures() {
        QFETCH(bool, certified);
        QFETCH(bool, antialias);
        const ParseResult parsed = parseScene(everything);
        QVERIFY(parsed.ok());
        RenderRequest request = requestOf(parsed, certified ? RootFinder::certified : RootFinder::lipschitz);
        request.antialias = antialias;
        const Image usual = renderImage(request, 1);
        refuseEach([&] { return renderImage(request, 1); },
                   [&](const Image& image) { return image.pixels == usual.pixels; },
                   [](const Image& image) { return image.pixels.empty(); });
    }

    /// What is made when a scene is drawn for the first time is refused, too.
    void firstPictures() {
        const Image usual = renderImage(requestOf(parseScene(everything), RootFinder::certified), 1);
        for (long at = 0, step = 1; at < 4000; at += step, step += 1 + at / 200) {
            const RenderRequest request = requestOf(parseScene(everything), RootFinder::certified);
            bool happened = false;
            const Image image = refusing(at, happened, [&] { return renderImage(request, 1); });
            QVERIFY2(image.pixels.empty() || image.pixels == usual.pixels, std::to_string(at).c_str());
            QVERIFY(renderImage(request, 1).pixels == usual.pixels);
            if (!happened) break;
        }
    }

    void pictureFiles_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("png") << "a.png";
        QTest::newRow("exr") << "a.exr";
    }

    void pictureFiles() {
        QFETCH(QString, name);
        const ParseResult parsed = parseScene(everything);
        const RenderRequest request = requestOf(parsed, RootFinder::certified);
        PictureFileOptions options;
        options.threads = 1;
        options.format = *pictureFormat(name.toStdString());
        const std::filesystem::path path = folder_.filePath(name).toStdString();
        refuseEach([&] { return writePictureFile(path, request, options); },
                   [](const PictureFileResult& result) { return result.problem.empty(); },
                   [](const PictureFileResult& result) { return !result.problem.empty(); });
        // Nothing half written lies about.
        QCOMPARE(QDir(folder_.path()).entryList({"*.part", ".*"}, QDir::Files | QDir::Hidden), QStringList());
    }

    /// libpng and zlib were left with what they had taken; so AddressSanitizer said.
    void refusedPngsGiveTheirMemoryBack() {
#if !defined(__GLIBC__)
        QSKIP("only glibc says how much memory is taken");
#else
        const Image image(32, 24);
        const auto make = [&]() -> std::string {
            try {
                return encodePng(image, 1);
            } catch (const std::bad_alloc&) {
                return {};
            }
        };
        const auto refuseAll = [&] {
            long at = 0;
            for (bool happened = true; happened; ++at) refusing(at, happened, make);
            return at;
        };
        refuseAll();
        const std::size_t before = mallinfo2().uordblks;
        QVERIFY(refuseAll() > 10);
        const std::size_t after = mallinfo2().uordblks;
        // Less than any of their structures.
        QVERIFY2(after < before + 300, qPrintable(QString("%1 bytes more").arg(after - before)));
#endif
    }

    void meshes() {
        const ParseResult parsed = parseScene(everything);
        SceneMeshSettings settings;
        settings.threads = 1;
        settings.tolerance = 0.2;
        const std::vector<PlacedIsosurface> surfaces = placedIsosurfaces(*parsed.scene);
        const auto make = [&] { return meshScene(*parsed.scene, surfaces, settings); };
        const SceneMesh usual = make();
        QVERIFY(usual.problem.empty());
        refuseEach(
            make, [&](const SceneMesh& mesh) { return mesh.mesh.points == usual.mesh.points; },
            [](const SceneMesh& mesh) { return !mesh.problem.empty() && mesh.mesh.points.empty(); });
    }
};

QTEST_APPLESS_MAIN(RenderRefusedMemoryTest)
#include "refused_memory_test.moc"

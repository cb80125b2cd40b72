// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/picture_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cmath>
#include <map>
#include <set>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/exchange/output_guard.h"
#include "core/exchange/png.h"
#include "core/image/raster_file.h"
#include "core/render/render_image.h"
#include "core/study/view/traced_view.h"
#include "tests/support/png_channels.h"
#include "tests/support/scene_picture.h"

using namespace isoscope;

namespace {

const char* const sphereScene = R"(
global_settings { assumed_gamma 1 }
background { rgb <0.2, 0.4, 0.6> }
camera { location <0, 0, -4> look_at 0 angle 40 }
light_source { <-3, 5, -6> rgb 1 }
isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } max_gradient 4
  pigment { rgb <0.9, 0.5, 0.1> } }
)";

RenderRequest requestFor(int width, int height, RootFinder finder = RootFinder::certified) {
    RenderRequest request = test::requestFor(parseScene(sphereScene), width, height);
    request.rootFinder = finder;
    return request;
}

/// Larger than a strip; the sphere is small in it, so that it takes little time.
RenderRequest largeRequest(RootFinder finder = RootFinder::certified) {
    RenderRequest request = requestFor(2048, 2200, finder);
    request.camera.location.z = -60;
    return request;
}

/// All channels of an OpenEXR picture as floats.
struct ExrPicture {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels;
    std::string verdicts;
};

ExrPicture readExr(const std::filesystem::path& file) {
    ExrPicture picture;
    Imf::InputFile input(file.c_str());
    const auto window = input.header().dataWindow();
    picture.width = window.max.x + 1;
    picture.height = window.max.y + 1;
    if (const auto* text = input.header().findTypedAttribute<Imf::StringAttribute>("verdicts"))
        picture.verdicts = text->value();
    Imf::FrameBuffer buffer;
    const auto row = sizeof(float) * static_cast<std::size_t>(picture.width);
    for (auto channel = input.header().channels().begin(); channel != input.header().channels().end();
         ++channel) {
        std::vector<float>& values = picture.channels[channel.name()];
        values.resize(static_cast<std::size_t>(picture.width * picture.height));
        buffer.insert(channel.name(),
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), row));
    }
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    return picture;
}

}  // namespace

class PictureFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }
    Raster rasterOf(const char* name) const {
        std::string problem;
        return readRaster(path(name), problem).value_or(Raster());
    }

  private slots:
    void theEndingTellsTheFormat() {
        QVERIFY(pictureFormat("a/b.png") == PictureFormat::png);
        QVERIFY(pictureFormat("b.EXR") == PictureFormat::openExr);
        QVERIFY(!pictureFormat("b.jpg") && !pictureFormat("png"));
    }

    /// The file of a picture that is one strip is that of encodePng().
    void eightBitsAreWhatTheyWere() {
        const RenderRequest request = requestFor(90, 70);
        const PictureFileResult result = writePictureFile(path("a.png"), request, {});
        QCOMPARE(result.problem, std::string());
        QCOMPARE(
            result.statistics.verdicts.at("certified-hit") + result.statistics.verdicts.at("certified-miss"),
            std::uint64_t{90 * 70});
        QFile file(folder_.filePath("a.png"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().toStdString() == encodePng(renderImage(request)));
    }

    void sixteenBitsAreTheCurveOfTheLight() {
        const RenderRequest request = requestFor(90, 70);
        QCOMPARE(writePictureFile(path("deep.png"), request, {.bits = 16}).problem, std::string());
        const Raster raster = rasterOf("deep.png");
        QCOMPARE(raster.largest, 65535);
        QCOMPARE(raster.channels, 3);
        const Image image = renderImage(request);
        std::set<std::uint16_t> values;
        for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 90; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float linear =
                        image.pixels[static_cast<std::size_t>(y * 90 + x)][static_cast<std::size_t>(c)];
                    QVERIFY(std::abs(decodeChannel(raster.at(x, y, c) / 65535.0) - linear) < 2e-5);
                    values.insert(raster.at(x, y, c));
                }
        // More than 8 bits could tell.
        QVERIFY2(values.size() > 1000, qPrintable(QString::number(values.size())));
        // The background, by the formula of sRGB.
        QCOMPARE(raster.at(0, 0, 0),
                 static_cast<std::uint16_t>(std::lround(65535 * (1.055 * std::pow(0.2f, 1 / 2.4) - 0.055))));
    }

    void transparentPngsKeepTheColourOfTheObject() {
        RenderRequest request = requestFor(90, 70);
        request.antialias = true;
        request.transparent = true;
        for (const int bits : {8, 16}) {
            QCOMPARE(writePictureFile(path("clear.png"), request, {.bits = bits}).problem, std::string());
            const test::PngChannels image = test::readPngChannels(path("clear.png"));
            QCOMPARE(image.bits, bits);
            QCOMPARE(image.channels, 4);
            QCOMPARE(image.at(0, 0, 3), 0);
            QCOMPARE(image.share(45, 35, 3), 1.0);
            const Image drawn = renderImage(request);
            int partly = 0;
            for (int y = 0; y < 70; ++y)
                for (int x = 0; x < 90; ++x) {
                    const auto i = static_cast<std::size_t>(y * 90 + x);
                    QVERIFY(std::abs(image.share(x, y, 3) - drawn.opacity[i]) < 0.5 / 255 + 1e-6);
                    if (drawn.opacity[i] < 0.3f || drawn.opacity[i] == 1) continue;
                    ++partly;
                    // The edge is orange, not orange mixed with black or blue.
                    const float light = drawn.pixels[i][0] / drawn.opacity[i];
                    QVERIFY(std::abs(decodeChannel(image.share(x, y, 0)) - light) < 0.01f);
                }
            QVERIFY(partly > 40);
        }
    }

    void exrHoldsColourDistanceNormalsAndVerdicts() {
        RenderRequest request = requestFor(64, 48);
        request.transparent = true;
        QCOMPARE(writePictureFile(path("a.exr"), request, {.format = PictureFormat::openExr}).problem,
                 std::string());
        const ExrPicture picture = readExr(path("a.exr"));
        QCOMPARE(picture.width, 64);
        QCOMPARE(picture.height, 48);
        const Image drawn = renderImage(request);
        const TracedView traced = traceView(request);
        const auto& at = picture.channels;
        int hits = 0;
        for (std::size_t i = 0; i < traced.pixels.size(); ++i) {
            const TracedPixel& pixel = traced.pixels[i];
            const float red = at.at("R")[i], shown = drawn.pixels[i][0];
            QVERIFY(std::abs(red - shown) <= 1e-3f * shown);  // half floats have eleven bits
            QCOMPARE(at.at("A")[i], pixel.found ? 1.0f : 0.0f);
            const float x = at.at("N.X")[i], y = at.at("N.Y")[i], z = at.at("N.Z")[i];
            if (!pixel.found) {
                QVERIFY(std::isinf(at.at("Z")[i]) && x == 0 && y == 0 && z == 0);
                QCOMPARE(at.at("verdict")[i], static_cast<float>(Verdict::certifiedMiss));
                continue;
            }
            ++hits;
            QCOMPARE(at.at("Z")[i], static_cast<float>(pixel.t));
            QVERIFY(std::abs(std::sqrt(x * x + y * y + z * z) - 1) < 2e-3f);
            // On the unit sphere the normal is the place.
            const glm::dvec3 place =
                pixelRay(request, static_cast<int>(i % 64), static_cast<int>(i / 64)).at(pixel.t);
            QVERIFY(std::abs(place.x - x) < 2e-3 && std::abs(place.y - y) < 2e-3 &&
                    std::abs(place.z - z) < 2e-3);
            QCOMPARE(at.at("verdict")[i], static_cast<float>(Verdict::certifiedHit));
        }
        QVERIFY(hits > 400);
        QVERIFY(picture.verdicts.starts_with("0 certified-hit, 1 certified-miss"));
    }

    void exrByPovraysMethodHasNoVerdicts() {
        const RenderRequest request = requestFor(40, 30, RootFinder::lipschitz);
        QCOMPARE(writePictureFile(path("b.exr"), request, {.format = PictureFormat::openExr}).problem,
                 std::string());
        const ExrPicture picture = readExr(path("b.exr"));
        QCOMPARE(picture.channels.count("verdict"), std::size_t{0});
        QCOMPARE(picture.channels.at("A")[0], 1.0f);  // it is not transparent
        QVERIFY(std::abs(picture.channels.at("Z")[15 * 40 + 20] - 3) < 0.01f);
    }

    /// More than one strip; the picture is the same as in one piece, where POV-Ray's order of rays counts
    /// too.
    void stripsAreThePicture() {
        for (const RootFinder finder : {RootFinder::certified, RootFinder::lipschitz}) {
            const RenderRequest request = largeRequest(finder);
            StripRenderer strips(request, 2);
            QVERIFY(strips.stripRows() < 2200);
            const Image whole = renderImage(request, 2);
            std::vector<double> shares;
            std::size_t pixel = 0;
            while (strips.nextRow() < 2200) {
                const Image strip = strips.next({}, [&](double share) { shares.push_back(share); });
                QVERIFY(std::equal(strip.pixels.begin(), strip.pixels.end(),
                                   whole.pixels.begin() + static_cast<std::ptrdiff_t>(pixel)));
                pixel += strip.pixels.size();
            }
            QCOMPARE(pixel, whole.pixels.size());
            QVERIFY(strips.next().pixels.empty());
            QVERIFY(std::is_sorted(shares.begin(), shares.end()));
            QCOMPARE(shares.back(), 1.0);
        }
    }

    void aPictureOfSeveralStripsIsReadBack() {
        const RenderRequest request = largeRequest();
        QCOMPARE(writePictureFile(path("large.png"), request, {.bits = 16}).problem, std::string());
        const Raster raster = rasterOf("large.png");
        QCOMPARE(raster.height, 2200);
        const Image whole = renderImage(request);
        for (int y = 0; y < 2200; y += 7)
            for (int x = 0; x < 2048; x += 11)
                QCOMPARE(
                    raster.at(x, y, 1),
                    encodeChannel16(
                        whole.pixels[static_cast<std::size_t>(y) * 2048 + static_cast<std::size_t>(x)][1]));
    }

    void aStoppedPictureLeavesNoFile() {
        std::stop_source stop;
        const RenderRequest request = requestFor(400, 300);
        const PictureFileResult result = writePictureFile(path("stopped.png"), request, {.threads = 1},
                                                          stop.get_token(), [&](double share) {
                                                              if (share > 0.3) stop.request_stop();
                                                          });
        QVERIFY(result.stopped);
        QVERIFY(!QFile::exists(folder_.filePath("stopped.png")));
        const PictureFileResult kept =
            writePictureFile(path("kept.png"), request, {.keepStopped = true}, stop.get_token());
        QVERIFY(kept.stopped && kept.kept && kept.problem.empty());
        QCOMPARE(test::readPngChannels(path("kept.png")).at(200, 150, 1), 0);
        QVERIFY(QDir(folder_.path()).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    /// The rest of an OpenEXR picture takes as long to be compressed as a picture: that of a large one is not
    /// written.
    void aStoppedOpenExrPictureIsKeptWhereItsRestIsSmall() {
        std::stop_source stop;
        stop.request_stop();
        const PictureFileOptions options{.format = PictureFormat::openExr, .keepStopped = true};
        const PictureFileResult kept =
            writePictureFile(path("kept.exr"), requestFor(400, 3000), options, stop.get_token());
        QVERIFY(kept.stopped && kept.kept && kept.problem.empty());
        const ExrPicture picture = readExr(path("kept.exr"));
        QCOMPARE(picture.height, 3000);
        QCOMPARE(picture.channels.at("R")[400 * 2999], 0.0f);
        QVERIFY(std::isinf(picture.channels.at("Z")[400 * 2999]));
        const PictureFileResult none =
            writePictureFile(path("none.exr"), requestFor(4096, 2400), options, stop.get_token());
        QVERIFY(none.stopped && !none.kept && none.problem.empty());
        QVERIFY(!QFile::exists(folder_.filePath("none.exr")));
    }

    void whatCannotBeWrittenIsSaid() {
        const RenderRequest request = requestFor(40, 30);
        for (const PictureFormat format : {PictureFormat::png, PictureFormat::openExr}) {
            QCOMPARE(writePictureFile(path("no/such/folder.png"), request, {.format = format}).problem,
                     std::string("No such file or directory"));
            QCOMPARE(writePictureFile("/dev/full", request, {.format = format}).problem,
                     std::string("No space left on device"));
            QCOMPARE(writePictureFile("/dev/null", request, {.format = format}).problem, std::string());
        }
        RenderRequest huge = request;
        huge.width = StripRenderer::longestSide + 1;
        QVERIFY(!writePictureFile(path("huge.png"), huge, {}).problem.empty());
        QVERIFY(!writePictureFile(path("none.png"), {}, {}).problem.empty());
    }

    void bothFormatsMayBeReplaced() {
        QVERIFY(whyNotReplaced(path("a.exr"), OutputKind::picture).empty());
        QVERIFY(whyNotReplaced(path("a.png"), OutputKind::picture).empty());
        QFile text(folder_.filePath("text.exr"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("my notes, which are longer than any mark of a picture");
        text.close();
        QVERIFY(!whyNotReplaced(path("text.exr"), OutputKind::picture).empty());
    }
};

QTEST_GUILESS_MAIN(PictureFileTest)
#include "picture_file_test.moc"

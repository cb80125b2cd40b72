// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/povray.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "core/exchange/png.h"
#include "test_folders.h"

namespace isoscope::test {

namespace {

constexpr int timeoutMilliseconds = 240'000;
constexpr int near = 8;

int channel(std::uint32_t encoded, int number) {
    return static_cast<int>(encoded >> (16 - 8 * number) & 0xff);
}

/// Of the three channels, of 255.
std::array<int, 3> channelDifferences(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    const std::uint32_t first = encodePixel(a), second = encodePixel(b);
    std::array<int, 3> differences{};
    for (int c = 0; c < 3; ++c)
        differences[static_cast<std::size_t>(c)] = std::abs(channel(first, c) - channel(second, c));
    return differences;
}

int pixelDifference(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return std::ranges::max(channelDifferences(a, b));
}

bool sameSize(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && !a.pixels.empty();
}

QStringList argumentsFor(const QString& file, const QString& picture, const PovrayRun& run) {
    QStringList arguments{"+I" + file,
                          "+O" + picture,
                          QString("+W%1").arg(run.width),
                          QString("+H%1").arg(run.height),
                          "+FN8",
                          "-D",
                          "-P",
                          "-A",
                          "+WT1",
                          "-GA"};
    for (const QString& path : run.libraryPaths) arguments << "+L" + path;
    return arguments + run.options;
}

/// All pictures that POV-Ray makes of a file: animations number theirs.
std::vector<Image> runPovray(const QString& file, const PovrayRun& run) {
    const QTemporaryDir folder;
    QProcess povray;
    povray.setWorkingDirectory(QFileInfo(file).absolutePath());
    povray.setProcessChannelMode(QProcess::MergedChannels);
    povray.start("povray", argumentsFor(file, folder.filePath("picture.png"), run));
    if (!povray.waitForFinished(timeoutMilliseconds) || povray.exitCode() != 0) {
        povray.kill();
        povray.waitForFinished();
        std::fprintf(stderr, "POV-Ray failed on %s:\n%s\n", qPrintable(file),
                     povray.readAll().right(1500).constData());
        return {};
    }
    std::vector<Image> pictures;
    for (const QString& made : QDir(folder.path()).entryList({"picture*.png"}, QDir::Files, QDir::Name))
        pictures.push_back(readPng(folder.filePath(made).toStdString()));
    return pictures;
}

}  // namespace

bool hasPovray() { return !QStandardPaths::findExecutable("povray").isEmpty(); }

Image povrayPicture(const std::string& scene, const PovrayRun& run) {
    const QTemporaryDir folder;
    QFile file(folder.filePath("scene.pov"));
    if (!file.open(QIODevice::WriteOnly)) return {};
    file.write(scene.data(), static_cast<qint64>(scene.size()));
    file.close();
    return povrayPictureOfFile(file.fileName(), run);
}

Image povrayPictureOfFile(const QString& file, const PovrayRun& run) {
    const std::vector<Image> pictures = runPovray(file, run);
    return pictures.empty() ? Image() : pictures.front();
}

std::vector<Image> povrayFrames(const QString& file, const PovrayRun& run, int count) {
    PovrayRun animation = run;
    animation.options << "+KFI1" << QString("+KFF%1").arg(count);
    return runPovray(file, animation);
}

PictureDifference comparePictures(const Image& ours, const Image& theirs) {
    PictureDifference result;
    if (!sameSize(ours, theirs)) return result;
    std::size_t within = 0;
    result.largest = 0;
    double sum = 0;
    for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
        const std::array<int, 3> channels = channelDifferences(ours.pixels[i], theirs.pixels[i]);
        const int difference = std::ranges::max(channels);
        result.largest = std::max(result.largest, difference);
        sum += channels[0] + channels[1] + channels[2];
        within += difference <= near;
    }
    const auto pixels = static_cast<double>(ours.pixels.size());
    result.shareWithin8 = static_cast<double>(within) / pixels;
    result.mean = sum / (3 * pixels);
    return result;
}

void keepPictures(const QString& name, const Image& ours, const Image& theirs) {
    QDir().mkpath(ISOSCOPE_BINARY_DIR "/pictures");
    Image sheet(ours.width + theirs.width + (sameSize(ours, theirs) ? ours.width : 0),
                std::max(ours.height, theirs.height));
    const auto at = [&](int x, int y) -> std::array<float, 3>& {
        return sheet.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(sheet.width) +
                            static_cast<std::size_t>(x)];
    };
    const auto place = [&](const Image& image, int left) {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                at(left + x, y) =
                    image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                 static_cast<std::size_t>(x)];
    };
    place(ours, 0);
    place(theirs, ours.width);
    if (sameSize(ours, theirs)) {
        Image difference = ours;
        for (std::size_t i = 0; i < difference.pixels.size(); ++i) {
            const int size = pixelDifference(ours.pixels[i], theirs.pixels[i]);
            difference.pixels[i] = size > near ? std::array<float, 3>{1, 0, 0}
                                               : std::array<float, 3>{0, decodeChannel(size / 8.0), 0};
        }
        place(difference, ours.width + theirs.width);
    }
    writePng(QString(ISOSCOPE_BINARY_DIR "/pictures/%1.png").arg(name).toStdString(), sheet);
}

}  // namespace isoscope::test

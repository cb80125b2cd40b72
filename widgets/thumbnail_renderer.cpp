// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/thumbnail_renderer.h"

#include <condition_variable>
#include <mutex>
#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <set>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/exchange/read_scene.h"
#include "core/render/render_image.h"
#include "core/study/view/fitted_view.h"
#include "widgets/background_priority.h"
#include "widgets/refused_memory.h"

namespace isoscope {
namespace {

struct Job {
    int index = 0;
    std::string scene;
    QString file;
};

/// Enough for every scene of the lists; a built-in or an example that needed more would be a fault.
constexpr std::size_t stepBudget = 100'000;

/// Little pictures need no margin.
constexpr double thumbnailShare = 0.92;

QImage render(const std::string& text, int size, std::stop_token stop) {
    ParseOptions options;
    options.stepBudget = stepBudget;
    // A text of the gallery may be anybody's.
    options.restrictedReading = true;
    const ParseResult parsed = readScene(text, options);
    if (!parsed.ok() || !parsed.scene) return {};
    RenderRequest request;
    request.scene = parsed.scene;
    SurfaceBounds surfaces(parsed.scene, {}, stop);
    const Camera& camera = parsed.scene->camera;
    request.camera = fittedView(camera, camera, surfaces, thumbnailShare).value_or(camera);
    request.width = size;
    request.height = size;
    const Image picture = renderImage(request, 1, nullptr, stop);
    if (stop.stop_requested() || picture.width != size || picture.height != size) return {};
    QImage image(size, size, QImage::Format_RGB32);
    const std::span pixels(picture.pixels);
    const auto edge = static_cast<std::size_t>(size);
    for (int y = 0; y < size; ++y)
        encodePixels(pixels.subspan(static_cast<std::size_t>(y) * edge, edge),
                     {reinterpret_cast<QRgb*>(image.scanLine(y)), edge});
    return image;
}

void store(const QImage& image, const QString& file) {
    // A cache that cannot be written costs time only.
    QSaveFile target(file);
    if (target.open(QIODevice::WriteOnly) && image.save(&target, "PNG")) target.commit();
}

/// The oldest pictures go when there are more than this: about 20 MB.
constexpr int mostPictures = 2000;

void bound(const QString& folder) {
    const QDir pictures(folder);
    const QFileInfoList files = pictures.entryInfoList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
    for (const QFileInfo& old : files.mid(mostPictures)) QFile::remove(old.filePath());
}

}  // namespace

struct ThumbnailRenderer::Worker {
    ThumbnailRenderer* owner = nullptr;
    QString folder;
    std::mutex mutex;
    std::condition_variable_any wake;
    std::vector<Job> waiting;  // the last one is next
    std::set<int> known;       // waiting, at work or failed
    std::jthread thread;

    void run(std::stop_token stop) {
        lowerThreadPriority();
        bound(folder);
        while (!stop.stop_requested()) {
            Job job;
            {
                std::unique_lock lock(mutex);
                if (!wake.wait(lock, stop, [this] { return !waiting.empty(); })) return;
                job = std::move(waiting.back());
                waiting.pop_back();
            }
            QImage image;
            doneUnlessMemoryIsRefused([&] { image = render(job.scene, owner->size_, stop); });
            if (stop.stop_requested()) return;
            if (!image.isNull()) store(image, job.file);
            QMetaObject::invokeMethod(
                owner, [this, job, image] { emit owner->ready(job.index, image); }, Qt::QueuedConnection);
        }
    }
};

ThumbnailRenderer::ThumbnailRenderer(int size, QString folder, QObject* parent)
    : QObject(parent), size_(size), worker_(std::make_unique<Worker>()) {
    worker_->owner = this;
    worker_->folder = folder.isEmpty()
                          ? QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/thumbnails"
                          : std::move(folder);
    QDir().mkpath(worker_->folder);
    worker_->thread = std::jthread([worker = worker_.get()](std::stop_token stop) { worker->run(stop); });
}

ThumbnailRenderer::~ThumbnailRenderer() {
    worker_->thread.request_stop();
    worker_->thread.join();
}

QImage ThumbnailRenderer::thumbnail(int index, std::string scene) {
    Job job{index, std::move(scene), {}};
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(QByteArray::fromStdString(job.scene));
    hash.addData(QCoreApplication::applicationVersion().toUtf8());
    job.file =
        QString("%1/%2-%3.png").arg(worker_->folder, QString::fromLatin1(hash.result().toHex())).arg(size_);
    QImage image(job.file);
    if (image.width() == size_ && image.height() == size_) return image;
    const std::lock_guard lock(worker_->mutex);
    if (!worker_->known.insert(index).second) return {};
    worker_->waiting.push_back(std::move(job));
    worker_->wake.notify_one();
    return {};
}

}  // namespace isoscope

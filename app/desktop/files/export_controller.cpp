// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/files/export_controller.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QDrag>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMimeData>
#include <QSettings>

#include "core/animation/animation.h"
#include "core/animation/animation_export.h"
#include "core/exchange/output_guard.h"
#include "core/exchange/pov_export.h"
#include "core/exchange/read_scene.h"
#include "core/exchange/virtualight_export.h"
#include "core/exchange/virtualight_writer.h"
#include "core/mesh/scene_mesh.h"
#include "core/study/gradient/gradient_proofs.h"
#include "core/study/gradient/proof_note.h"
#include "core/text/whole_file.h"
#include "widgets/document/document.h"
#include "widgets/document/save_path.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/mesh/mesh_export_dialog.h"
#include "widgets/notice_bar.h"
#include "widgets/timeline/animation_export_dialog.h"
#include "widgets/viewport/camera_text.h"
#include "widgets/pictures/image_export_dialog.h"
#include "widgets/pictures/picture_mime.h"
#include "widgets/pictures/picture_queue_window.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

const QString exportSizeKey = QStringLiteral("export/size");

}  // namespace

ExportController::ExportController(const Parts& parts)
    : QObject(parts.window), parts_(parts), queue_(new PictureQueue(this)) {
    connect(queue_, &PictureQueue::ended, this, &ExportController::tellEnd);
    parts_.viewport->overlay().setPovrayTask(
        [this](const RenderRequest& shown) { return povrayTask(shown); });
    connect(parts_.viewport, &Viewport::pictureTaken, this, &ExportController::dragPicture);
    connect(parts_.session, &SceneSession::parsed, this, [this](const auto&, quint64 revision) {
        if (viewWaits_ && revision == parts_.editor->revision()) writeViewNow();
    });
}

std::shared_ptr<const ParseResult> ExportController::presentResult() const {
    const auto& result = parts_.session->result();
    if (!result || parts_.session->resultRevision() == parts_.editor->revision()) return result;
    return std::make_shared<const ParseResult>(readScene(parts_.editor->utf8(), result->options));
}

IsosurfaceExport ExportController::isosurface() const {
    const auto result = presentResult();
    if (result && result->notation == Notation::virtualight) {
        // What stands around the caret is no statement of POV-Ray's: all objects are written.
        VirtualightExport made = virtualightObjects(*result);
        if (!made.text.empty() && made.images.images.empty()) return {std::move(made.text), {}};
        return {{},
                made.text.empty()
                    ? tr("The text shows no object to write.").toStdString()
                    : tr("The images of height fields can only be written to files.").toStdString()};
    }
    if (!result || result->scene->isosurfaces.empty())
        return {{}, tr("The scene has no isosurface to write.").toStdString()};
    const auto caret =
        static_cast<std::uint32_t>(parts_.editor->SendScintilla(QsciScintilla::SCI_GETCURRENTPOS));
    const auto& surfaces = result->scene->isosurfaces;
    std::size_t index = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (surfaces[i].range.file == 0 && surfaces[i].range.begin <= caret && caret <= surfaces[i].range.end)
            index = i;
    IsosurfaceExport block = exportIsosurface(*result, index);
    if (noted_ && block.problem.empty())
        block.text = withNote(block.text, noteOf(*result->scene, index), *result);
    return block;
}

std::string ExportController::noteOf(const Scene& scene, std::size_t isosurface) const {
    const auto proof = proofs_ ? proofs_->proofOf(scene, isosurface) : nullptr;
    const std::string note =
        proof ? proofNote(proof->bracket(), scene.isosurfaces[isosurface].shape->rootSettings().accuracy,
                          presentCamera(), QCoreApplication::applicationVersion().toStdString())
              : std::string();
    if (note.empty()) parts_.notices->tell(tr("No bound is proven (so far): there is no comment of it."));
    return note;
}

QString ExportController::sceneText() const {
    const auto result = presentResult();
    if (!result || result->sources->size() == 0) return {};
    const std::string text((*result->sources)[0].text());
    const QSize size = parts_.viewport->size();
    return QString::fromStdString(
        isoscope::exportScene(*result->scene, presentCamera(), text, size.width(), size.height()));
}

Camera ExportController::presentCamera() const {
    const QSize size = parts_.viewport->size();
    return fittedCamera(parts_.viewport->camera(), size.width(), size.height());
}

bool ExportController::exportsVirtualight(const QString& title, const QString& suffix) {
    const auto result = presentResult();
    if (!result || result->notation != Notation::virtualight || result->sources->size() == 0) return false;
    const QString path = chooseFile(title, suffix);
    if (path.isEmpty()) return true;
    const std::string stem = QFileInfo(path).completeBaseName().toStdString();
    const VirtualightExport made = suffix == QLatin1String(".inc")
                                       ? virtualightObjects(*result, stem)
                                       : exportVirtualight(*result, presentCamera(), stem);
    const std::filesystem::path file = QFile::encodeName(path).toStdString();
    writeGuarded(path, made.imagesBeside(file), [made, file] { return made.write(file); });
    return true;
}

void ExportController::copyIsosurface() {
    const IsosurfaceExport block = isosurface();
    if (!block.problem.empty()) {
        parts_.notices->tell(QString::fromStdString(block.problem));
        return;
    }
    QGuiApplication::clipboard()->setText(QString::fromStdString(block.text));
    emit said(tr("The isosurface is on the clipboard."));
}

void ExportController::exportInclude() {
    if (exportsVirtualight(tr("Write the objects"), QStringLiteral(".inc"))) return;
    const IsosurfaceExport block = isosurface();
    if (!block.problem.empty())
        parts_.notices->tell(QString::fromStdString(block.problem));
    else
        writeText(tr("Write the isosurface"), QStringLiteral(".inc"), QString::fromStdString(block.text));
}

void ExportController::exportScene() {
    if (exportsVirtualight(tr("Write a scene for POV-Ray"), QStringLiteral(".pov"))) return;
    const QString text = sceneText();
    if (text.isEmpty())
        emit said(tr("There is no scene to write yet."));
    else
        writeText(tr("Write a scene for POV-Ray"), QStringLiteral(".pov"), text);
}

void ExportController::exportVirtualightText() {
    const auto result = presentResult();
    if (!result || result->sources->size() == 0) {
        emit said(tr("There is no scene to write yet."));
        return;
    }
    const bool already = result->notation == Notation::virtualight;
    const std::string text =
        already ? std::string((*result->sources)[0].text()) : virtualightText(*result->scene);
    writeText(tr("Write the objects for VirtuaLight"), QStringLiteral(".vl"), QString::fromStdString(text));
}

QString ExportController::suggestedFile(const QString& suffix) const {
    const QFileInfo file(parts_.document->filePath());
    if (parts_.document->filePath().isEmpty()) return pathInDocuments(QStringLiteral("scene") + suffix);
    // Never the document's own file.
    const QString base = file.path() + QLatin1Char('/') + file.completeBaseName();
    return base + suffix == file.filePath() ? base + QStringLiteral("-export") + suffix : base + suffix;
}

QString ExportController::chooseFile(const QString& title, const QString& suffix) {
    const QString filter = suffix == QLatin1String(".vl") ? tr("VirtuaLight files (*%1);;All files (*)")
                                                          : tr("POV-Ray files (*%1);;All files (*)");
    return chooseSavePath(parts_.window, title, suggestedFile(suffix), filter.arg(suffix), suffix.mid(1));
}

void ExportController::writeText(const QString& title, const QString& suffix, const QString& text) {
    const QString path = chooseFile(title, suffix);
    if (path.isEmpty()) return;
    writeGuarded(path, {}, [path, text] {
        const std::string reason =
            writeWhole(QFile::encodeName(path).toStdString(), markedExport(text.toStdString()));
        return reason.empty() ? reason : path.toStdString() + " cannot be written: " + reason;
    });
}

void ExportController::writeGuarded(const QString& path, const std::vector<std::filesystem::path>& images,
                                    const std::function<std::string()>& write) {
    const std::filesystem::path file = QFile::encodeName(path).toStdString(),
                                own = QFile::encodeName(parts_.document->filePath()).toStdString();
    std::error_code failed;
    if (!own.empty() && std::filesystem::equivalent(file, own, failed))
        return parts_.notices->tell(
            tr("%1 is the scene itself; an export needs a name of its own.").arg(path));
    const auto act = [this, path, write] {
        const std::string problem = write();
        if (problem.empty())
            emit said(tr("Written: %1").arg(path));
        else
            parts_.notices->tell(QString::fromStdString(problem));
    };
    QStringList foreign;
    if (!whyNotReplaced(file, OutputKind::scene).empty()) foreign << path;
    for (const std::filesystem::path& image : images)
        if (!whyNotReplaced(image, OutputKind::picture).empty())
            foreign << QString::fromStdString(image.string());
    if (foreign.isEmpty()) return act();
    parts_.notices->ask(tr("No export of Isoscope made %1.").arg(foreign.join(QStringLiteral(", "))),
                        {{tr("Replace"), tr("What stands in the file now is lost"), act},
                         {tr("Keep"), tr("Write nothing"), {}}},
                        QStringLiteral("export"));
}

void ExportController::exportImage() {
    const auto& scene = parts_.viewport->scene();
    if (!scene) {
        emit said(tr("There is no picture to export yet."));
        return;
    }
    auto* dialog = new ImageExportDialog(scene, parts_.viewport->camera(),
                                         suggestedFile(QStringLiteral(".png")), parts_.window, queue_);
    dialog->setRootFinder(parts_.viewport->rootFinder());
    const QSize size = parts_.viewport->size();
    const int width = QSettings().value(exportSizeKey).toSize().isEmpty() ? 1600 : exportSize().width();
    dialog->setPictureSize({width, std::max(1, width * size.height() / std::max(1, size.width()))});
    connect(dialog, &ImageExportDialog::started, this, [this](QSize chosen) {
        QSettings().setValue(exportSizeKey, chosen);
        emit exportSizeChanged(chosen);
    });
    connect(dialog, &ImageExportDialog::enqueued, this, [this](int number) {
        told_ << number;
        if (queueWindow_) queueWindow_->raise();
    });
    dialog->show();
}

void ExportController::tellEnd(int number) {
    if (!told_.removeOne(number)) return;
    const QueuedPicture picture = queue_->picture(number);
    if (picture.state == QueuedPicture::State::written)
        emit said(tr("Written: %1").arg(picture.file));
    else if (picture.state == QueuedPicture::State::failed)
        parts_.notices->tell(picture.problem);
}

void ExportController::showQueue() {
    if (!queueWindow_) {
        queueWindow_ = new PictureQueueWindow(queue_, parts_.window);
        queueWindow_->setAttribute(Qt::WA_DeleteOnClose);
    }
    queueWindow_->show();
    queueWindow_->raise();
    queueWindow_->activateWindow();
}

PovrayTask ExportController::povrayTask(const RenderRequest& shown) const {
    PovrayTask task;
    const auto result = presentResult();
    if (!result || result->sources->size() == 0) {
        task.problem = tr("There is no text that POV-Ray could draw.");
    } else if (result->notation != Notation::povray) {
        task.problem = tr("POV-Ray reads its own language only; File ▸ Export writes it.");
    } else if (const std::string reason = whyNotForPovray(result->writtenFiles); !reason.empty()) {
        task.problem = tr("Not given to POV-Ray: %1.").arg(QString::fromStdString(reason));
    } else {
        task.order.text =
            isoscope::exportScene(*result->scene, shown.camera, std::string((*result->sources)[0].text()),
                                  shown.width, shown.height);
        task.order.width = shown.width;
        task.order.height = shown.height;
        if (const QString path = parts_.document->filePath(); !path.isEmpty())
            task.order.folder = QFile::encodeName(QFileInfo(path).absolutePath()).toStdString();
        for (const Diagnostic& diagnostic : result->diagnostics)
            task.leavesOut = task.leavesOut || diagnostic.severity == Severity::leftOut;
    }
    return task;
}

void ExportController::copyPicture() {
    const QImage picture = parts_.viewport->pictureWithMarks();
    if (picture.isNull()) {
        emit said(tr("There is no picture to copy yet."));
        return;
    }
    QGuiApplication::clipboard()->setMimeData(pictureMimeData(picture).release());
    emit said(tr("The picture is on the clipboard."));
}

void ExportController::dragPicture() {
    const QImage picture = parts_.viewport->pictureWithMarks();
    if (picture.isNull()) return;
    const QString name = QFileInfo(suggestedFile(QStringLiteral(".png"))).completeBaseName();
    auto* drag = new QDrag(parts_.viewport);
    drag->setMimeData(pictureFileMimeData(picture, name).release());
    constexpr int thumbnail = 128;
    drag->setPixmap(QPixmap::fromImage(
        picture.scaled(thumbnail, thumbnail, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    drag->exec(Qt::CopyAction);
}

void ExportController::exportAnimation() {
    const auto result = presentResult();
    if (!result || result->sources->size() == 0 || !result->ok())
        return parts_.notices->tell(tr("The text has errors, or there is none."));
    const Timeline timeline = timelineOf(parts_.editor->utf8());
    if (!timeline.any() || result->notation != Notation::povray)
        return parts_.notices->tell(tr("There is no timeline to write. The panel “Timeline” makes one."));
    const QString title = tr("Write an animation for POV-Ray"), suffix = QStringLiteral(".pov");
    const QString path = chooseFile(title, suffix);
    if (path.isEmpty()) return;
    const std::string scene = markedExport(animationScene(*result, timeline));
    const std::filesystem::path file = QFile::encodeName(path).toStdString();
    std::filesystem::path settings = file;
    settings.replace_extension(".ini");
    if (!whyNotReplaced(settings, OutputKind::renderSettings).empty())
        return parts_.notices->tell(
            tr("%1 is no export of Isoscope; choose another name.").arg(QString::fromStdString(settings)));
    const QSize size = exportSize();
    const std::string lines =
        animationSettings(timeline, file.filename().string(), size.width(), size.height());
    writeGuarded(path, {}, [=] {
        for (const auto& [one, content] : {std::pair(file, scene), std::pair(settings, lines)})
            if (const std::string reason = writeWhole(one, content); !reason.empty())
                return one.string() + " cannot be written: " + reason;
        return std::string();
    });
}

void ExportController::exportFrames() {
    const auto result = presentResult();
    if (!result || !parts_.viewport->scene() || !result->ok())
        return parts_.notices->tell(tr("The text has errors, or there is none."));
    const Timeline timeline = timelineOf(parts_.editor->utf8());
    FrameOrder order;
    order.text = parts_.editor->utf8();
    order.options = withoutStop(result->options);
    order.frames = timeline.frames;
    order.frames.beginning = QFile::encodeName(suggestedFile(QString())).toStdString();
    order.rootFinder = parts_.viewport->rootFinder();
    // Without keys of the camera the view is what a person chose, if they did.
    if (parts_.viewport->viewMoved() && !Animation(timeline, {}).movesCamera())
        order.view = parts_.viewport->camera();
    // As wide as the last image, in the proportions of the window.
    const QSize shown = parts_.viewport->size();
    order.width = exportSize().width();
    order.height = std::max(1, order.width * shown.height() / std::max(1, shown.width()));
    (new AnimationExportDialog(order, timeline.rate, parts_.window))->show();
}

void ExportController::exportMesh() {
    const auto& scene = parts_.viewport->scene();
    if (!scene || placedIsosurfaces(*scene).empty()) {
        emit said(tr("There is no isosurface to export."));
        return;
    }
    auto* dialog = new MeshExportDialog(scene, suggestedFile(QStringLiteral(".stl")), parts_.window);
    dialog->show();
}

QSize ExportController::exportSize() {
    const QSize stored = QSettings().value(exportSizeKey).toSize();
    return stored.isEmpty() ? QSize(800, 600) : stored;
}

void ExportController::writeView() {
    if (!parts_.viewport->scene()) {
        emit said(tr("There is no view to write yet."));
        return;
    }
    viewWaits_ = true;
    if (parts_.session->result() && parts_.session->resultRevision() == parts_.editor->revision())
        writeViewNow();
    else
        parts_.session->setText(parts_.editor->utf8(), parts_.editor->revision(), SceneSession::When::now);
}

void ExportController::writeViewNow() {
    viewWaits_ = false;
    const ParseResult& result = *parts_.session->result();
    if (result.notation != Notation::povray) {
        emit said(tr("A camera can only be written into a text for POV-Ray."));
        return;
    }
    const Camera& view = parts_.viewport->camera();
    const std::optional<SourceRange>& old = result.scene->cameraRange;
    if (old && old->file != 0) {
        emit said(tr("The camera stands in an include file, which is not changed."));
        return;
    }
    const auto length = static_cast<std::uint32_t>(parts_.editor->length());
    const std::string block = old ? cameraText(result.sources->slice(*old), result.scene->camera, view)
                                  : '\n' + cameraBlock(view) + '\n';
    if (!parts_.editor->replaceRange(old.value_or(SourceRange{0, length, length}),
                                     QString::fromStdString(block)))
        return;
    parts_.viewport->adoptView();
    emit said(tr("The view is the camera of the text now."));
}

}  // namespace isoscope

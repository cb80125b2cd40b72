// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mesh/mesh_export_dialog.h"

#include <array>
#include <cmath>
#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>

#include "core/exchange/output_guard.h"
#include "core/mesh/mesh_text.h"
#include "core/mesh/scene_mesh.h"
#include "core/text/whole_file.h"
#include "widgets/document/save_path.h"
#include "widgets/icons.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

struct FormatChoice {
    const char* suffix;
    const char* text;
};
const std::array<FormatChoice, 6> formatChoices{{{"stl", "STL, for printers"},
                                                 {"3mf", "3MF, for printers, with colours"},
                                                 {"obj", "OBJ, with colours"},
                                                 {"ply", "PLY, with colours"},
                                                 {"glb", "glTF, with colours"},
                                                 {"inc", "mesh2 of POV-Ray, with colours"}}};

int choiceOf(const QString& file) {
    const QString suffix = QFileInfo(file.trimmed()).suffix().toLower();
    for (std::size_t i = 0; i < formatChoices.size(); ++i)
        if (suffix == QLatin1String(formatChoices[i].suffix)) return static_cast<int>(i);
    return -1;
}

std::filesystem::path pathOf(const QString& file) { return QFile::encodeName(file.trimmed()).toStdString(); }

}  // namespace

MeshExportDialog::MeshExportDialog(std::shared_ptr<const Scene> scene, const QString& suggestedFile,
                                   QWidget* parent)
    : QDialog(parent), scene_(std::move(scene)) {
    setWindowTitle(tr("Export mesh"));
    setAttribute(Qt::WA_DeleteOnClose);
    buildControls(suggestedFile);
    timer_.setInterval(timing::drainInterval);
    connect(&timer_, &QTimer::timeout, this,
            [this] { progress_->setValue(static_cast<int>(1000 * done_.load())); });
    setRunning(false);
}

MeshExportDialog::~MeshExportDialog() { stopSource_.request_stop(); }

void MeshExportDialog::buildControls(const QString& suggestedFile) {
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    layout->addLayout(form);
    format_ = new QComboBox;
    for (const FormatChoice& choice : formatChoices) format_->addItem(tr(choice.text));
    format_->setToolTip(tr("The notation of the file; its ending follows"));
    format_->setAccessibleName(tr("Format"));
    form->addRow(tr("Format"), format_);
    tolerance_ = new QLineEdit;
    tolerance_->setPlaceholderText(tr("a 500th of the container"));
    tolerance_->setToolTip(tr("How far mesh and surface may be apart, in units of the scene"));
    tolerance_->setAccessibleName(tr("Tolerance"));
    form->addRow(tr("Tolerance"), tolerance_);
    colors_ = new QCheckBox(tr("Colours of the texture"));
    colors_->setChecked(true);
    colors_->setToolTip(tr("A colour for each vertex, where the format has colours"));
    form->addRow(QString(), colors_);

    file_ = new QLineEdit(suggestedFile);
    file_->setMinimumWidth(320);
    file_->setToolTip(tr("The file to write"));
    file_->setAccessibleName(tr("File"));
    auto* browse = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Choose…"));
    browse->setToolTip(tr("Choose the file"));
    connect(browse, &QPushButton::clicked, this, &MeshExportDialog::chooseFile);
    auto* files = new QHBoxLayout;
    files->addWidget(file_, 1);
    files->addWidget(browse);
    form->addRow(tr("File"), files);
    connect(format_, &QComboBox::activated, this, &MeshExportDialog::followFormat);

    progress_ = new QProgressBar;
    progress_->setRange(0, 1000);
    progress_->setValue(0);
    progress_->setAccessibleName(tr("Progress"));
    layout->addWidget(progress_);
    message_ = new QLabel;
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    message_->setAccessibleDescription(tr("Result"));
    layout->addWidget(message_);
    connect(file_, &QLineEdit::textChanged, this, [this] {
        if (const int choice = choiceOf(file_->text()); choice >= 0) format_->setCurrentIndex(choice);
        ask(false);
    });
    buildButtons();
    layout->addStretch(1);
}

void MeshExportDialog::buildButtons() {
    auto* buttons = new QHBoxLayout;
    static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
    buttons->addStretch(1);
    start_ = new QPushButton(themeIcon(QStringLiteral("document-save")), tr("Export"));
    start_->setDefault(true);
    start_->setToolTip(tr("Make the mesh and write it"));
    connect(start_, &QPushButton::clicked, this, &MeshExportDialog::start);
    stop_ = new QPushButton(themeIcon(QStringLiteral("process-stop")), tr("Stop"));
    stop_->setToolTip(tr("Stop; no file is written"));
    connect(stop_, &QPushButton::clicked, this, &MeshExportDialog::stop);
    auto* close = new QPushButton(tr("Close"));
    close->setToolTip(tr("Close; a running export is stopped"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    reveal_ = new QPushButton(tr("Show Folder"));
    reveal_->setToolTip(tr("Open the folder that holds the mesh"));
    connect(reveal_, &QPushButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(written_).absolutePath())); });
    reveal_->hide();
    for (QPushButton* button : {reveal_, start_, stop_, close}) buttons->addWidget(button);
}

void MeshExportDialog::setFile(const QString& file) { file_->setText(file); }

void MeshExportDialog::setTolerance(const QString& tolerance) { tolerance_->setText(tolerance); }

void MeshExportDialog::followFormat() {
    const QString suffix =
        QLatin1String(formatChoices[static_cast<std::size_t>(format_->currentIndex())].suffix);
    const QFileInfo file(file_->text().trimmed());
    if (file.fileName().isEmpty() || file.suffix().toLower() == suffix) return;
    const QString base = choiceOf(file_->text()) >= 0 ? file.completeBaseName() : file.fileName();
    const QString folder =
        file_->text().contains(QLatin1Char('/')) ? file.path() + QLatin1Char('/') : QString();
    file_->setText(folder + base + QLatin1Char('.') + suffix);
}

void MeshExportDialog::chooseFile() {
    const QString suffix =
        QLatin1String(formatChoices[static_cast<std::size_t>(format_->currentIndex())].suffix);
    const QString file = chooseSavePath(this, tr("Export mesh"), file_->text(),
                                        tr("Meshes (*.stl *.3mf *.obj *.ply *.glb *.inc)"), suffix);
    if (!file.isEmpty()) file_->setText(file);
}

void MeshExportDialog::ask(bool toReplace) {
    asking_ = toReplace;
    start_->setText(toReplace ? tr("Replace") : tr("Export"));
    // A second Enter must not answer what was not read.
    start_->setDefault(!toReplace);
    start_->setAutoDefault(!toReplace);
    message_->setText(toReplace
                          ? tr("%1 exists already. Replace it?").arg(QFileInfo(file_->text()).fileName())
                          : QString());
    reveal_->hide();
}

void MeshExportDialog::setRunning(bool running) {
    running_ = running;
    for (QWidget* widget : std::initializer_list<QWidget*>{format_, tolerance_, colors_, file_, start_})
        widget->setEnabled(!running);
    stop_->setEnabled(running);
    running ? timer_.start() : timer_.stop();
}

bool MeshExportDialog::ready() {
    if (file_->text().trimmed().isEmpty()) {
        message_->setText(tr("Please choose a file."));
        return false;
    }
    if (choiceOf(file_->text()) < 0) followFormat();
    bool isNumber = true;
    const QString tolerance = tolerance_->text().trimmed();
    if (!tolerance.isEmpty() && !(QLocale::c().toDouble(tolerance, &isNumber) > 0 && isNumber)) {
        message_->setText(tr("The tolerance is a positive number, or empty."));
        return false;
    }
    if (const std::string reason = whyNotReplaced(pathOf(file_->text()), OutputKind::mesh); !reason.empty()) {
        ask(false);
        message_->setText(tr("The file exists and is no mesh of Isoscope: it is not replaced."));
        return false;
    }
    if (!QFileInfo::exists(file_->text().trimmed()) || asking_) return true;
    ask(true);
    return false;
}

void MeshExportDialog::start() {
    if (running_ || !scene_ || !ready()) return;
    ask(false);
    const std::optional<MeshFormat> format = meshFormat(pathOf(file_->text()));
    if (!format) return;
    const QString tolerance = tolerance_->text().trimmed();
    done_ = 0;
    progress_->setValue(0);
    message_->setText(tr("Looking for the surface…"));
    setRunning(true);
    submit(tolerance.isEmpty() ? 0 : QLocale::c().toDouble(tolerance), *format);
}

void MeshExportDialog::submit(double tolerance, MeshFormat format) {
    stopSource_ = std::stop_source();
    SceneMeshSettings settings;
    settings.tolerance = tolerance;
    settings.colors = colors_->isChecked();
    // A person waits for it, who has seen the scene and can stop it.
    settings.memory = 4'000'000'000;
    settings.bytesOfTriangle = bytesOfTriangle(format);
    const QString file = file_->text().trimmed();
    worker_.submit([this, settings, format, file, scene = scene_, stop = stopSource_.get_token()](auto) {
        SceneMesh made = meshScene(
            *scene, placedIsosurfaces(*scene), settings, [this](double done) { done_ = done; }, stop);
        std::string problem = made.problem;
        if (problem.empty()) {
            const MeshFile written = meshFile(std::move(made.mesh), format);
            problem = written.problem;
            if (problem.empty() && !stop.stop_requested())
                if (const std::string reason = writeWhole(pathOf(file), written.content); !reason.empty())
                    problem = file.toStdString() + " could not be written: " + reason;
        }
        const bool stopped = stop.stop_requested();
        const QString error = stopped           ? tr("Stopped; nothing was written.")
                              : problem.empty() ? QString()
                                                : tr("No mesh: %1.").arg(QString::fromStdString(problem));
        const QString text = QString::fromStdString(meshText(made.report));
        QMetaObject::invokeMethod(
            this, [this, error, text] { report(error, text); }, Qt::QueuedConnection);
    });
}

void MeshExportDialog::stop() {
    if (!running_) return;
    stopSource_.request_stop();
    stop_->setEnabled(false);
    message_->setText(tr("Stopping…"));
}

void MeshExportDialog::report(const QString& error, const QString& text) {
    setRunning(false);
    progress_->setValue(error.isEmpty() ? 1000 : 0);
    written_ = error.isEmpty() ? file_->text().trimmed() : QString();
    message_->setText(error.isEmpty() ? tr("Written: %1").arg(written_) + QLatin1Char('\n') + text.trimmed()
                                      : error);
    reveal_->setVisible(error.isEmpty());
    adjustSize();
    emit finished(file_->text().trimmed(), error);
}

void MeshExportDialog::closeEvent(QCloseEvent* event) {
    stopSource_.request_stop();
    QDialog::closeEvent(event);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/animation_export_dialog.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "core/animation/animation_export.h"
#include "core/exchange/output_guard.h"
#include "widgets/icons.h"

namespace isoscope {

namespace {

/// Of a frame, which is drawn as a whole.
constexpr int longestSide = 16384;
constexpr qint64 mostPixels = 100'000'000;

constexpr int filmPatience = 3000;  ///< milliseconds that ffmpeg has to end when it is stopped

QString fileOf(const FrameSequence& frames, int frame) {
    return QFile::decodeName(frames.file(frame).string().c_str());
}

}  // namespace

AnimationExportDialog::AnimationExportDialog(const FrameOrder& order, double rate, QWidget* parent)
    : QDialog(parent), order_(order), rate_(rate) {
    setWindowTitle(tr("Frames and film"));
    setAttribute(Qt::WA_DeleteOnClose);
    buildFields();
    buildButtons();
    connect(&writer_, &FrameWriter::progressed, progress_, &QProgressBar::setValue);
    connect(&writer_, &FrameWriter::finished, this, [this](const QString& error) {
        if (!error.isEmpty()) return report(error);
        makesFilm_->isChecked() ? makeFilm() : report({});
    });
    connect(&film_, &QProcess::readyReadStandardOutput, this, &AnimationExportDialog::readFilmProgress);
    connect(&film_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) report(tr("ffmpeg cannot be started."));
    });
    connect(&film_, &QProcess::finished, this, [this](int status, QProcess::ExitStatus ending) {
        if (stopped_) return report(QLatin1String(FrameWriter::stopped));
        if (ending == QProcess::NormalExit && status == 0) return report({});
        const QString said = QString::fromLocal8Bit(film_.readAllStandardError()).trimmed();
        report(tr("ffmpeg made no film: %1").arg(said.section('\n', -1)));
    });
    setRunning(false);
}

AnimationExportDialog::~AnimationExportDialog() {
    film_.disconnect(this);
    if (film_.state() == QProcess::NotRunning) return;
    film_.kill();
    film_.waitForFinished(filmPatience);
}

QString AnimationExportDialog::filmProgram() {
    return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

void AnimationExportDialog::buildFields() {
    auto* form = new QFormLayout;
    auto* sizes = new QHBoxLayout;
    const auto box = [&](int value, const QString& name) {
        auto* made = new QSpinBox(this);
        made->setRange(1, longestSide);
        made->setValue(value);
        made->setSuffix(tr(" px"));
        made->setAccessibleName(name);
        made->setToolTip(name);
        sizes->addWidget(made);
        return made;
    };
    width_ = box(order_.width, tr("Width of the frames"));
    sizes->addWidget(new QLabel(QStringLiteral("×"), this));
    height_ = box(order_.height, tr("Height of the frames"));
    sizes->addStretch(1);
    form->addRow(tr("Size"), sizes);
    antialias_ = new QCheckBox(tr("Smooth edges (anti-aliasing)"), this);
    antialias_->setChecked(order_.antialias);
    antialias_->setToolTip(tr("Several rays for pixels on edges; takes longer"));
    form->addRow(QString(), antialias_);
    beginning_ = new QLineEdit(QFile::decodeName(order_.frames.beginning.c_str()), this);
    beginning_->setMinimumWidth(320);
    beginning_->setAccessibleName(tr("How the names of the pictures begin"));
    connect(beginning_, &QLineEdit::textChanged, this, [this] { ask(false); });
    auto* choose = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Folder…"), this);
    choose->setToolTip(tr("Choose the folder of the pictures"));
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, &AnimationExportDialog::chooseFolder);
    auto* names = new QHBoxLayout;
    names->addWidget(beginning_, 1);
    names->addWidget(choose);
    form->addRow(tr("Files"), names);
    beginning_->setToolTip(tr("The number of the frame and .png follow"));
    makesFilm_ = new QCheckBox(tr("Make a film of them, %1 frames per second").arg(rate_), this);
    const bool possible = !filmProgram().isEmpty();
    makesFilm_->setEnabled(possible);
    makesFilm_->setToolTip(possible ? tr("An .mp4 file beside the pictures, made by ffmpeg")
                                    : tr("ffmpeg is not installed"));
    form->addRow(QString(), makesFilm_);
    if (!possible) makesFilm_->setText(makesFilm_->text() + tr(" (ffmpeg is not installed)"));
    setLayout(new QVBoxLayout);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
}

void AnimationExportDialog::buildButtons() {
    auto* column = static_cast<QVBoxLayout*>(layout());
    progress_ = new QProgressBar(this);
    progress_->setRange(0, order_.frames.last - order_.frames.first + 1);
    progress_->setFormat(tr("%v of %m frames"));
    progress_->setAccessibleName(tr("Progress"));
    progress_->setValue(0);
    column->addWidget(progress_);
    message_ = new QLabel(this);
    message_->setWordWrap(true);
    message_->setAccessibleDescription(tr("Result"));
    column->addWidget(message_);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    const auto add = [&](const QString& text, const QString& help, auto act) {
        auto* button = new QPushButton(text, this);
        button->setToolTip(help);
        connect(button, &QPushButton::clicked, this, act);
        buttons->addWidget(button);
        return button;
    };
    start_ = add(tr("Draw"), tr("Draw all frames and write them"), &AnimationExportDialog::start);
    start_->setDefault(true);
    stop_ = add(tr("Stop"), tr("Stop; frames that are written stay"), &AnimationExportDialog::stop);
    add(tr("Close"), tr("Close; drawing is stopped"), &QWidget::close);
    column->addLayout(buttons);
}

void AnimationExportDialog::chooseFolder() {
    const QFileInfo present(beginning_->text());
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Folder of the pictures"), present.path());
    if (!folder.isEmpty()) beginning_->setText(QDir(folder).filePath(present.fileName()));
}

void AnimationExportDialog::ask(bool toReplace) {
    asking_ = toReplace;
    start_->setText(toReplace ? tr("Replace") : tr("Draw"));
    // A second Enter must not answer what was not read.
    start_->setDefault(!toReplace);
    start_->setAutoDefault(!toReplace);
    message_->setText(toReplace ? tr("There are frames with such names already. Replace them?") : QString());
}

QString AnimationExportDialog::filmFile() const { return beginning_->text() + QStringLiteral(".mp4"); }

bool AnimationExportDialog::filesExist() const {
    for (int frame = order_.frames.first; frame <= order_.frames.last; ++frame)
        if (QFile::exists(fileOf(order_.frames, frame))) return true;
    return makesFilm_->isChecked() && QFile::exists(filmFile());
}

QString AnimationExportDialog::problem() const {
    if (QFileInfo(beginning_->text()).fileName().isEmpty()) return tr("Please choose how the names begin.");
    if (static_cast<qint64>(width_->value()) * height_->value() > mostPixels)
        return tr("That is more than %1 million pixels.").arg(mostPixels / 1'000'000);
    for (int frame = order_.frames.first; frame <= order_.frames.last; ++frame)
        if (!whyNotReplaced(order_.frames.file(frame), OutputKind::picture).empty())
            return tr("%1 is no PNG picture: it is not replaced.").arg(fileOf(order_.frames, frame));
    return {};
}

void AnimationExportDialog::start() {
    if (running()) return;
    order_.width = width_->value();
    order_.height = height_->value();
    order_.antialias = antialias_->isChecked();
    order_.frames.beginning = QFile::encodeName(beginning_->text()).toStdString();
    if (const QString reason = problem(); !reason.isEmpty()) {
        ask(false);
        return message_->setText(reason);
    }
    if (!asking_ && filesExist()) return ask(true);
    ask(false);
    const QString folder = QFileInfo(beginning_->text()).path();
    if (!QDir().mkpath(folder)) return message_->setText(tr("%1 cannot be made.").arg(folder));
    stopped_ = false;
    progress_->setMaximum(order_.frames.last - order_.frames.first + 1);
    progress_->setFormat(tr("%v of %m frames"));
    progress_->setValue(0);
    message_->setText(tr("Drawing…"));
    setRunning(true);
    writer_.start(order_);
}

void AnimationExportDialog::stop() {
    stopped_ = true;
    writer_.stop();
    if (film_.state() != QProcess::NotRunning) film_.kill();
}

void AnimationExportDialog::makeFilm() {
    message_->setText(tr("Making the film…"));
    progress_->setFormat(tr("film: %v of %m frames"));
    progress_->setValue(0);
    QStringList arguments;
    for (const std::string& one :
         filmArguments(order_.frames, rate_, QFile::encodeName(filmFile()).toStdString()))
        arguments << QFile::decodeName(one.c_str());
    film_.setStandardInputFile(QProcess::nullDevice());
    film_.start(filmProgram(), arguments);
}

void AnimationExportDialog::readFilmProgress() {
    while (film_.canReadLine()) {
        const QByteArray line = film_.readLine().trimmed();
        if (line.startsWith("frame=")) progress_->setValue(line.mid(6).toInt());
    }
}

void AnimationExportDialog::setRunning(bool running) {
    for (QWidget* widget : std::initializer_list<QWidget*>{width_, height_, antialias_, beginning_, start_})
        widget->setEnabled(!running);
    makesFilm_->setEnabled(!running && !filmProgram().isEmpty());
    stop_->setEnabled(running);
}

void AnimationExportDialog::report(const QString& error) {
    setRunning(false);
    const bool stopped = error == QLatin1String(FrameWriter::stopped);
    message_->setText(
        stopped ? tr("Stopped; the frames that are written stay.")
        : error.isEmpty()
            ? tr("Written: %1")
                  .arg(makesFilm_->isChecked() ? filmFile() : fileOf(order_.frames, order_.frames.last))
            : error);
    emit finished(error);
}

void AnimationExportDialog::closeEvent(QCloseEvent* event) {
    stop();
    QDialog::closeEvent(event);
}

}  // namespace isoscope

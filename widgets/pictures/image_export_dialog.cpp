// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pictures/image_export_dialog.h"

#include <algorithm>
#include <cmath>
#include <QBoxLayout>
#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QUrl>

#include "core/exchange/output_guard.h"
#include "widgets/icons.h"
#include "widgets/document/save_path.h"
#include "widgets/pictures/picture_forecast.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// Nothing stands there, or a picture.
bool isOurs(const QString& file) {
    return whyNotReplaced(QFile::encodeName(file.trimmed()).toStdString(), OutputKind::picture).empty();
}

QSpinBox* sizeBox(int value, const QString& name) {
    auto* box = new QSpinBox;
    box->setRange(1, ImageExportDialog::longestSide);
    box->setValue(value);
    box->setSuffix(QObject::tr(" px"));
    box->setToolTip(name);
    box->setAccessibleName(name);
    return box;
}

}  // namespace

ImageExportDialog::ImageExportDialog(std::shared_ptr<const Scene> scene, const Camera& camera,
                                     const QString& suggestedFile, QWidget* parent, PictureQueue* queue)
    : QDialog(parent),
      scene_(std::move(scene)),
      camera_(camera),
      queue_(queue ? queue : new PictureQueue(this)) {
    setWindowTitle(tr("Export image"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    layout->addLayout(form);
    buildPicture(form);
    buildFile(form, suggestedFile);
    progress_ = new QProgressBar;
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress"));
    layout->addWidget(progress_);
    message_ = new QLabel;
    message_->setWordWrap(true);
    message_->setAccessibleDescription(tr("Result"));
    layout->addWidget(message_);
    buildButtons(layout);
    connect(file_, &QLineEdit::textChanged, this, [this] {
        ask(false);
        showFormat();
    });
    connect(queue_, &PictureQueue::changed, this, &ImageExportDialog::showProgress);
    connect(queue_, &PictureQueue::ended, this, &ImageExportDialog::report);
    showFormat();
    setRunning(false);
}

ImageExportDialog::~ImageExportDialog() = default;

void ImageExportDialog::buildPicture(QFormLayout* form) {
    width_ = sizeBox(1600, tr("Width of the image"));
    height_ = sizeBox(1200, tr("Height of the image"));
    auto* sizes = new QHBoxLayout;
    sizes->addWidget(width_);
    sizes->addWidget(new QLabel(QStringLiteral("×")));
    sizes->addWidget(height_);
    sizes->addStretch(1);
    form->addRow(tr("Size"), sizes);
    proportions_ = new QCheckBox(tr("Keep the proportions"));
    proportions_->setChecked(true);
    proportions_->setToolTip(
        tr("Width and height follow each other, so that the picture shows what the window shows"));
    connect(proportions_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) ratio_ = static_cast<double>(width_->value()) / height_->value();
    });
    for (QSpinBox* box : {width_, height_})
        connect(box, &QSpinBox::valueChanged, this, [this, box] { keepProportions(box); });
    form->addRow(QString(), proportions_);
    antialias_ = new QCheckBox(tr("Smooth edges (anti-aliasing)"));
    antialias_->setChecked(true);
    antialias_->setToolTip(tr("Several rays for pixels on edges; takes longer"));
    form->addRow(QString(), antialias_);
    transparent_ = new QCheckBox(tr("Transparent background"));
    transparent_->setToolTip(
        tr("Leave out background and sky where no object hides them; the file says how much shows through"));
    form->addRow(QString(), transparent_);
    for (QCheckBox* box : {antialias_, transparent_})
        connect(box, &QCheckBox::toggled, this, &ImageExportDialog::forecastAgain);
    time_ = new QLabel;
    time_->setTextFormat(Qt::PlainText);
    time_->setToolTip(
        tr("How long the picture will take with all cores of this computer: squares of it are drawn to find "
           "out. POV-Ray's time follows from the function and what its method evaluates."));
    time_->setAccessibleDescription(tr("How long the picture will take"));
    form->addRow(tr("Time"), time_);
    forecast_ = new PictureForecast(this);
    connect(forecast_, &PictureForecast::changed, this, [this] { time_->setText(forecast_->text()); });
}

void ImageExportDialog::setRootFinder(RootFinder finder) {
    rootFinder_ = finder;
    forecastAgain();
}

void ImageExportDialog::forecastAgain() {
    if (!running()) forecast_->follow(request());
}

void ImageExportDialog::buildFile(QFormLayout* form, const QString& suggestedFile) {
    file_ = new QLineEdit(suggestedFile);
    file_->setMinimumWidth(320);
    file_->setToolTip(tr("The file to write: .png for an image, .exr for OpenEXR with layers"));
    file_->setAccessibleName(tr("File"));
    auto* browse = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Choose…"));
    browse->setToolTip(tr("Choose the file"));
    connect(browse, &QPushButton::clicked, this, &ImageExportDialog::chooseFile);
    auto* files = new QHBoxLayout;
    files->addWidget(file_, 1);
    files->addWidget(browse);
    form->addRow(tr("File"), files);
    depth_ = new QComboBox;
    depth_->addItem(tr("PNG, 8 bits a channel"), 8);
    depth_->addItem(tr("PNG, 16 bits a channel"), 16);
    depth_->setToolTip(tr("16 bits keep steps of light that 8 bits round away, in files of twice the size"));
    layers_ = new QLabel(tr("OpenEXR: colour, opacity, distance, normals, verdicts"));
    layers_->setToolTip(tr("Channels R, G, B, A; Z; N.X, N.Y, N.Z; verdict, with the exact root finder"));
    layers_->setMinimumHeight(depth_->sizeHint().height());
    auto* formats = new QHBoxLayout;
    formats->addWidget(depth_);
    formats->addWidget(layers_);
    formats->addStretch(1);
    form->addRow(tr("Format"), formats);
    if (auto* label = qobject_cast<QLabel*>(form->labelForField(formats))) label->setBuddy(depth_);
    depth_->setAccessibleName(tr("Format"));
}

void ImageExportDialog::buildButtons(QBoxLayout* layout) {
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    buttons->addStretch(1);
    start_ = new QPushButton(themeIcon(QStringLiteral("document-save")), tr("Render"));
    start_->setDefault(true);
    start_->setToolTip(tr("Render the image and write it"));
    connect(start_, &QPushButton::clicked, this, &ImageExportDialog::start);
    enqueue_ = new QPushButton(themeIcon(QStringLiteral("list-add")), tr("Queue"));
    enqueue_->setAutoDefault(false);
    enqueue_->setToolTip(
        tr("Render the image behind those that are waiting; it goes on when this is closed"));
    connect(enqueue_, &QPushButton::clicked, this, &ImageExportDialog::enqueue);
    stop_ = new QPushButton(themeIcon(QStringLiteral("process-stop")), tr("Stop"));
    stop_->setToolTip(tr("Stop; no file is written"));
    connect(stop_, &QPushButton::clicked, this, &ImageExportDialog::stop);
    auto* close = new QPushButton(tr("Close"));
    close->setToolTip(tr("Close; an export that is waited for is stopped"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    open_ = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Open"));
    open_->setToolTip(tr("Open the image in the program for images"));
    connect(open_, &QPushButton::clicked, this, [this] { openResult(false); });
    reveal_ = new QPushButton(tr("Show Folder"));
    reveal_->setToolTip(tr("Open the folder that holds the image"));
    connect(reveal_, &QPushButton::clicked, this, [this] { openResult(true); });
    for (QPushButton* button : {open_, reveal_}) button->hide();
    for (QPushButton* button : {open_, reveal_, start_, enqueue_, stop_, close}) buttons->addWidget(button);
}

void ImageExportDialog::setPictureSize(QSize size) {
    const QSignalBlocker quietWidth(width_), quietHeight(height_);
    width_->setValue(size.width());
    height_->setValue(size.height());
    ratio_ = static_cast<double>(width_->value()) / height_->value();
    forecastAgain();
}

QSize ImageExportDialog::pictureSize() const { return {width_->value(), height_->value()}; }

void ImageExportDialog::keepProportions(QSpinBox* changed) {
    if (!proportions_->isChecked()) return forecastAgain();
    QSpinBox* other = changed == width_ ? height_ : width_;
    const double wanted = changed == width_ ? changed->value() / ratio_ : changed->value() * ratio_;
    const QSignalBlocker quiet(other);
    other->setValue(static_cast<int>(std::lround(std::clamp<double>(wanted, 1, longestSide))));
    forecastAgain();
}

PictureFormat ImageExportDialog::format() const {
    return pictureFormat(QFile::encodeName(file_->text().trimmed()).toStdString())
        .value_or(PictureFormat::png);
}

void ImageExportDialog::showFormat() {
    const bool png = format() == PictureFormat::png;
    depth_->setVisible(png);
    layers_->setVisible(!png);
}

void ImageExportDialog::ask(bool toReplace, bool toEnqueue) {
    asking_ = toReplace;
    start_->setText(toReplace && !toEnqueue ? tr("Replace") : tr("Render"));
    enqueue_->setText(toReplace && toEnqueue ? tr("Replace") : tr("Queue"));
    // A second Enter must not answer what was not read.
    start_->setDefault(!toReplace);
    start_->setAutoDefault(!toReplace);
    message_->setText(toReplace
                          ? tr("%1 exists already. Replace it?").arg(QFileInfo(file_->text()).fileName())
                          : QString());
    for (QPushButton* button : {open_, reveal_}) button->hide();
}

void ImageExportDialog::openResult(bool folder) {
    QDesktopServices::openUrl(QUrl::fromLocalFile(folder ? QFileInfo(written_).absolutePath() : written_));
}

void ImageExportDialog::setFile(const QString& file) { file_->setText(file); }

void ImageExportDialog::chooseFile() {
    const bool png = format() == PictureFormat::png;
    const QStringList filters{tr("PNG images (*.png)"), tr("OpenEXR images (*.exr)")};
    const QString file =
        chooseSavePath(this, tr("Export image"), file_->text(),
                       (png ? filters : QStringList{filters[1], filters[0]}).join(QStringLiteral(";;")),
                       png ? QStringLiteral("png") : QStringLiteral("exr"));
    if (!file.isEmpty()) file_->setText(file);
}

void ImageExportDialog::setRunning(bool running) {
    for (QWidget* widget : std::initializer_list<QWidget*>{width_, height_, proportions_, antialias_,
                                                           transparent_, depth_, file_, start_, enqueue_})
        widget->setEnabled(!running);
    stop_->setEnabled(running);
}

RenderRequest ImageExportDialog::request() const {
    const QSize size = pictureSize();
    RenderRequest request;
    request.scene = scene_;
    request.camera = fittedCamera(camera_, size.width(), size.height());
    request.width = size.width();
    request.height = size.height();
    request.antialias = antialias_->isChecked();
    request.transparent = transparent_->isChecked();
    request.rootFinder = rootFinder_;
    return request;
}

PictureFileOptions ImageExportDialog::options() const {
    PictureFileOptions options;
    options.format = format();
    options.bits = depth_->currentData().toInt();
    return options;
}

bool ImageExportDialog::mayBegin(bool toEnqueue) {
    if (running() || !scene_) return false;
    if (file_->text().trimmed().isEmpty()) {
        message_->setText(tr("Please choose a file."));
        return false;
    }
    if (QFileInfo(file_->text()).suffix().isEmpty())
        file_->setText(file_->text().trimmed() + QStringLiteral(".png"));
    if (!isOurs(file_->text())) {
        ask(false);
        message_->setText(tr("The file exists and is no PNG or OpenEXR picture: it is not replaced."));
        return false;
    }
    if (QFileInfo::exists(file_->text()) && !asking_) {
        ask(true, toEnqueue);
        return false;
    }
    ask(false);
    return true;
}

int ImageExportDialog::order() {
    // The picture itself is drawn now.
    forecast_->stop();
    const int number = queue_->add(file_->text(), request(), options());
    emit started(pictureSize());
    return number;
}

void ImageExportDialog::start() {
    if (!mayBegin(false)) return;
    progress_->setValue(0);
    setRunning(true);
    number_ = order();
    showProgress(number_);
}

void ImageExportDialog::enqueue() {
    if (!mayBegin(true)) return;
    const int number = order();
    message_->setText(tr("%1 is in the queue. Pictures on the way: %2")
                          .arg(QFileInfo(file_->text()).fileName())
                          .arg(queue_->open()));
    emit enqueued(number);
}

void ImageExportDialog::stop() {
    if (running()) queue_->stop(number_);
}

void ImageExportDialog::showProgress(int number) {
    if (number != number_ || number == 0) return;
    const QueuedPicture picture = queue_->picture(number);
    progress_->setValue(static_cast<int>(1000 * picture.share));
    if (picture.state == QueuedPicture::State::waiting)
        message_->setText(tr("Waits for other pictures…"));
    else if (picture.state == QueuedPicture::State::drawing)
        message_->setText(tr("Rendering…"));
}

void ImageExportDialog::report(int number) {
    if (number != number_ || number == 0) return;
    const QueuedPicture picture = queue_->picture(number);
    number_ = 0;
    setRunning(false);
    const bool written = picture.state == QueuedPicture::State::written;
    message_->setText(written ? tr("Written: %1").arg(picture.file) : picture.problem);
    written_ = written ? picture.file : QString();
    for (QPushButton* button : {open_, reveal_}) button->setVisible(written);
    emit finished(picture.file, picture.problem);
}

void ImageExportDialog::closeEvent(QCloseEvent* event) {
    stop();
    forecast_->stop();
    QDialog::closeEvent(event);
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/image_export_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <QCheckBox>
#include <QCloseEvent>
#include <QFile>
#include <QDesktopServices>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QUrl>

#include "core/exchange/output_guard.h"
#include "core/exchange/png.h"
#include "core/text/whole_file.h"
#include "core/render/image.h"
#include "widgets/icons.h"
#include "widgets/document/save_path.h"
#include "widgets/timing.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// Nothing stands there, or a picture.
bool isOurs(const QString& file) {
    return whyNotReplaced(QFile::encodeName(file.trimmed()).toStdString(), OutputKind::picture).empty();
}

/// Back to linear light for the common PNG writer; exact for 8-bit channels.
Image toLinear(const QImage& image) {
    std::array<float, 256> table;
    for (int i = 0; i < 256; ++i) table[i] = decodeChannel(i / 255.0);
    Image linear(image.width(), image.height());
    auto out = linear.pixels.begin();
    for (int y = 0; y < image.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x, ++out)
            *out = {table[qRed(line[x])], table[qGreen(line[x])], table[qBlue(line[x])]};
    }
    return linear;
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
                                     const QString& suggestedFile, QWidget* parent)
    : QDialog(parent), scene_(std::move(scene)), camera_(camera) {
    setWindowTitle(tr("Export image"));
    setAttribute(Qt::WA_DeleteOnClose);
    buildControls(suggestedFile);
    timer_.setInterval(timing::drainInterval);
    connect(&timer_, &QTimer::timeout, this, &ImageExportDialog::drain);
    setRunning(false);
}

ImageExportDialog::~ImageExportDialog() = default;

void ImageExportDialog::buildControls(const QString& suggestedFile) {
    auto* layout = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    layout->addLayout(form);
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

    file_ = new QLineEdit(suggestedFile);
    file_->setMinimumWidth(320);
    file_->setToolTip(tr("The PNG file to write"));
    file_->setAccessibleName(tr("File"));
    auto* browse = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Choose…"));
    browse->setToolTip(tr("Choose the file"));
    connect(browse, &QPushButton::clicked, this, &ImageExportDialog::chooseFile);
    auto* files = new QHBoxLayout;
    files->addWidget(file_, 1);
    files->addWidget(browse);
    form->addRow(tr("File"), files);

    progress_ = new QProgressBar;
    progress_->setRange(0, 1000);
    progress_->setAccessibleName(tr("Progress"));
    layout->addWidget(progress_);
    message_ = new QLabel;
    message_->setWordWrap(true);
    message_->setAccessibleDescription(tr("Result"));
    layout->addWidget(message_);
    connect(file_, &QLineEdit::textChanged, this, [this] { ask(false); });

    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    buttons->addStretch(1);
    start_ = new QPushButton(themeIcon(QStringLiteral("document-save")), tr("Render"));
    start_->setDefault(true);
    start_->setToolTip(tr("Render the image and write it"));
    connect(start_, &QPushButton::clicked, this, &ImageExportDialog::start);
    stop_ = new QPushButton(themeIcon(QStringLiteral("process-stop")), tr("Stop"));
    stop_->setToolTip(tr("Stop; no file is written"));
    connect(stop_, &QPushButton::clicked, this, &ImageExportDialog::stop);
    auto* close = new QPushButton(tr("Close"));
    close->setToolTip(tr("Close; a running export is stopped"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    open_ = new QPushButton(themeIcon(QStringLiteral("document-open")), tr("Open"));
    open_->setToolTip(tr("Open the image in the program for images"));
    connect(open_, &QPushButton::clicked, this, [this] { openResult(false); });
    reveal_ = new QPushButton(tr("Show Folder"));
    reveal_->setToolTip(tr("Open the folder that holds the image"));
    connect(reveal_, &QPushButton::clicked, this, [this] { openResult(true); });
    for (QPushButton* button : {open_, reveal_}) button->hide();
    for (QPushButton* button : {open_, reveal_, start_, stop_, close}) buttons->addWidget(button);
}

void ImageExportDialog::setPictureSize(QSize size) {
    const QSignalBlocker quietWidth(width_), quietHeight(height_);
    width_->setValue(size.width());
    height_->setValue(size.height());
    ratio_ = static_cast<double>(width_->value()) / height_->value();
}

QSize ImageExportDialog::pictureSize() const { return {width_->value(), height_->value()}; }

void ImageExportDialog::keepProportions(QSpinBox* changed) {
    if (!proportions_->isChecked()) return;
    QSpinBox* other = changed == width_ ? height_ : width_;
    const double wanted = changed == width_ ? changed->value() / ratio_ : changed->value() * ratio_;
    const QSignalBlocker quiet(other);
    other->setValue(static_cast<int>(std::lround(std::clamp<double>(wanted, 1, longestSide))));
}

void ImageExportDialog::ask(bool toReplace) {
    asking_ = toReplace;
    start_->setText(toReplace ? tr("Replace") : tr("Render"));
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
    const QString file = chooseSavePath(this, tr("Export image"), file_->text(), tr("PNG images (*.png)"),
                                        QStringLiteral("png"));
    if (!file.isEmpty()) file_->setText(file);
}

void ImageExportDialog::setRunning(bool running) {
    running_ = running;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{width_, height_, proportions_, antialias_, file_, start_})
        widget->setEnabled(!running);
    stop_->setEnabled(running);
}

void ImageExportDialog::start() {
    const QSize size(width_->value(), height_->value());
    if (running_ || !scene_) return;
    if (static_cast<qint64>(size.width()) * size.height() > mostPixels) {
        message_->setText(tr("That is more than %1 million pixels.").arg(mostPixels / 1'000'000));
        return;
    }
    if (file_->text().trimmed().isEmpty()) {
        message_->setText(tr("Please choose a file."));
        return;
    }
    if (QFileInfo(file_->text()).suffix().isEmpty())
        file_->setText(file_->text().trimmed() + QStringLiteral(".png"));
    if (!isOurs(file_->text())) {
        ask(false);
        message_->setText(tr("The file exists and is no PNG picture: it is not replaced."));
        return;
    }
    if (QFileInfo::exists(file_->text()) && !asking_) return ask(true);
    ask(false);
    RenderRequest request;
    request.scene = scene_;
    request.camera = fittedCamera(camera_, size.width(), size.height());
    request.width = size.width();
    request.height = size.height();
    request.antialias = antialias_->isChecked();
    request.rootFinder = rootFinder_;
    image_ = QImage(size, QImage::Format_RGB32);
    image_.fill(Qt::black);
    received_ = 0;
    progress_->setValue(0);
    message_->setText(tr("Rendering…"));
    setRunning(true);
    renderer_ = std::make_unique<ProgressiveRenderer>();
    job_ = renderer_->request(std::move(request));
    timer_.start();
    emit started(size);
}

void ImageExportDialog::stop() {
    if (!renderer_) return;  // nothing to stop, or already being written
    timer_.stop();
    renderer_.reset();
    image_ = {};
    report(tr("Stopped; nothing was written."));
}

void ImageExportDialog::drain() {
    const RenderProgress state = renderer_->progress();
    for (const FinishedTile& tile : renderer_->takeTiles()) {
        received_ += static_cast<qint64>(tile.width) * tile.height;
        const std::uint32_t* from = tile.pixels.data();
        const QRect area = QRect(tile.x, tile.y, tile.width, tile.height) & image_.rect();
        for (int y = area.top(); y <= area.bottom(); ++y, from += tile.width)
            std::memcpy(image_.scanLine(y) + area.left() * sizeof(std::uint32_t), from,
                        area.width() * sizeof(std::uint32_t));
    }
    const qint64 area = static_cast<qint64>(image_.width()) * image_.height();
    const qint64 all = area * std::max(1, state.passCount);
    progress_->setValue(static_cast<int>(1000 * std::min(received_, all) / all));
    if (state.finished && state.job == job_) {
        timer_.stop();
        renderer_.reset();
        write();
    }
}

void ImageExportDialog::write() {
    message_->setText(tr("Writing…"));
    stop_->setEnabled(false);
    const QString file = file_->text();
    writer_.submit([this, file, image = image_](std::stop_token) {
        const std::string reason =
            writeWhole(QFile::encodeName(file).toStdString(), encodePng(toLinear(image), 0));
        const QString error =
            reason.empty() ? QString()
                           : tr("%1 could not be written: %2.").arg(file, QString::fromLocal8Bit(reason));
        QMetaObject::invokeMethod(
            this, [this, error] { report(error); }, Qt::QueuedConnection);
    });
}

void ImageExportDialog::report(const QString& error) {
    setRunning(false);
    image_ = {};
    message_->setText(error.isEmpty() ? tr("Written: %1").arg(file_->text()) : error);
    written_ = error.isEmpty() ? file_->text() : QString();
    for (QPushButton* button : {open_, reveal_}) button->setVisible(error.isEmpty());
    emit finished(file_->text(), error);
}

void ImageExportDialog::closeEvent(QCloseEvent* event) {
    timer_.stop();
    renderer_.reset();
    QDialog::closeEvent(event);
}

}  // namespace isoscope

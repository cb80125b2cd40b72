// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/sheet_panel.h"

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/exchange/png.h"
#include "core/study/sweep/parameter_sweep.h"
#include "widgets/background_priority.h"
#include "widgets/charts/chart_file.h"
#include "widgets/document/save_path.h"
#include "widgets/either_stop.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"
#include "widgets/studies/sheet_view.h"

namespace isoscope {

namespace {

constexpr int usualSteps = 4, mostSteps = 20, mostNumbers = 200;
/// The longer side of a picture of the sheet.
constexpr int pictureSide = 200;

QString nameOf(const SceneParameter& parameter) {
    const QString name = QString::fromStdString(parameter.name);
    return parameter.group == "#declare" ? name : QString::fromStdString(parameter.group) + ' ' + name;
}

bool samePlace(const SceneParameter& a, const SceneParameter& b) {
    return a.name == b.name && a.group == b.group && a.range.begin == b.range.begin;
}

}  // namespace

SheetPanel::SheetPanel(QWidget* parent) : StudyPanel(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    // Both numbers below each other, the buttons beside them.
    auto* choice = new QGridLayout;
    choice->addLayout(buildAxis(axes_[0], false), 0, 0);
    choice->addLayout(buildAxis(axes_[1], true), 1, 0);
    choice->setColumnStretch(0, 1);
    column->addLayout(choice);
    start_ = new QPushButton;
    start_->setAccessibleName(tr("Draw the sheet, or stop"));
    connect(start_, &QPushButton::clicked, this, [this] { drawing_ ? stop() : draw(); });
    choice->addWidget(start_, 0, 1);
    progress_ = new QProgressBar;
    progress_->setFixedWidth(80);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the sheet"));
    progress_->setToolTip(tr("How many of the pictures are drawn"));
    save_ = new QPushButton(tr("Save…"));
    save_->setToolTip(tr("Write the sheet to a PNG file"));
    save_->setAccessibleName(tr("Save the sheet"));
    connect(save_, &QPushButton::clicked, this, &SheetPanel::save);
    choice->addWidget(save_, 1, 1);
    view_ = new SheetView;
    view_->setToolTip(tr("Click a picture to set its values in the text"));
    view_->setAccessibleName(tr("Sheet of small pictures"));
    connect(view_, &SheetView::clicked, this, &SheetPanel::choose);
    column->addWidget(view_, 1);
    note_ = new QLabel;
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    note_->setAccessibleDescription(tr("About the sheet"));
    auto* row = new QHBoxLayout;
    row->addWidget(note_, 1);
    row->addWidget(progress_);
    column->addLayout(row);
    refresh();
}

SheetPanel::~SheetPanel() { stop_.request_stop(); }

QHBoxLayout* SheetPanel::buildAxis(Axis& axis, bool second) {
    auto* row = new QHBoxLayout;
    auto* direction = new QLabel(second ? tr("down") : tr("across"));
    for (const QString& word : {tr("across"), tr("down")})
        direction->setMinimumWidth(
            std::max(direction->minimumWidth(), direction->fontMetrics().horizontalAdvance(word)));
    row->addWidget(direction);
    axis.numbers = new QComboBox;
    axis.numbers->setToolTip(second ? tr("The number whose values go down, if there is to be a second one")
                                    : tr("The number whose values go across"));
    axis.numbers->setAccessibleName(axis.numbers->toolTip());
    row->addWidget(axis.numbers, 1);
    const QString widest = QStringLiteral("-0.00000");
    axis.from = NumberBox::addTo(row, tr("from"), tr("First value"), widest);
    axis.to = NumberBox::addTo(row, tr("to"), tr("Last value"), widest);
    axis.steps = new QSpinBox;
    axis.steps->setRange(1, mostSteps);
    axis.steps->setValue(usualSteps);
    axis.steps->setSuffix(tr(" values"));
    axis.steps->setAccessibleName(tr("Number of values"));
    axis.steps->setToolTip(tr("How many values are drawn"));
    row->addWidget(axis.steps);
    connect(axis.numbers, &QComboBox::activated, this, [this, &axis] {
        takeEnds(axis);
        refresh();
    });
    return row;
}

const SceneParameter* SheetPanel::number(const Axis& axis) const {
    const int index = axis.numbers->currentIndex() - (&axis == &axes_[1] ? 1 : 0);
    return index >= 0 && static_cast<std::size_t>(index) < listed_.size()
               ? &listed_[static_cast<std::size_t>(index)]
               : nullptr;
}

void SheetPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    scene_ = std::move(scene);
    if (!scene_) {
        stop();
        image_ = {};
        cells_.clear();
        drawn_ = 0;
        view_->setImage(image_);
    }
    if (active_ || !scene_) listNumbers();
    refresh();
}

void SheetPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty()) return;
    camera_ = camera;
    size_ = size;
}

void SheetPanel::setActive(bool active) {
    active_ = active;
    if (!active && drawing_) stop();
    if (active) listNumbers();
    refresh();
}

/// The same numbers stay chosen; at first one that the function depends on, and no second one.
void SheetPanel::listNumbers() {
    const QString chosen[2] = {axes_[0].numbers->currentText(), axes_[1].numbers->currentText()};
    listed_.clear();
    QStringList names;
    int first = -1;
    for (const SceneParameter& parameter : scene_ ? scene_->parameters : std::vector<SceneParameter>{}) {
        if (parameter.range.file != 0 || parameter.expression || names.size() >= mostNumbers) continue;
        QString name = nameOf(parameter);
        for (int again = 2; names.contains(name); ++again)
            name = tr("%1 (%2)").arg(nameOf(parameter)).arg(again);
        if (first < 0 && parameter.role == ParameterRole::argument) first = static_cast<int>(names.size());
        listed_.push_back(parameter);
        names << name;
    }
    for (int which = 0; which < 2; ++which) {
        Axis& axis = axes_[which];
        const QSignalBlocker quiet(axis.numbers);
        axis.numbers->clear();
        if (which == 1) axis.numbers->addItem(tr("(no second number)"));
        axis.numbers->addItems(names);
        const int known = axis.numbers->findText(chosen[which]);
        axis.numbers->setCurrentIndex(known >= 0 ? known : which == 1 ? 0 : std::max(0, first));
        if (known < 0) takeEnds(axis);
    }
}

void SheetPanel::takeEnds(const Axis& axis) {
    const SceneParameter* one = number(axis);
    if (!one) return;
    for (NumberBox* box : {axis.from, axis.to}) {
        box->setIntegral(one->integral);
        box->setResolution(std::max(1e-9, (one->maximum - one->minimum) / 100));
    }
    axis.from->setValue(one->minimum);
    axis.to->setValue(one->maximum);
}

/// With its number in the scene of the text, which may be another one than that of the list.
std::optional<VariedNumber> SheetPanel::varied(const Axis& axis, const ParseResult& parsed) const {
    const SceneParameter* one = number(axis);
    if (!one) return {};
    const auto& known = parsed.scene->parameters;
    const auto found =
        std::ranges::find_if(known, [&](const SceneParameter& other) { return samePlace(other, *one); });
    if (found == known.end()) return {};
    VariedNumber varied{
        static_cast<std::size_t>(found - known.begin()),
        sweepValues(axis.from->value(), axis.to->value(), axis.steps->value(), one->logarithmic)};
    if (one->integral)
        for (double& value : varied.values) value = std::round(value);
    varied.values.erase(std::unique(varied.values.begin(), varied.values.end()), varied.values.end());
    return varied.values.empty() ? std::nullopt : std::optional(varied);
}

void SheetPanel::draw() {
    stop();
    const auto parsed = reader_ ? reader_() : nullptr;
    if (!parsed || !parsed->ok()) {
        emit said(tr("The text is still being read, or has errors."));
        return;
    }
    const auto first = varied(axes_[0], *parsed);
    auto second = varied(axes_[1], *parsed);
    if (!first) return;
    if (second && second->parameter == first->parameter) second.reset();
    RenderRequest view;
    view.camera = camera_;
    view.rootFinder = RootFinder::certified;
    const double scale = static_cast<double>(pictureSide) / std::max(size_.width(), size_.height());
    view.width = std::max(16, static_cast<int>(size_.width() * scale));
    view.height = std::max(16, static_cast<int>(size_.height() * scale));
    auto sheet = std::make_shared<SmallMultiples>(*parsed, view, false, *first, second);
    if (sheet->tooLarge()) {
        emit said(tr("The sheet would be too large."));
        return;
    }
    cells_ = sheet->cells();
    varied_ = {parsed->scene->parameters[first->parameter]};
    if (second) varied_.push_back(parsed->scene->parameters[second->parameter]);
    cellSize_ = {view.width, view.height};
    grid_ = {sheet->columns(), sheet->rows()};
    drawn_ = 0;
    drawing_ = true;
    stop_ = std::stop_source();
    worker_.submit(
        [this, parsed, sheet, generation = generation_, stop = stop_.get_token()](std::stop_token closing) {
            lowerThreadPriority();
            const EitherStop either(stop, closing);
            const int count = static_cast<int>(sheet->cells().size());
            QElapsedTimer shown;
            qint64 taken = 0;
            for (int i = 0; i < count && !either.token().stop_requested(); ++i) {
                sheet->draw(static_cast<std::size_t>(i), either.token(), 1);
                if (either.token().stop_requested()) break;
                // Showing a large sheet takes longer than drawing one of its pictures.
                if (i + 1 < count && shown.isValid() && shown.elapsed() < 10 * taken) continue;
                shown.start();
                const std::string png = encodePng(sheet->sheet().image());
                const QImage image = QImage::fromData(QByteArray::fromStdString(png), "PNG");
                taken = shown.restart();
                QMetaObject::invokeMethod(
                    this, [this, image, i, generation] { receive(image, i + 1, generation); },
                    Qt::QueuedConnection);
            }
        });
    refresh();
}

void SheetPanel::stop() {
    stop_.request_stop();
    ++generation_;
    drawing_ = false;
    refresh();
}

void SheetPanel::receive(const QImage& image, int count, std::uint64_t generation) {
    if (generation != generation_) return;
    image_ = image;
    drawn_ = count;
    drawing_ = drawn_ < static_cast<int>(cells_.size());
    view_->setImage(image_);
    refresh();
}

QPoint SheetPanel::middleOf(int column, int row) const {
    const double across = static_cast<double>(image_.width()) / std::max(1, grid_.width());
    const double down = static_cast<double>(image_.height()) / std::max(1, grid_.height());
    return {static_cast<int>((column + 0.5) * across), static_cast<int>((row + 0.5) * down)};
}

void SheetPanel::choose(QPoint pixel) {
    const PictureSheet layout(grid_.width(), grid_.height(), cellSize_.width(), cellSize_.height());
    const auto place = layout.placeAt(pixel.x(), pixel.y());
    if (!place) return;
    const int index = place->second * grid_.width() + place->first;
    if (index >= drawn_) return;
    QList<Setting> values;
    const auto& numbers = cells_[static_cast<std::size_t>(index)].numbers;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const double step = std::abs(varied_[k].maximum - varied_[k].minimum) / 10'000;
        const double resolution = varied_[k].integral ? 1 : std::pow(10, std::floor(std::log10(step)));
        const bool usable = std::isfinite(resolution) && resolution > 0 && !varied_[k].logarithmic;
        values << Setting(varied_[k],
                          usable ? roundToResolution(numbers[k].value, resolution) : numbers[k].value);
    }
    emit valuesRequested(values);
}

bool SheetPanel::saveTo(const QString& path) const { return savePicture(image_, path); }

void SheetPanel::save() {
    const QString path =
        chooseSavePath(this, tr("Save"), pathInDocuments(tr("sheet") + QStringLiteral(".png")),
                       tr("PNG pictures (*.png)"), QStringLiteral("png"));
    if (!path.isEmpty())
        emit said(saveTo(path) ? tr("Saved %1.").arg(path) : tr("%1 cannot be written.").arg(path));
}

void SheetPanel::refresh() {
    start_->setText(drawing_ ? tr("Stop") : tr("Draw"));
    start_->setToolTip(drawing_ ? tr("End the drawing; what is drawn stays")
                                : tr("Draw the scene in small for each of the values"));
    const bool some = number(axes_[0]) != nullptr, two = number(axes_[1]) != nullptr;
    start_->setEnabled(some || drawing_);
    for (QWidget* control : std::initializer_list<QWidget*>{axes_[0].numbers, axes_[0].from, axes_[0].to,
                                                            axes_[0].steps, axes_[1].numbers})
        control->setEnabled(some);
    for (QWidget* control : std::initializer_list<QWidget*>{axes_[1].from, axes_[1].to, axes_[1].steps})
        control->setEnabled(two);
    progress_->setVisible(drawing_);
    progress_->setMaximum(std::max(1, static_cast<int>(cells_.size())));
    progress_->setValue(drawn_);
    save_->setEnabled(!image_.isNull() && !drawing_);
    view_->setEmptyText(some ? tr("Choose one number, or two, and press Draw.")
                             : tr("The scene has no number to vary."));
    if (image_.isNull())
        note_->clear();
    else if (!drawing_ && drawn_ < static_cast<int>(cells_.size()))
        note_->setText(tr("Stopped early: %1 of %2 pictures.").arg(drawn_).arg(cells_.size()));
    else
        note_->setText(tr("Click a picture to set its values in the text."));
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gradient_panel.h"

#include <algorithm>
#include <cmath>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/study/gradient_verdict.h"
#include "widgets/number_text.h"
#include "widgets/surface_chooser.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

/// Holes are counted in a small picture: ten of them have to be traced.
constexpr int surveyWidth = 160;
const QString nothing = QStringLiteral("–");

QString shortNumber(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', 5) : QStringLiteral("∞");
}

QString placeText(const glm::dvec3& p) {
    // Below what matters, a zero is easier to read.
    const auto tidy = [](double value) {
        return QString::number(std::abs(value) < 1e-9 ? 0 : value, 'g', 4);
    };
    return QStringLiteral("<%1, %2, %3>").arg(tidy(p.x), tidy(p.y), tidy(p.z));
}

QString hazardText(GradientHazard hazard) {
    switch (hazard) {
        case GradientHazard::jump: return GradientPanel::tr("a jump");
        case GradientHazard::steepEdge: return GradientPanel::tr("an infinite slope");
        case GradientHazard::pole: return GradientPanel::tr("a pole");
        case GradientHazard::overflow: return GradientPanel::tr("an overflow");
        default: return GradientPanel::tr("an unknown bound");
    }
}

}  // namespace

GradientPanel::GradientPanel(QWidget* parent) : QWidget(parent) {
    buildRows();
    restartTimer_.setSingleShot(true);
    restartTimer_.setInterval(timing::settlePause);
    connect(&restartTimer_, &QTimer::timeout, this, &GradientPanel::measure);
    connect(useSuggested_, &QPushButton::clicked, this,
            [this] { emit settingRequested(index(), suggestedGradient(survey_.bracket)); });
    connect(useEnough_, &QPushButton::clicked, this, [this] {
        if (survey_.enoughForView) emit settingRequested(index(), *survey_.enoughForView);
    });
    clear();
}

GradientPanel::~GradientPanel() { stop_.request_stop(); }

QLabel* GradientPanel::addRow(const QString& title, const QString& toolTip, QPushButton* button) {
    auto* grid = static_cast<QGridLayout*>(layout()->itemAt(1)->layout());
    const int row = grid->rowCount();
    auto* name = new QLabel(title);
    name->setToolTip(toolTip);
    auto* value = new QLabel;
    value->setTextFormat(Qt::PlainText);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    value->setToolTip(toolTip);
    value->setAccessibleName(title);
    grid->addWidget(name, row, 0, Qt::AlignTop);
    grid->addWidget(value, row, 1, Qt::AlignTop);
    if (!button) return value;
    grid->addWidget(button, row, 2, Qt::AlignTop);
    // A single line of text stands level with the button's.
    for (QLabel* label : {name, value}) label->setMinimumHeight(button->sizeHint().height());
    return value;
}

void GradientPanel::buildRows() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    surfaces_ = new SurfaceChooser(tr("The isosurface whose gradient is measured"));
    connect(surfaces_, &SurfaceChooser::activated, this, &GradientPanel::restart);
    column->addWidget(surfaces_);
    auto* grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    column->addLayout(grid);

    useSuggested_ = new QPushButton(tr("Use"));
    useSuggested_->setToolTip(tr("Write the suggested max_gradient into the text"));
    useSuggested_->setAccessibleName(tr("Use the suggested max_gradient"));
    useEnough_ = new QPushButton(tr("Use"));
    useEnough_->setToolTip(tr("Write the value that is enough for this view into the text"));
    useEnough_->setAccessibleName(tr("Use the max_gradient that is enough for this view"));

    setting_ = addRow(tr("max_gradient"), tr("The setting in force, and what it is worth"));
    holes_ = addRow(tr("Holes"),
                    tr("Pixels of this view that POV-Ray's method gets wrong with the present setting"));
    alongRays_ = addRow(tr("Along rays"),
                        tr("The steepest slope that the rays of this view meet: what POV-Ray reports"));
    onSurface_ =
        addRow(tr("On the surface"), tr("The largest gradient at the visible points of the surface"));
    bracket_ = addRow(tr("Proven"),
                      tr("The largest gradient in the container lies between these: the first is attained "
                         "at the place shown, the second is exceeded nowhere"));
    suggested_ =
        addRow(tr("Suggested"), tr("The smallest round value that no gradient in the container exceeds"),
               useSuggested_);
    enough_ =
        addRow(tr("This view"),
               tr("The smallest value that loses no pixel in this view; not proven for others"), useEnough_);
    note_ = new QLabel;
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setAccessibleName(tr("What to do about an infinite gradient"));
    column->addWidget(note_);
    column->addStretch(1);
}

std::size_t GradientPanel::index() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

QString GradientPanel::holesText() const { return holes_->text(); }

void GradientPanel::setScene(std::shared_ptr<const Scene> scene) {
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    restart();
}

void GradientPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    restart();
}

void GradientPanel::setActive(bool active) {
    if (active == active_) return;
    active_ = active;
    restart();
}

/// What is shown no longer holds; measuring waits until the scene and the view have come to rest.
void GradientPanel::restart() {
    stop_.request_stop();
    ++generation_;
    measuring_ = false;
    if (!scene_ || index() >= scene_->isosurfaces.size()) {
        restartTimer_.stop();
        clear();
        return;
    }
    if (!active_) {
        restartTimer_.stop();
        return;
    }
    measuring_ = true;
    restartTimer_.start();
}

void GradientPanel::measure() {
    stop_ = std::stop_source();
    GradientSurveyRequest request;
    request.view.scene = scene_;
    request.view.camera = camera_;
    request.view.width = surveyWidth;
    request.view.height = std::clamp(surveyWidth * size_.height() / size_.width(), 1, 4 * surveyWidth);
    request.isosurface = index();
    const std::uint64_t generation = generation_;
    worker_.submit([this, request, generation, stop = stop_.get_token()](std::stop_token closing) {
        std::stop_source either;
        const std::stop_callback onStop(stop, [&either] { either.request_stop(); });
        const std::stop_callback onClose(closing, [&either] { either.request_stop(); });
        surveyGradient(
            request,
            [this, generation](const GradientSurvey& survey) {
                QMetaObject::invokeMethod(
                    this,
                    [this, generation, survey] {
                        if (generation == generation_) receive(survey);
                    },
                    Qt::QueuedConnection);
            },
            either.get_token());
    });
}

void GradientPanel::receive(GradientSurvey survey) {
    survey_ = std::move(survey);
    show(survey_);
    emit reported(survey_);
    if (!survey_.finished) return;
    measuring_ = false;
    emit surveyed();
}

void GradientPanel::clear() {
    survey_ = {};
    for (QLabel* label : {setting_, alongRays_, onSurface_, bracket_, suggested_, enough_, holes_})
        label->setText(nothing);
    note_->setText(tr("The scene has no isosurface to measure."));
    useSuggested_->setEnabled(false);
    useEnough_->setEnabled(false);
    emit reported(survey_);
}

void GradientPanel::show(const GradientSurvey& survey) {
    const HoleMap& holes = survey.holes;
    if (holes.mistakes() == 0)
        holes_->setText(tr("none in %1 pixels").arg(holes.pixels.size()));
    else
        holes_->setText(tr("%1 lost, %2 gained, %3 at a wrong place, of %4 pixels")
                            .arg(holes.count(HolePixel::lost))
                            .arg(holes.count(HolePixel::gained))
                            .arg(holes.count(HolePixel::wrongPlace))
                            .arg(holes.pixels.size()));
    alongRays_->setText(shortNumber(survey.alongRays));
    onSurface_->setText(
        survey.onSurface > 0
            ? tr("%1 at %2").arg(shortNumber(survey.onSurface), placeText(survey.steepestPoint))
            : nothing);
    showBracket(survey);
    enough_->setText(
        survey.enoughForView
            ? tr("%1: enough for this view, not proven for others").arg(numberText(*survey.enoughForView))
            : nothing);
    useEnough_->setEnabled(survey.enoughForView.has_value());
}

void GradientPanel::showBracket(const GradientSurvey& survey) {
    const GradientBracket& b = survey.bracket;
    QString verdict;
    switch (judgeGradient(survey.setting, b, survey.alongRays)) {
        case GradientVerdict::holes: verdict = tr("too low"); break;
        case GradientVerdict::right: verdict = tr("right"); break;
        case GradientVerdict::wasteful: verdict = tr("more than needed: slower"); break;
        default: verdict = tr("not proven");
    }
    const bool known = b.boxes > 0;
    setting_->setText(known ? tr("%1 (%2)").arg(shortNumber(survey.setting), verdict)
                            : shortNumber(survey.setting));
    QString state;
    if (b.state == GradientState::running)
        state = tr(", tightening");
    else if (b.state == GradientState::unproven && std::isfinite(b.upper))
        state = tr(", budget spent");
    if (b.state == GradientState::unbounded)
        bracket_->setText(tr("unbounded: %1 at %2").arg(hazardText(b.singularity->kind), placeText(b.place)));
    else
        bracket_->setText(
            known ? tr("%1 to %2%3, the first at %4")
                        .arg(shortNumber(b.lower), shortNumber(b.upper), state, placeText(b.place))
                  : nothing);
    const double suggested = known ? suggestedGradient(b) : 0;
    const bool usable = suggested > 0 && std::isfinite(suggested);
    suggested_->setText(usable ? tr("%1: proven for every view").arg(numberText(suggested)) : nothing);
    useSuggested_->setEnabled(usable);
    QString note;
    if (b.singularity)
        note = tr("No bound at %1: %2. %3")
                   .arg(placeText(b.singularity->place), hazardText(b.singularity->kind),
                        QString::fromUtf8(advice(b.singularity->kind).data(),
                                          static_cast<qsizetype>(advice(b.singularity->kind).size())));
    else if (b.seams)
        note = tr("The bound holds beside places where the function may jump; none was found.");
    note_->setText(note);
}

}  // namespace isoscope

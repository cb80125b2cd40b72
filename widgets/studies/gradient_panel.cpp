// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/gradient_panel.h"

#include <algorithm>
#include <cmath>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/study/gradient/function_likeness.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/view/point_probe.h"
#include "widgets/either_stop.h"
#include "widgets/numbers/number_text.h"
#include "widgets/section/surface_chooser.h"
#include "widgets/studies/share_text.h"
#include "widgets/timing.h"
#include "widgets/verdicts/verdict_text.h"

namespace isoscope {

namespace {

/// Holes are counted in a small picture: ten of them have to be traced.
constexpr int surveyWidth = 160;
/// Pixels, for two columns of rows side by side.
constexpr int wideEnough = 680;
constexpr int betweenGrids = 24;
const QString nothing = QStringLiteral("–");

/// Whether what is known of isosurface `i` of one scene holds for that of the other, in the same view.
bool sameSubject(const Scene& a, const Scene& b, std::size_t i) {
    if (i >= a.isosurfaces.size() || i >= b.isosurfaces.size()) return false;
    const auto &one = a.isosurfaces[i].shape, &other = b.isosurfaces[i].shape;
    if (!one || !other) return false;
    const IsosurfaceSettings &s = one->settings(), &t = other->settings();
    return s.maxGradient == t.maxGradient && s.accuracy == t.accuracy && s.threshold == t.threshold &&
           s.open == t.open && s.maxTrace == t.maxTrace && s.evaluate == t.evaluate &&
           a.isosurfaces[i].transform.forward() == b.isosurfaces[i].transform.forward() &&
           sameContainer(s.container, t.container) &&
           sameFunction(*one->tape(), *a.parameterTable, *other->tape(), *b.parameterTable);
}

}  // namespace

GradientPanel::GradientPanel(QWidget* parent) : StudyPanel(parent) {
    buildRows();
    restartTimer_.setSingleShot(true);
    restartTimer_.setInterval(timing::settlePause);
    connect(&restartTimer_, &QTimer::timeout, this, &GradientPanel::measure);
    connect(useSuggested_, &QPushButton::clicked, this,
            [this] { emit settingRequested(chosen(), suggestedGradient(survey_.bracket)); });
    connect(useEnough_, &QPushButton::clicked, this, [this] {
        if (survey_.enoughForView) emit settingRequested(chosen(), *survey_.enoughForView);
    });
    connect(goThere_, &QPushButton::clicked, this,
            [this] { emit placeRequested(chosen(), survey_.bracket.place); });
    forget();
    showProbe(nullptr);
}

GradientPanel::~GradientPanel() { stop_.request_stop(); }

QLabel* GradientPanel::addRow(const QString& title, const QString& toolTip, QPushButton* button) {
    // What can be used stands beside what is measured, where the panel is wide.
    QGridLayout* grid = button ? useful_ : measured_;
    const int row = grid->rowCount();
    auto* name = new QLabel(title);
    auto* value = new QLabel;
    value->setTextFormat(Qt::PlainText);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    value->setObjectName(title);
    for (QLabel* label : {name, value}) {
        label->setToolTip(toolTip);
        label->setWhatsThis(toolTip);
    }
    value->setAccessibleDescription(title);
    name->setBuddy(value);
    grid->addWidget(name, row, 0, Qt::AlignTop);
    grid->addWidget(value, row, 1, Qt::AlignTop);
    if (!button) return value;
    grid->addWidget(button, row, 2, Qt::AlignTop);
    // A single line of text stands level with the button's.
    for (QLabel* label : {name, value}) label->setMinimumHeight(button->sizeHint().height());
    return value;
}

QPushButton* GradientPanel::addButton(const QString& text, const QString& toolTip, const QString& name) {
    auto* button = new QPushButton(text);
    button->setToolTip(toolTip);
    button->setWhatsThis(toolTip);
    button->setAccessibleName(name);
    return button;
}

void GradientPanel::buildRows() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    surfaces_ = new SurfaceChooser(tr("The isosurface whose gradient is measured."));
    surfaces_->setWhatsThis(surfaces_->toolTip());
    connect(surfaces_, &SurfaceChooser::activated, this, [this] {
        forget();
        restart();
        emit chosenChanged();
    });
    column->addWidget(surfaces_);
    headline_ = new QLabel;
    headline_->setWordWrap(true);
    headline_->setTextFormat(Qt::PlainText);
    QFont bold = headline_->font();
    bold.setBold(true);
    headline_->setFont(bold);
    column->addWidget(headline_);
    grids_ = new QBoxLayout(QBoxLayout::TopToBottom);
    measured_ = new QGridLayout;
    useful_ = new QGridLayout;
    for (QGridLayout* grid : {measured_, useful_}) {
        grid->setColumnStretch(1, 1);
        grid->setVerticalSpacing(4);
        grid->setColumnMinimumWidth(0, fontMetrics().horizontalAdvance(tr("On the surface")));
        grids_->addLayout(grid, 1);
    }
    column->addLayout(grids_);

    useSuggested_ = addButton(tr("Use"), tr("Writes the suggested max_gradient into the text."),
                              tr("Use the suggested max_gradient"));
    useEnough_ = addButton(tr("Use"), tr("Writes the value that is enough for this view into the text."),
                           tr("Use the max_gradient that is enough for this view"));
    goThere_ = addButton(tr("Go There"), tr("Shows the steepest place of the function in the picture."),
                         tr("Show the steepest place in the picture"));

    setting_ = addRow(
        tr("max_gradient"),
        tr("How steep POV-Ray takes the function to be: the number in the text, and what it is worth. Where "
           "the function is steeper, POV-Ray steps over the surface, which leaves holes."));
    holes_ = addRow(tr("Holes"), tr("Pixels of this view that POV-Ray's picture gets wrong with the present "
                                    "setting: lost, gained, or found at a wrong place."));
    alongRays_ = addRow(tr("Along rays"), tr("How steep the function is along the rays of this view: the "
                                             "steepest slope that POV-Ray meets, and reports."));
    onSurface_ = addRow(tr("On the surface"), tr("How steep the function is where you see the surface: the "
                                                 "largest gradient at its visible points."));
    bracket_ = addRow(tr("Proven"),
                      tr("How steep the function gets anywhere in its container. The largest gradient lies "
                         "between these: the first is reached at the place shown, the second nowhere "
                         "exceeded."),
                      goThere_);
    suggested_ = addRow(tr("Suggested"),
                        tr("What to write for a picture without holes from every side: the smallest round "
                           "value that no gradient in the container exceeds."),
                        useSuggested_);
    enough_ = addRow(tr("This view"),
                     tr("What is enough for the present view, and faster: the smallest value that loses no "
                        "pixel of it. Nothing is proven for other views."),
                     useEnough_);
    probe_ = addRow(tr("At the mouse"),
                    tr("How steep the function is at the point under the mouse, in the picture, the "
                       "cross-section or a chart, beside max_gradient."));
    note_ = new QLabel;
    note_->setWordWrap(true);
    note_->setTextFormat(Qt::PlainText);
    note_->setAccessibleDescription(tr("What to do about an infinite gradient"));
    column->addWidget(note_);
    column->addStretch(1);
}

void GradientPanel::resizeEvent(QResizeEvent* event) {
    const bool wide = width() >= wideEnough;
    grids_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    grids_->setSpacing(wide ? betweenGrids : layout()->spacing());
    QWidget::resizeEvent(event);
}

void GradientPanel::say(QLabel* row, const QString& value) {
    row->setText(value);
    row->setAccessibleName(row->objectName() + QStringLiteral(": ") + value);
}

std::size_t GradientPanel::chosen() const {
    return static_cast<std::size_t>(std::max(0, surfaces_->currentIndex()));
}

void GradientPanel::choose(std::size_t isosurface) {
    if (isosurface == chosen() || isosurface >= static_cast<std::size_t>(surfaces_->count())) return;
    surfaces_->setCurrentIndex(static_cast<int>(isosurface));
    forget();
    restart();
    emit chosenChanged();
}

QString GradientPanel::holesText() const { return holes_->text(); }
QString GradientPanel::probeText() const { return probe_->text(); }
QString GradientPanel::suggestedText() const { return suggested_->text(); }
QString GradientPanel::headline() const { return headline_->text(); }

void GradientPanel::setScene(std::shared_ptr<const Scene> scene) {
    if (scene == scene_) return;
    const bool same = scene_ && scene && sameSubject(*scene_, *scene, chosen());
    scene_ = std::move(scene);
    surfaces_->setScene(scene_.get());
    if (!same) forget();
    complete_ = false;
    restart();
}

void GradientPanel::setView(const Camera& camera, QSize size) {
    if (size.isEmpty() || (camera == camera_ && size == size_)) return;
    camera_ = camera;
    size_ = size;
    forgetView();
    restart();
}

void GradientPanel::setWanted(bool wanted) {
    if (wanted == active_) return;
    active_ = wanted;
    restart();
}

void GradientPanel::endWork() {
    setWanted(false);
    StudyPanel::endWork();
}

void GradientPanel::showProbe(const ProbedPoint* point) {
    if (!point || point->isosurface != chosen()) return say(probe_, nothing);
    if (std::isnan(point->slope)) return say(probe_, tr("f is undefined"));
    if (std::isinf(point->slope)) return say(probe_, tr("infinite"));
    const double share = 100 * point->slope / point->maxGradient;
    say(probe_,
        tr("%1: %2 % of max_gradient")
            .arg(VerdictText::number(point->slope), QString::number(share, 'g', share < 100 ? 2 : 3)));
}

void GradientPanel::forget() {
    survey_ = {};
    complete_ = false;
    if (scene_ && chosen() < scene_->isosurfaces.size() && scene_->isosurfaces[chosen()].shape)
        survey_.setting = scene_->isosurfaces[chosen()].shape->rootSettings().maxGradient;
    show();
    emit reported(survey_);
}

void GradientPanel::forgetView() {
    survey_.alongRays = survey_.onSurface = 0;
    survey_.holes = {};
    survey_.enoughForView.reset();
    complete_ = false;
    show();
}

/// Measuring waits until the scene and the view have come to rest.
void GradientPanel::restart() {
    stop_.request_stop();
    ++generation_;
    measuring_ = active_ && !complete_ && scene_ && chosen() < scene_->isosurfaces.size();
    if (measuring_)
        restartTimer_.start();
    else
        restartTimer_.stop();
}

void GradientPanel::measure() {
    stop_ = std::stop_source();
    GradientSurveyRequest request;
    request.view.scene = scene_;
    request.view.camera = camera_;
    request.view.width = surveyWidth;
    request.view.height = std::clamp(surveyWidth * size_.height() / size_.width(), 1, 4 * surveyWidth);
    request.isosurface = chosen();
    const std::uint64_t generation = generation_;
    worker_.submit([this, request, generation, proofs = proofs_,
                    stop = stop_.get_token()](std::stop_token closing) mutable {
        const EitherStop either(stop, closing);
        if (proofs) request.proof = proofs->proofOf(*request.view.scene, request.isosurface);
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
            either.token());
    });
}

void GradientPanel::receive(GradientSurvey survey) {
    // What the new survey has not come to yet still holds: else it would have been forgotten.
    if (survey.histogram.empty()) survey.histogram = std::move(survey_.histogram);
    if (survey.bracket.boxes == 0) survey.bracket = survey_.bracket;
    if (!survey.enoughForView && !survey.finished) survey.enoughForView = survey_.enoughForView;
    survey_ = std::move(survey);
    complete_ = survey_.finished;
    show();
    emit reported(survey_);
    if (!survey_.finished) return;
    measuring_ = false;
    emit surveyed();
}

SurfaceVerdict GradientPanel::verdict() const {
    SurfaceVerdict verdict;
    verdict.isosurface = chosen();
    verdict.setting = survey_.setting;
    verdict.bracket = survey_.bracket;
    if (!survey_.holes.complete) return verdict;
    verdict.effects = SurfaceEffects{survey_.holes.mistakes(), {}, survey_.alongRays};
    verdict.pixels = survey_.holes.pixels.size();
    return verdict;
}

void GradientPanel::show() {
    const HoleMap& holes = survey_.holes;
    if (!holes.complete)
        say(holes_, nothing);
    else if (holes.mistakes() == 0)
        say(holes_, tr("none in %1 pixels").arg(holes.pixels.size()));
    else
        say(holes_, tr("%1 lost, %2 gained, %3 at a wrong place, of %4 pixels")
                        .arg(holes.count(HolePixel::lost))
                        .arg(holes.count(HolePixel::gained))
                        .arg(holes.count(HolePixel::wrongPlace))
                        .arg(holes.pixels.size()));
    say(alongRays_, survey_.alongRays > 0 ? VerdictText::number(survey_.alongRays) : nothing);
    say(onSurface_, survey_.onSurface > 0 ? tr("%1 at %2")
                                                .arg(VerdictText::number(survey_.onSurface),
                                                     VerdictText::place(survey_.steepestPoint))
                                          : nothing);
    showBracket();
    say(enough_,
        survey_.enoughForView
            ? tr("%1: enough for this view, not proven for others").arg(numberText(*survey_.enoughForView))
            : nothing);
    useEnough_->setEnabled(survey_.enoughForView.has_value());
}

void GradientPanel::showBracket() {
    const GradientBracket& b = survey_.bracket;
    const bool known = b.boxes > 0;
    const bool subject = survey_.setting > 0;
    headline_->setVisible(subject && known);
    headline_->setText(VerdictText::plain(verdict()));
    const QString setting = VerdictText::number(survey_.setting);
    say(setting_, !subject ? nothing
                  : known  ? tr("%1 (%2)").arg(setting, VerdictText::word(verdict()))
                           : setting);
    QString state;
    if (b.state == GradientState::running)
        state = tr(", tightening");
    else if (b.state == GradientState::unproven && std::isfinite(b.upper))
        state = tr(", budget spent");
    if (b.state == GradientState::unbounded)
        say(bracket_, tr("unbounded: %1 at %2")
                          .arg(VerdictText::hazard(b.singularity->kind), VerdictText::place(b.place)));
    else
        say(bracket_, known ? tr("%1 to %2%3, the first at %4")
                                  .arg(VerdictText::number(b.lower), VerdictText::number(b.upper), state,
                                       VerdictText::place(b.place))
                            : nothing);
    goThere_->setEnabled(known);
    const auto suggested = verdict().suggested();
    const double soFar = known ? suggestedGradient(b) : 0;
    if (suggested)
        say(suggested_, (b.seams ? tr("%1: enough but for jumps") : tr("%1: proven for every view"))
                            .arg(numberText(*suggested)));
    else
        // What may still become less is no suggestion yet.
        say(suggested_, b.state == GradientState::running && soFar > 0 && std::isfinite(soFar)
                            ? tr("at most %1 so far").arg(numberText(soFar))
                            : nothing);
    useSuggested_->setEnabled(suggested.has_value());
    QString note;
    if (!subject)
        note = tr("The scene has no isosurface to measure.");
    else if (b.singularity)
        note = tr("No bound at %1: %2. %3")
                   .arg(VerdictText::place(b.singularity->place), VerdictText::hazard(b.singularity->kind),
                        QString::fromUtf8(advice(b.singularity->kind).data(),
                                          static_cast<qsizetype>(advice(b.singularity->kind).size())));
    if (subject && b.beside && std::isfinite(b.beside->upper)) {
        const QString most = VerdictText::number(b.beside->suggested());
        note += ' ' + (b.beside->share > 0 ? tr("Farther than %1 from such places no gradient exceeds %2.")
                                                 .arg(VerdictText::number(b.beside->reach), most)
                                           : tr("Beside jumps no gradient exceeds %1.").arg(most));
    }
    if (subject && !b.singularity && b.seams && b.state != GradientState::running)
        note = tr("The bound holds beside places where the function may jump; none was found.");
    note_->setText(note);
    note_->setVisible(!note_->text().isEmpty());
}

}  // namespace isoscope

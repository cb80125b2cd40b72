// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/studies/verdict_controller.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <QDockWidget>
#include <QMouseEvent>
#include <utility>

#include "core/text/source_text.h"
#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/section/section_panel.h"
#include "widgets/section/section_plane.h"
#include "widgets/studies/gradient_panel.h"
#include "widgets/studies/repair_panel.h"
#include "widgets/timing.h"
#include "widgets/verdicts/problems_panel.h"
#include "widgets/verdicts/verdict_badge.h"
#include "widgets/verdicts/verdict_findings.h"
#include "widgets/verdicts/verdict_study.h"
#include "widgets/verdicts/verdict_symbol.h"
#include "widgets/verdicts/verdict_text.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// A picture that takes longer than this, in milliseconds, shares the processors with the study.
constexpr int picturePatience = 1500;
/// Of the container's size: so much around a place is shown.
constexpr double surroundings = 0.35;

double reachOf(const SceneIsosurface& isosurface) {
    const Bounds box = containerBounds(isosurface.shape->settings().container);
    const glm::dvec3 size = box.high - box.low;
    double most = 0;
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis(0);
        axis[k] = size[k];
        most = std::max(most, glm::length(isosurface.transform.direction(axis)));
    }
    return surroundings * most;
}

bool isAlarming(const SurfaceVerdict& verdict) {
    return verdict.verdict() == GradientVerdict::holes || verdict.verdict() == GradientVerdict::unbounded;
}

QString markLabel(const SurfaceVerdict& verdict) {
    return verdict.bracket.state == GradientState::unbounded
               ? VerdictController::tr("infinitely steep")
               : VerdictController::tr("steepest: %1").arg(VerdictText::number(verdict.bracket.lower));
}

}  // namespace

Camera cameraTowards(const Camera& camera, const glm::dvec3& place, double reach) {
    Camera moved = camera;
    const double length = glm::length(camera.direction), height = glm::length(camera.up);
    if (!(length > 0) || !(height > 0) || !(reach > 0) || !std::isfinite(reach)) return camera;
    const glm::dvec3 view = camera.direction / length;
    double distance = glm::distance(camera.location, place);
    if (camera.kind == CameraKind::perspective) distance = 2 * reach * length / height;
    moved.location = place - distance * view;
    moved.lookAt = place;
    return moved;
}

void showPlace(Viewport* viewport, const SceneIsosurface& isosurface, const glm::dvec3& place) {
    viewport->showCamera(
        cameraTowards(viewport->camera(), isosurface.transform.point(place), reachOf(isosurface)));
}

VerdictController::VerdictController(const Parts& parts, QObject* parent)
    : QObject(parent), parts_(parts), study_(new VerdictStudy(this)) {
    parts.gradient->setProofs(study_->proofs());
    resumeTimer_.setSingleShot(true);
    resumeTimer_.setInterval(timing::settlePause);
    patienceTimer_.setSingleShot(true);
    patienceTimer_.setInterval(picturePatience);
    for (QTimer* timer : {&resumeTimer_, &patienceTimer_})
        connect(timer, &QTimer::timeout, this, [this] { study_->setHeld(false); });
    connect(parts.viewport, &Viewport::viewChanged, this, [this] {
        hold();
        followView();
    });
    connect(parts.viewport, &Viewport::pictureFinished, this, [this] {
        followView();
        patienceTimer_.stop();
        resumeTimer_.start();
    });
    connect(parts.session, &SceneSession::sceneChanged, this, &VerdictController::hold);
    // A picture follows, and until then somebody waits for the text to be read.
    connect(parts.editor, &SceneEditor::numberReplaced, this, &VerdictController::hold);
    connect(parts.session, &SceneSession::parsed, this, &VerdictController::adopt);
    connect(parts.session, &SceneSession::readingSlowly, this, [this] {
        parts_.badge->showReading();
        showNothingToSay();
    });
    connect(parts.session, &SceneSession::readingEnded, this, &VerdictController::show);
    connect(parts.editor, &SceneEditor::textLoaded, this, [this] {
        result_.reset();
        showNothingToSay();
    });
    connect(study_, &VerdictStudy::changed, this, &VerdictController::show);
    connect(parts.repair, &RepairPanel::stopRequested, study_, &VerdictStudy::stop);
    connect(parts.repair, &RepairPanel::goOnRequested, study_, &VerdictStudy::goOn);
    connect(parts.badge, &VerdictBadge::chosen, this, &VerdictController::openPanel);
    connect(parts.gradient, &GradientPanel::placeRequested, this, &VerdictController::goTo);
    connect(parts.gradient, &GradientPanel::chosenChanged, this, [this] {
        study_->setChosen(parts_.gradient->chosen());
        showPlaces();
    });
    // Queued: the panel itself is told by others.
    connect(parts.gradientDock, &QDockWidget::visibilityChanged, this, &VerdictController::showPlaces,
            Qt::QueuedConnection);
    connect(parts.section, &SectionPanel::planeChanged, this, &VerdictController::showPlaces);
    parts.viewport->installEventFilter(this);
    showNothingToSay();
}

void VerdictController::setScene(const std::shared_ptr<const Scene>& scene) {
    if (!scene) result_.reset();
    followView();
    study_->setScene(scene);
    if (!scene) showNothingToSay();
}

void VerdictController::hold() {
    study_->setHeld(true);
    resumeTimer_.stop();
    patienceTimer_.start();
}

void VerdictController::followView() {
    const QSize size = parts_.viewport->size();
    study_->setView(fittedCamera(parts_.viewport->camera(), size.width(), size.height()), size);
}

void VerdictController::adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision) {
    if (revision != parts_.editor->revision()) return;
    result_ = result;
    lines_ = verdictLines(*result);
    show();
}

bool VerdictController::fitsText() const {
    if (!result_ || !result_->scene || !study_->judged()) return false;
    const auto sameFunction = [](const SceneIsosurface& a, const SceneIsosurface& b) {
        return a.functionText == b.functionText && a.number == b.number;
    };
    return std::ranges::equal(result_->scene->isosurfaces, study_->judged()->isosurfaces, sameFunction);
}

void VerdictController::show() {
    if (fitsText())
        parts_.badge->show(study_->verdicts(), lines_, neededGradients(study_->verdicts(), *result_));
    else
        parts_.badge->show(study_->verdicts(), {});
    parts_.repair->show(fitsText() ? result_ : nullptr, study_->verdicts(), study_->busy(),
                        study_->stopped());
    showInText();
    showPlaces();
    showNothingToSay();
}

void VerdictController::showInText() {
    // Places of another text would be wrong; marks in the margin move with their lines until the next parse.
    if (!fitsText()) {
        if (study_->verdicts().empty()) parts_.editor->setVerdicts({});
        return listFindings({});
    }
    std::vector<VerdictMarks::Mark> marks;
    for (const SurfaceVerdict& one : study_->verdicts()) {
        const int line = one.isosurface < lines_.size() ? lines_[one.isosurface] : 0;
        if (line == 0) continue;
        const QString text = VerdictText::plain(one) + ' ' + VerdictText::exact(one);
        marks.push_back({line - 1, one.verdict(), "<p>" + text.toHtmlEscaped() + "</p>"});
    }
    parts_.editor->setVerdicts(marks);
    listFindings(verdictFindings(study_->verdicts(), *result_));
}

/// Not for every step of a proof: rows with buttons would change under the mouse.
void VerdictController::listFindings(const Diagnostics& findings) {
    const auto same = [](const Diagnostic& a, const Diagnostic& b) {
        return a.id == b.id && a.message == b.message && a.fixes.size() == b.fixes.size();
    };
    if (study_->busy() && listedOf_ == result_ && std::ranges::equal(findings, listed_, same)) return;
    listed_ = findings;
    listedOf_ = result_;
    parts_.problems->setFindings(findings);
}

/// The worst isosurface of each statement: a macro or loop makes so many that marks would hide the picture.
std::set<const SurfaceVerdict*> VerdictController::alarms() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, const SurfaceVerdict*> worst;
    const auto rank = [](const SurfaceVerdict& one) {
        return std::pair(badness(one.verdict()), one.bracket.lower);
    };
    for (const SurfaceVerdict& one : study_->verdicts()) {
        if (!isAlarming(one)) continue;
        const SourceRange& range = study_->judged()->isosurfaces[one.isosurface].range;
        const SurfaceVerdict*& known = worst[{range.file, range.begin}];
        if (!known || rank(one) > rank(*known)) known = &one;
    }
    std::set<const SurfaceVerdict*> alarms;
    for (const auto& [statement, one] : worst) alarms.insert(one);
    return alarms;
}

void VerdictController::showPlaces() {
    const auto& scene = study_->judged();
    const std::set<const SurfaceVerdict*> alarming = alarms();
    std::vector<PlaceMark> marks;
    marked_.clear();
    for (const SurfaceVerdict& one : study_->verdicts()) {
        const bool looked = parts_.gradient->isActive() && one.isosurface == parts_.gradient->chosen() &&
                            one.bracket.boxes > 0;
        if (!alarming.contains(&one) && !looked) continue;
        const SceneIsosurface& isosurface = scene->isosurfaces[one.isosurface];
        marks.push_back({isosurface.transform.point(one.bracket.place), reachOf(isosurface), markLabel(one),
                         verdictSymbolColor(one.verdict(), Look::light)});
        marked_.push_back(one.isosurface);
    }
    parts_.viewport->placeMarks().set(std::move(marks));
    const SurfaceVerdict* cut = study_->verdictOf(parts_.section->subjectNumber());
    if (cut && cut->bracket.boxes > 0 && (isAlarming(*cut) || parts_.gradient->isActive()))
        parts_.section->markPlace(cut->bracket.place, markLabel(*cut),
                                  verdictSymbolColor(cut->verdict(), Look::light));
    else
        parts_.section->unmarkPlace();
}

void VerdictController::showNothingToSay() {
    const std::vector<SurfaceVerdict>& verdicts = study_->verdicts();
    const auto worst = std::ranges::max_element(
        verdicts, {}, [](const SurfaceVerdict& one) { return badness(one.verdict()); });
    QString text = tr("No problems. Everything in the text is shown.");
    if (!result_ || parts_.session->busy())
        text = tr("The text is still being read.");
    else if (worst != verdicts.end() && badness(worst->verdict()) > badness({}))
        text = tr("The text has no mistakes.") + ' ' + VerdictText::plain(*worst);
    else if (study_->busy())
        text = tr("No problems so far. Whether POV-Ray's picture has holes is being found out.");
    else if (worst != verdicts.end())
        text += ' ' + tr("POV-Ray's picture has no holes: that is proven.");
    parts_.problems->setEmptyText(text);
}

void VerdictController::openPanel(std::size_t isosurface) {
    parts_.gradient->choose(isosurface);
    parts_.gradientDock->show();
    parts_.gradientDock->raise();
}

void VerdictController::goTo(std::size_t isosurface, const glm::dvec3& place) {
    const auto& scene = study_->judged();
    if (!scene || isosurface >= scene->isosurfaces.size() || !scene->isosurfaces[isosurface].shape) return;
    showPlace(parts_.viewport, scene->isosurfaces[isosurface], place);
}

bool VerdictController::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
        event->type() != QEvent::MouseButtonRelease)
        return QObject::eventFilter(watched, event);
    const auto* mouse = static_cast<QMouseEvent*>(event);
    // There a click asks for the ray.
    if (parts_.viewport->picking()) return false;
    const auto mark = parts_.viewport->placeMarks().markAt(mouse->position(), parts_.viewport->projection());
    if (event->type() == QEvent::MouseButtonPress) {
        pressed_ =
            mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier ? mark : std::nullopt;
        return pressed_.has_value();
    }
    if (event->type() == QEvent::MouseMove) {
        if (pressed_) return true;
        if (!mark || mouse->buttons() != Qt::NoButton) return false;
        parts_.viewport->setCursor(Qt::PointingHandCursor);
        return true;
    }
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (!pressed) return false;
    const SurfaceVerdict* verdict =
        *pressed < marked_.size() ? study_->verdictOf(marked_[*pressed]) : nullptr;
    if (mark == pressed && verdict) goTo(verdict->isosurface, verdict->bracket.place);
    return true;
}

}  // namespace isoscope

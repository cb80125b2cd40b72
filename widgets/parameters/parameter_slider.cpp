// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_slider.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>

#include "widgets/elided_label.h"
#include "widgets/icons.h"
#include "widgets/interface_style.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/number_text.h"
#include "widgets/numbers/slider_scale.h"
#include "widgets/parameters/band_slider.h"
#include "widgets/studies/cost_strip.h"

namespace isoscope {
namespace {

constexpr int settleTime = 400;  // as long as the editor's undo group
constexpr int buttonIcon = 16;

/// Labels in a smaller, softer type for the ends of the range.
void makeSmall(QLabel* label) {
    QFont font = QApplication::font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    label->setFont(font);
    label->setForegroundRole(QPalette::PlaceholderText);
}

/// Whether a slider shows the same of both; where they stand in the text is not seen, nor here their values.
bool looksLike(const SceneParameter& a, const SceneParameter& b) {
    return a.role == b.role && a.name == b.name && a.group == b.group && a.minimum == b.minimum &&
           a.maximum == b.maximum && a.logarithmic == b.logarithmic && a.integral == b.integral &&
           a.expression == b.expression && a.text == b.text && a.implied == b.implied;
}

}  // namespace

ParameterSlider::ParameterSlider(const SceneParameter& parameter, QWidget* parent)
    : QWidget(parent), parameter_(parameter), value_(parameter.value), initial_(parameter.value) {
    // All that it asks for is there now.
    scale_ = std::make_unique<SliderScale>(proposedScale());
    settle_.setSingleShot(true);
    settle_.setInterval(settleTime);
    connect(&settle_, &QTimer::timeout, this, &ParameterSlider::endChange);
    name_ = new ElidedLabel(this);
    name_->setText(name());
    name_->installEventFilter(this);
    if (parameter.expression)
        buildExpression();
    else
        buildSlider();
    setParameter(parameter);
}

ParameterSlider::~ParameterSlider() = default;

QString ParameterSlider::name() const { return QString::fromStdString(parameter_.name); }

void ParameterSlider::buildSlider() {
    slider_ = new BandSlider(this);
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->installEventFilter(this);
    constexpr int shortest = 60;
    slider_->setMinimumWidth(shortest);
    box_ = new NumberBox(this);
    box_->installEventFilter(this);
    box_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    minimum_ = new QLabel(this);
    maximum_ = new QLabel(this);
    for (QLabel* end : {minimum_, maximum_}) {
        end->installEventFilter(this);
    }
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 2, 0, 2);
    layout->setHorizontalSpacing(6);
    layout->setVerticalSpacing(1);
    buildButtons();
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(0);
    for (QToolButton* button : {playButton_, lock_, more_}) buttons->addWidget(button);
    layout->addWidget(name_, 0, 0);
    layout->addLayout(buttons, 0, 1);
    layout->addWidget(box_, 0, 2);
    auto* ends = new QGridLayout;
    ends->setVerticalSpacing(1);
    ends->addWidget(minimum_, 0, 0);
    ends->addWidget(slider_, 0, 1);
    ends->addWidget(maximum_, 0, 2);
    ends->setColumnStretch(1, 1);
    layout->addLayout(ends, 1, 0, 1, 3);
    layout->setColumnStretch(0, 1);
    fitLetters();
    if (parameter_.role == ParameterRole::accuracy || parameter_.role == ParameterRole::maxGradient)
        buildStrip(ends);

    connect(slider_, &QSlider::sliderPressed, this, [this] {
        pressed_ = true;
        beginChange();
    });
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        pressed_ = false;
        endChange();
    });
    connect(slider_, &QSlider::valueChanged, this, [this](int step) { userSet(scale_->value(step)); });
    connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double value) { userSet(value); });
}

void ParameterSlider::fitLetters() {
    for (QLabel* label : {minimum_, maximum_, static_cast<QLabel*>(cost_)})
        if (label) makeSmall(label);
    if (!box_) return;
    const int buttonsAndFrame = interfaceLength(28);
    box_->setMinimumWidth(fontMetrics().horizontalAdvance("-0.000") + buttonsAndFrame);
    box_->setMaximumWidth(fontMetrics().horizontalAdvance("-0.0000000") + buttonsAndFrame);
}

void ParameterSlider::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitLetters();
}

void ParameterSlider::buildButtons() {
    const auto make = [this](const char* icon) {
        auto* button = new QToolButton(this);
        button->setAutoRaise(true);
        button->setIcon(themeIcon(icon));
        setIconEdge(button, buttonIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        return button;
    };
    playButton_ = make("media-playback-start");
    playButton_->setCheckable(true);
    playButton_->hide();
    connect(playButton_, &QToolButton::clicked, this, [this](bool on) {
        // Whoever plays sets it.
        playButton_->setChecked(playing_);
        emit playRequested(on);
    });
    lock_ = make("object-locked");
    more_ = make("overflow-menu");
    if (more_->icon().isNull()) more_->setText(tr("More"));
    connect(lock_, &QToolButton::clicked, this, [this] { setLocked(false); });
    connect(more_, &QToolButton::clicked, this,
            [this] { openMenu(more_->mapToGlobal(QPoint(0, more_->height()))); });
}

void ParameterSlider::buildStrip(QGridLayout* layout) {
    strip_ = new CostStrip(this);
    strip_->setSubject(fullName());
    layout->addWidget(strip_, 1, 1);
    cost_ = new ElidedLabel(this);
    makeSmall(cost_);
    layout->addWidget(cost_, 2, 0, 1, 3);
    connect(strip_, &CostStrip::chosen, this, &ParameterSlider::userSet);
    connect(strip_, &CostStrip::summaryChanged, this, [this] {
        cost_->setText(strip_->summary());
        cost_->setToolTip(strip_->detail(value_));
    });
}

void ParameterSlider::buildExpression() {
    expression_ = new ElidedLabel(this);
    QFont font = expression_->font();
    font.setItalic(true);
    expression_->setFont(font);
    replace_ = new QToolButton(this);
    replace_->setText(tr("Replace by number"));
    replace_->setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 2, 0, 2);
    layout->setVerticalSpacing(1);
    layout->addWidget(name_, 0, 0);
    layout->addWidget(replace_, 0, 1, Qt::AlignRight);
    layout->addWidget(expression_, 1, 0, 1, 2);
    layout->setColumnStretch(0, 1);
    connect(replace_, &QToolButton::clicked, this, &ParameterSlider::replaceExpressionRequested);
}

bool ParameterSlider::canShow(const SceneParameter& parameter) const {
    return parameter.expression == parameter_.expression && parameter.logarithmic == parameter_.logarithmic &&
           parameter.integral == parameter_.integral && parameter.role == parameter_.role &&
           parameter.name == parameter_.name;
}

void ParameterSlider::setParameter(const SceneParameter& parameter, const std::optional<SliderNote>& note) {
    const bool held = dragging_ || playing_;
    // Every parse tells all sliders of their parameters, and few of these have changed.
    const bool sameNote = note == note_ && noteOfText_ == note.has_value();
    const bool nothingNew =
        upToDate_ && !held && sameNote && value_ == parameter.value && looksLike(parameter, parameter_);
    parameter_ = parameter;
    if (nothingNew) return;
    upToDate_ = !held;
    if (held) return showTexts();
    const bool noteGone = noteOfText_ && !note;
    if (note || noteGone) note_ = note;
    noteOfText_ = note.has_value();
    const SliderScale proposed = proposedScale();
    const bool keep = !note_ && !noteGone && parameter.role != ParameterRole::argument &&
                      scale_->contains(parameter.value) && scale_->kind() == proposed.kind();
    if (!keep) *scale_ = proposed;
    value_ = parameter.value;
    showNote();
    showValue();
    showTexts();
}

void ParameterSlider::setValue(double value) {
    if (dragging_ || playing_ || !std::isfinite(value)) return;
    value_ = value;
    showValue();
}

double ParameterSlider::minimum() const { return scale_->minimum(); }
double ParameterSlider::maximum() const { return scale_->maximum(); }
double ParameterSlider::resolution() const { return scale_->resolution(value_); }

void ParameterSlider::setInitialValue(double value) {
    initial_ = value;
    showTexts();
}

void ParameterSlider::showValue() {
    if (!slider_) return;
    *scale_ = scale_->widenedTo(value_);
    const QSignalBlocker quietSlider(slider_), quietBox(box_);
    slider_->setRange(0, scale_->steps());
    slider_->setPageStep(std::max(1, scale_->steps() / 20));
    slider_->setValue(scale_->step(value_));
    box_->setResolution(scale_->resolution(value_));
    box_->setIntegral(scale_->kind() == SliderScale::Kind::integral);
    // A number that is being typed is not taken away.
    if (box_->value() != value_ || !box_->hasFocus()) box_->setValue(value_);
    minimum_->setText(numberText(scale_->minimum()));
    maximum_->setText(numberText(scale_->maximum()));
    showPresence();
    if (!strip_) return;
    strip_->setScale(*scale_, style()->pixelMetric(QStyle::PM_SliderLength, nullptr, slider_) / 2);
    strip_->setValue(value_);
}

void ParameterSlider::setPresence(const ParameterRange& presence) {
    if (!slider_) return;
    presence_ = presence;
    presenceOld_ = false;
    showPresence();
    showTexts();
}

void ParameterSlider::setPresenceOld() {
    if (presenceOld_ || presence_.pieces.empty()) return;
    presenceOld_ = true;
    showPresence();
}

void ParameterSlider::showPresence() {
    std::vector<BandSlider::Span> spans;
    for (const PresencePiece& piece : presence_.pieces) {
        const bool certain = piece.presence == SurfacePresence::surface;
        if (!certain && piece.presence != SurfacePresence::unknown) continue;
        if (piece.high < scale_->minimum() || piece.low > scale_->maximum()) continue;
        spans.push_back({scale_->step(piece.low), scale_->step(piece.high), certain});
    }
    slider_->setBand(std::move(spans), presenceOld_);
}

void ParameterSlider::showTexts() {
    // One number may stand for a vector.
    const bool vector = parameter_.role == ParameterRole::container &&
                        (parameter_.name == "center" || parameter_.name.ends_with("corner"));
    name_->setText(parameter_.implied ? tr("%1 (default)").arg(name())
                   : vector           ? tr("%1 (x, y and z)").arg(name())
                                      : name());
    if (expression_) {
        const QString text = QString::fromStdString(parameter_.text);
        expression_->setText(text);
        expression_->setToolTip(tr("%1 is the expression %2").arg(fullName(), text));
        expression_->setAccessibleName(tr("Expression of %1").arg(fullName()));
        name_->setToolTip(fullName());
        replace_->setToolTip(tr("Writes %1 in place of the expression, which gives it a slider")
                                 .arg(numberText(parameter_.value)));
        replace_->setAccessibleName(tr("Replace the expression of %1 by a number").arg(fullName()));
        return;
    }
    name_->setToolTip(parameter_.implied
                          ? tr("%1 is not in the text; moving the slider writes it").arg(fullName())
                          : tr("%1. Double-click: back to %2").arg(fullName(), numberText(initial_)));
    QString help = tr("%1, from %2 to %3").arg(fullName(), minimum_->text(), maximum_->text());
    const auto shown = presence_.shown();
    if (shown)
        help +=
            '\n' + tr("There can be a surface from %1 to %2, the green part; for no other value of the "
                      "slider, all else as it is")
                       .arg(numberText(shown->first, resolution()), numberText(shown->second, resolution()));
    else if (!presence_.pieces.empty())
        help += '\n' + tr("There is no surface for any value of the slider, all else as it is");
    slider_->setToolTip(help);
    slider_->setAccessibleName(tr("%1, slider").arg(fullName()));
    box_->setToolTip(tr("Value of %1").arg(fullName()));
    box_->setAccessibleName(fullName());
    minimum_->setToolTip(tr("Lower end of the slider. Double-click to change it"));
    maximum_->setToolTip(tr("Upper end of the slider. Double-click to change it"));
    minimum_->setAccessibleName(tr("Lower end of %1").arg(fullName()));
    maximum_->setAccessibleName(tr("Upper end of %1").arg(fullName()));
    playButton_->setToolTip(
        playing_ ? tr("Stop (Esc)")
                 : tr("Play: moves %1 by itself, until Esc or a touch of the slider").arg(fullName()));
    playButton_->setAccessibleName(playing_ ? tr("Stop %1").arg(fullName()) : tr("Play %1").arg(fullName()));
    lock_->setToolTip(tr("%1 is locked. Click to move it again").arg(fullName()));
    lock_->setAccessibleName(tr("Unlock %1").arg(fullName()));
    more_->setToolTip(tr("Range, step, lock and more of %1").arg(fullName()));
    more_->setAccessibleName(tr("Menu of %1").arg(fullName()));
}

QString ParameterSlider::fullName() const {
    const QString group = QString::fromStdString(parameter_.group);
    return group.isEmpty() ? name() : group + ' ' + name();
}

void ParameterSlider::userSet(double value) {
    if (decimals() >= 0) value = numberTextWith(value, decimals()).toDouble();
    stopPlaying();
    if (isLocked() || !std::isfinite(value) || value == value_) return;
    beginChange();
    value_ = value;
    parameter_.value = value;
    showValue();
    emit valueChanged(value);
}

void ParameterSlider::beginChange() {
    const bool first = !dragging_;
    dragging_ = true;
    // A mouse says when it lets go; keys and wheel do not.
    if (pressed_)
        settle_.stop();
    else
        settle_.start();
    if (first) emit dragStarted();
}

void ParameterSlider::endChange() {
    settle_.stop();
    if (!dragging_ || pressed_) return;
    dragging_ = false;
    emit dragFinished();
}

void ParameterSlider::resetToInitial() {
    if (slider_) userSet(initial_);
}

bool ParameterSlider::eventFilter(QObject* watched, QEvent* event) {
    if (watched == box_) {
        const auto* focus = event->type() == QEvent::FocusIn ? static_cast<QFocusEvent*>(event) : nullptr;
        if (focus && focus->reason() != Qt::ActiveWindowFocusReason) stopPlaying();
        return false;
    }
    if (watched == slider_) return sliderEvent(event);
    const bool twice = event->type() == QEvent::MouseButtonDblClick &&
                       static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton;
    if (watched == name_ && twice) {
        resetToInitial();
        return true;
    }
    const bool onEnd = watched == minimum_ || watched == maximum_;
    if (onEnd && watched && (twice || event->type() == QEvent::ContextMenu)) {
        editEnd(static_cast<QLabel*>(watched));
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

bool ParameterSlider::sliderEvent(QEvent* event) {
    if (event->type() == QEvent::Wheel && !slider_->hasFocus()) {
        // The wheel scrolls the panel; only who has chosen this slider changes it.
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress) {
        stopPlaying();
        const auto* mouse = static_cast<QMouseEvent*>(event);
        QStyleOptionSlider option;
        option.initFrom(slider_);
        option.minimum = slider_->minimum();
        option.maximum = slider_->maximum();
        option.sliderPosition = option.sliderValue = slider_->sliderPosition();
        const QRect handle =
            style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider_);
        if (mouse->button() == Qt::LeftButton && !handle.contains(mouse->pos())) {
            // The handle comes to the mouse; the event then takes hold of it.
            slider_->setValue(QStyle::sliderValueFromPosition(slider_->minimum(), slider_->maximum(),
                                                              mouse->pos().x() - handle.width() / 2,
                                                              slider_->width() - handle.width()));
        }
    }
    return false;
}

}  // namespace isoscope

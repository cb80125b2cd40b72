// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline_panel.h"

#include <algorithm>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/icons.h"
#include "widgets/numbers/number_box.h"
#include "widgets/numbers/undo_group.h"
#include "widgets/timeline/timeline_view.h"

namespace isoscope {

namespace {

constexpr double leastRate = 0.01;
constexpr double mostRate = 1000;
constexpr double mostClock = 1e9;

}  // namespace

TimelinePanel::TimelinePanel(QWidget* parent) : QWidget(parent), view_(new TimelineView(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(3);
    auto* tools = new QHBoxLayout;
    tools->setSpacing(2);
    buildTransport(tools);
    tools->addSpacing(12);
    buildKeys(tools);
    tools->addStretch(1);
    column->addLayout(tools);
    column->addWidget(view_, 1);
    auto* range = new QHBoxLayout;
    range->setSpacing(4);
    buildRange(range);
    column->addLayout(range);
    clock_->hide();
    leastWidth_ = column->minimumSize().width();
    rangeWidth_ = range->minimumSize().width();
    settle_.setSingleShot(true);
    settle_.setInterval(UndoGroup::pause);
    connect(&settle_, &QTimer::timeout, this, &TimelinePanel::frameSettled);
    connectView();
    setAccessibleName(tr("Timeline"));
    setTimeline({}, {});
}

QToolButton* TimelinePanel::addButton(QHBoxLayout* line, const char* icon, const QString& name,
                                      const QString& help) {
    auto* button = new QToolButton(this);
    button->setAutoRaise(true);
    button->setIcon(themeIcon(icon));
    button->setText(name);
    button->setAccessibleName(name);
    button->setToolTip(help);
    button->setFocusPolicy(Qt::StrongFocus);
    line->addWidget(button);
    return button;
}

QSpinBox* TimelinePanel::addFrameBox(QHBoxLayout* line, const QString& name, const QString& help) {
    auto* box = new QSpinBox(this);
    box->setRange(0, mostFrames);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    box->setToolTip(help);
    box->setMaximumWidth(fontMetrics().horizontalAdvance("0000000") + 40);
    line->addWidget(box);
    return box;
}

NumberBox* TimelinePanel::addNumberBox(QHBoxLayout* line, const QString& name, const QString& help) {
    auto* box = new NumberBox(this);
    box->setKeyboardTracking(false);
    box->setAccessibleName(name);
    box->setToolTip(help);
    box->setResolution(1);
    box->setMaximumWidth(fontMetrics().horizontalAdvance("-00000.000") + 30);
    line->addWidget(box);
    return box;
}

void TimelinePanel::buildTransport(QHBoxLayout* line) {
    QToolButton* begin =
        addButton(line, "media-skip-backward", tr("First frame"), tr("Go to the first frame"));
    connect(begin, &QToolButton::clicked, this, [this] { pick(timeline_.frames.first); });
    play_ = addButton(line, "media-playback-start", tr("Play the animation"),
                      tr("Play the frames in their time; Esc stops"));
    play_->setCheckable(true);
    connect(play_, &QToolButton::clicked, this, &TimelinePanel::playRequested);
    QToolButton* end = addButton(line, "media-skip-forward", tr("Last frame"), tr("Go to the last frame"));
    connect(end, &QToolButton::clicked, this, [this] { pick(timeline_.frames.last); });
    loop_ = addButton(line, "media-playlist-repeat", tr("Repeat"), tr("Begin anew at the last frame"));
    loop_->setCheckable(true);
    loop_->setChecked(true);
    line->addSpacing(6);
    auto* label = new QLabel(tr("F&rame"), this);
    line->addWidget(label);
    frame_ = addFrameBox(line, tr("Present frame"), tr("The frame that is shown"));
    label->setBuddy(frame_);
    connect(frame_, &QSpinBox::valueChanged, this, &TimelinePanel::pick);
}

void TimelinePanel::buildKeys(QHBoxLayout* line) {
    key_ = addButton(line, "keyframe", tr("Set Key"),
                     tr("Keep the present value of a number, or the view, at this frame; in the text"));
    key_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    key_->setPopupMode(QToolButton::InstantPopup);
    keyMenu_ = new QMenu(key_);
    keyMenu_->setToolTipsVisible(true);
    key_->setMenu(keyMenu_);
    connect(keyMenu_, &QMenu::aboutToShow, this, &TimelinePanel::fillKeyMenu);
    remove_ = addButton(line, "edit-delete", tr("Remove key"),
                        tr("Take the key of the chosen row at this frame away (Delete)"));
    connect(remove_, &QToolButton::clicked, this, &TimelinePanel::removeKeys);
    easing_ = new QComboBox(this);
    for (const Easing easing : allEasings) easing_->addItem(easingTitle(easing), static_cast<int>(easing));
    easing_->setAccessibleName(tr("Way to the next key"));
    easing_->setToolTip(
        tr("How the value goes from the key of the chosen row at this frame to its next one"));
    line->addWidget(easing_);
    connect(easing_, &QComboBox::activated, this,
            [this](int index) { chooseEasing(static_cast<Easing>(easing_->itemData(index).toInt())); });
}

void TimelinePanel::buildRange(QHBoxLayout* line) {
    const auto word = [&](const QString& text) {
        auto* label = new QLabel(text, this);
        line->addWidget(label);
        return label;
    };
    QLabel* frames = word(tr("Fra&mes"));
    first_ = addFrameBox(line, tr("First frame of the animation"), tr("Number of the first frame"));
    frames->setBuddy(first_);
    word(tr("to"));
    last_ = addFrameBox(line, tr("Last frame of the animation"), tr("Number of the last frame"));
    line->addSpacing(8);
    rate_ = addNumberBox(line, tr("Frames per second"), tr("How fast the animation plays"));
    rate_->setRange(leastRate, mostRate);
    word(tr("per second"));
    buildClock();
    line->addWidget(clock_);
    // Only now: one of them reads all.
    for (QSpinBox* box : {first_, last_})
        connect(box, &QSpinBox::valueChanged, this, &TimelinePanel::changeRange);
    for (NumberBox* box : {rate_, firstClock_, lastClock_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &TimelinePanel::changeRange);
    line->addStretch(1);
    QToolButton* out = addButton(line, "document-export", tr("Export"),
                                 tr("Draw all frames into pictures, and a film where ffmpeg is installed"));
    out->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(out, &QToolButton::clicked, this, &TimelinePanel::exportRequested);
}

void TimelinePanel::buildClock() {
    clock_ = new QWidget(this);
    auto* line = new QHBoxLayout(clock_);
    line->setContentsMargins(8, 0, 0, 0);
    line->setSpacing(4);
    auto* label = new QLabel(tr("cl&ock"), clock_);
    line->addWidget(label);
    firstClock_ = addNumberBox(line, tr("Clock of the first frame"),
                               tr("The value of clock in the first frame, for the text and for POV-Ray"));
    label->setBuddy(firstClock_);
    line->addWidget(new QLabel(tr("to"), clock_));
    lastClock_ = addNumberBox(line, tr("Clock of the last frame"),
                              tr("The value of clock in the last frame, for the text and for POV-Ray"));
    for (NumberBox* box : {firstClock_, lastClock_}) box->setRange(-mostClock, mostClock);
}

void TimelinePanel::resizeEvent(QResizeEvent*) {
    // In a narrow panel the text alone sets the clock.
    const QMargins margins = layout()->contentsMargins();
    const int others = rangeWidth_ + margins.left() + margins.right();
    clock_->setVisible(width() > others + clock_->sizeHint().width());
}

QSize TimelinePanel::minimumSizeHint() const { return {leastWidth_, QWidget::minimumSizeHint().height()}; }

void TimelinePanel::connectView() {
    connect(view_, &TimelineView::framePicked, this, &TimelinePanel::pick);
    connect(view_, &TimelineView::frameReleased, this, &TimelinePanel::settle);
    connect(view_, &TimelineView::rowChosen, this, &TimelinePanel::showKey);
    connect(view_, &TimelineView::removeRequested, this, &TimelinePanel::removeKeys);
    connect(view_, &TimelineView::menuRequested, this, &TimelinePanel::openMenu);
    connect(view_, &TimelineView::keyMoved, this, [this](int row, int from, int to) {
        if (row < 0 || row >= static_cast<int>(view_->rows().size())) return;
        Timeline wanted = timeline_;
        bool moved = false;
        for (const std::string& track : view_->rows()[static_cast<std::size_t>(row)].tracks)
            moved = wanted.moveKey(track, from, to) || moved;
        if (moved) emit timelineChanged(wanted);
    });
}

void TimelinePanel::setTimeline(const Timeline& timeline, const std::vector<std::string>& missing) {
    timeline_ = timeline;
    view_->setTimeline(timeline, missing);
    const auto set = [](auto* box, auto value) {
        const QSignalBlocker quiet(box);
        box->setValue(value);
    };
    set(first_, timeline.frames.first);
    set(last_, timeline.frames.last);
    set(rate_, timeline.rate);
    set(firstClock_, timeline.frames.firstClock);
    set(lastClock_, timeline.frames.finalClock);
    const QSignalBlocker quiet(frame_);
    frame_->setRange(timeline.frames.first, timeline.frames.last);
    frame_->setValue(view_->frame());
    showKey();
}

void TimelinePanel::setFrame(int frame) {
    view_->setFrame(frame);
    const QSignalBlocker quiet(frame_);
    frame_->setValue(frame);
    showKey();
}

int TimelinePanel::frame() const { return view_->frame(); }

void TimelinePanel::setPlaying(bool playing) {
    play_->setChecked(playing);
    play_->setIcon(themeIcon(playing ? "media-playback-pause" : "media-playback-start"));
    play_->setAccessibleName(playing ? tr("Stop the animation") : tr("Play the animation"));
}

bool TimelinePanel::loops() const { return loop_->isChecked(); }

void TimelinePanel::pick(int frame) {
    setFrame(frame);
    emit framePicked(frame);
    if (!view_->isDragging()) settle_.start();
}

void TimelinePanel::settle() {
    settle_.stop();
    emit frameSettled();
}

void TimelinePanel::fillKeyMenu() {
    keyMenu_->clear();
    keyMenu_->addAction(tr("What differs from its keys"), this, &TimelinePanel::changedKeysRequested)
        ->setToolTip(tr("A key for each number with keys, and for the view, that differs from them now"));
    keyMenu_->addAction(tr("View"), this, &TimelinePanel::cameraKeyRequested)
        ->setToolTip(tr("A key for the camera: the present view"));
    keyMenu_->addSeparator();
    for (const QString& name : std::as_const(numbers_))
        keyMenu_
            ->addAction(QString(name).replace('&', "&&"), this,
                        [this, name] { emit numberKeyRequested(name); })
            ->setToolTip(tr("A key for this number: its present value"));
}

void TimelinePanel::openMenu(QPoint place) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool key = view_->row() && view_->row()->hasKey(timeline_, frame());
    for (const Easing easing : allEasings) {
        QAction* action =
            menu->addAction(easingTitle(easing), this, [this, easing] { chooseEasing(easing); });
        action->setCheckable(true);
        action->setChecked(key && view_->row()->easing(timeline_, frame()) == easing);
        action->setEnabled(key);
    }
    menu->addSeparator();
    menu->addAction(remove_->icon(), tr("Remove key"), this, &TimelinePanel::removeKeys)->setEnabled(key);
    menu->popup(place);
}

void TimelinePanel::changeKeys(const std::function<void(Timeline&, const std::string&)>& change) {
    const TimelineRow* row = view_->row();
    if (!row || !row->hasKey(timeline_, frame())) return;
    settle();
    Timeline wanted = timeline_;
    for (const std::string& track : row->tracks) change(wanted, track);
    if (!(wanted == timeline_)) emit timelineChanged(wanted);
}

void TimelinePanel::chooseEasing(Easing easing) {
    changeKeys([this, easing](Timeline& timeline, const std::string& track) {
        timeline.setEasing(track, frame(), easing);
    });
}

void TimelinePanel::removeKeys() {
    changeKeys([this](Timeline& timeline, const std::string& track) { timeline.removeKey(track, frame()); });
}

void TimelinePanel::changeRange() {
    Timeline wanted = timeline_;
    wanted.stated = true;
    wanted.rate = rate_->value();
    wanted.frames.first = first_->value();
    wanted.frames.last = std::max(first_->value(), last_->value());
    wanted.frames.firstClock = firstClock_->value();
    wanted.frames.finalClock = lastClock_->value();
    if (!(wanted == timeline_)) emit timelineChanged(wanted);
}

void TimelinePanel::showKey() {
    const TimelineRow* row = view_->row();
    const bool key = row && row->hasKey(timeline_, frame());
    remove_->setEnabled(key);
    easing_->setEnabled(key);
    const Easing easing = key ? row->easing(timeline_, frame()) : Easing::smooth;
    easing_->setCurrentIndex(easing_->findData(static_cast<int>(easing)));
}

}  // namespace isoscope

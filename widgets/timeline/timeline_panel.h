// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QTimer>
#include <QWidget>

#include "core/animation/timeline.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QSpinBox;
class QToolButton;

namespace isoscope {

class NumberBox;
class TimelineView;

/// The frames of the scene's animation and the keys of its numbers, with what goes to a frame, plays, sets
/// and removes keys. All changes are asked for by signals; setTimeline() shows what became of them.
class TimelinePanel : public QWidget {
    Q_OBJECT
  public:
    explicit TimelinePanel(QWidget* parent = nullptr);

    /// What is shown; `missing` are names of tracks that the text has no number for.
    void setTimeline(const Timeline& timeline, const std::vector<std::string>& missing);
    /// The numbers that can get keys, by their names in presets.
    void setNumbers(const QStringList& names) { numbers_ = names; }
    /// Shows another frame; emits nothing.
    void setFrame(int frame);
    int frame() const;
    void setPlaying(bool playing);
    /// Whether it begins anew at the last frame.
    bool loops() const;
    TimelineView* view() const { return view_; }
    /// The entries are those of the present text once it has shown.
    QMenu* keyMenu() const { return keyMenu_; }

    /// Without the clock, which is not shown where there is no room for it.
    QSize minimumSizeHint() const override;

  public slots:
    /// A frame that was chosen by keys or the box is held no longer.
    void settle();

  signals:
    /// The person goes to a frame ...
    void framePicked(int frame);
    /// ... and stays there.
    void frameSettled();
    void playRequested(bool on);
    /// A key at the present frame: for a number by its name, for the camera, or for all that has keys and
    /// differs from them.
    void numberKeyRequested(const QString& name);
    void cameraKeyRequested();
    void changedKeysRequested();
    /// What the timeline is to be.
    void timelineChanged(const isoscope::Timeline& timeline);
    void exportRequested();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QToolButton* addButton(QHBoxLayout* line, const char* icon, const QString& name, const QString& help);
    QSpinBox* addFrameBox(QHBoxLayout* line, const QString& name, const QString& help);
    NumberBox* addNumberBox(QHBoxLayout* line, const QString& name, const QString& help);
    void buildTransport(QHBoxLayout* line);
    void buildKeys(QHBoxLayout* line);
    void buildRange(QHBoxLayout* line);
    void buildClock();
    void connectView();
    void fillKeyMenu();
    void openMenu(QPoint place);
    void pick(int frame);
    /// The timeline with the keys of the chosen row at the present frame changed.
    void changeKeys(const std::function<void(Timeline&, const std::string& track)>& change);
    void chooseEasing(Easing easing);
    void removeKeys();
    void changeRange();
    void showKey();

    Timeline timeline_;
    QStringList numbers_;
    TimelineView* view_;
    QToolButton *play_ = nullptr, *loop_ = nullptr, *key_ = nullptr, *remove_ = nullptr;
    QMenu* keyMenu_ = nullptr;
    QComboBox* easing_ = nullptr;
    QSpinBox *frame_ = nullptr, *first_ = nullptr, *last_ = nullptr;
    NumberBox *rate_ = nullptr, *firstClock_ = nullptr, *lastClock_ = nullptr;
    int leastWidth_ = 0;        ///< without the clock
    int rangeWidth_ = 0;        ///< of the lowest line, the same
    QWidget* clock_ = nullptr;  ///< what sets the clock, where there is room for it
    QTimer settle_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <utility>
#include <vector>

#include "core/animation/animation.h"
#include "widgets/document/scene_session.h"
#include "widgets/play_clock.h"
#include "widgets/state_history.h"

namespace isoscope {

class HistoryController;
class ParameterBinding;
class ParameterPanel;
class SceneEditor;
class TimelinePanel;
class Viewport;

/// Brings the scene to the frames that the TimelinePanel asks for, and its keys into the text. While frames
/// go by the text stays; when they rest it gets the numbers of the last one: one step for undo, together with
/// the view and the place on the timeline.
class TimelineController : public QObject {
    Q_OBJECT
  public:
    /// What the timeline moves; the controller owns none of them.
    struct Parts {
        SceneEditor* editor;
        SceneSession* session;
        ParameterPanel* parameters;
        ParameterBinding* binding;
        Viewport* viewport;
        TimelinePanel* panel;
        HistoryController* history;
    };

    /// The parts must outlive the controller.
    explicit TimelineController(const Parts& parts, QObject* parent = nullptr);
    ~TimelineController() override;

    /// Frames follow one another by themselves.
    bool isPlaying() const { return clock_.isRunning(); }
    /// Frames go by, and the text does not know yet.
    bool isMoving() const { return moving_; }

  public slots:
    /// Frames rest; what plays stops.
    void settle();
    void setKeyForNumber(const QString& name);
    void setKeyForCamera();
    void setChangedKeys();

  signals:
    /// Frames begin to go by, or rest.
    void movingChanged(bool moving);
    /// For the status line.
    void said(const QString& message);

  private:
    void connectPanel();
    void adopt(const std::shared_ptr<const ParseResult>& result, quint64 revision);
    void readText();
    void forget();
    void begin();
    /// Whether there is a picture to wait for.
    bool show(int frame);
    void setMoment(int frame);
    bool showCamera(int frame);
    void play(bool on);
    void showNext();
    /// Puts a changed timeline into the text.
    void write(const Timeline& timeline);
    /// The way behind a new key at the present frame: that of the key before it.
    Easing easingFor(const std::string& track) const;
    void putNumber(Timeline& timeline, const std::string& name, double value) const;
    void putCamera(Timeline& timeline) const;
    bool cameraDiffers() const;

    Parts parts_;
    Animation animation_;
    std::shared_ptr<const SourceLibrary> sources_;  ///< of the present text
    bool asksForClock_ = false;  ///< the text says something else at another clock, when frames last went by
    int frame_ = 0;
    bool moving_ = false;
    std::vector<std::pair<int, double>> shown_;  ///< numbers of the frame that is shown
    int playedFrom_ = 0;
    PlayClock clock_;
    StateHistory<int> frames_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/study/view/fitted_view.h"
#include "widgets/latest_worker.h"

namespace isoscope {

class Actions;
class Viewport;

/// Fits the view to what the scene shows, and turns it to the standard directions. Works in the background;
/// a view that was moved meanwhile, or another scene, is left as it is.
class ViewController : public QObject {
    Q_OBJECT
  public:
    ViewController(Actions* actions, Viewport* viewport, QObject* parent);
    ~ViewController() override;

    /// Moves the view, keeping its direction, to all that the scene shows. Works in the background; where
    /// nothing can be fitted, said() tells so and the view stays.
    void fit();
    /// The same because the text was changed: that and the new view are one step.
    void followText();
    void show(StandardView view);
    /// Nothing is under way.
    bool idle() const { return running_ == 0; }

  signals:
    /// For the status line.
    void said(const QString& message);
    /// The view changes next, for the sake of the text.
    void followsText();

  private:
    enum class Cause { user, text };
    void fitTo(const Camera& turned, Cause cause = Cause::user);

    Viewport* viewport_;
    int running_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the others
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QTimer>
#include <stop_token>

#include "core/language/parse.h"
#include "core/study/view/container_fit.h"
#include "widgets/latest_worker.h"

namespace isoscope {

class NoticeBar;
class SceneEditor;
class SceneSession;

/// Gives an isosurface of the text the smallest container that is proven to show the same. Worked out in the
/// background, written as one undo step; a text that has changed meanwhile is left alone. Where it takes
/// longer, a notice offers to stop it.
class ContainerFitter : public QObject {
    Q_OBJECT
  public:
    ContainerFitter(SceneEditor* editor, SceneSession* session, NoticeBar* notices, QObject* parent);
    ~ContainerFitter() override;

    /// For the isosurface at the caret, else the first one.
    void fit();
    /// Nothing is under way.
    bool idle() const { return !working_; }

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    /// What became of a fit.
    struct Result {
        ContainerFit fit;
        std::size_t isosurface = 0;
        double share = 1;                ///< of the volume of the container before
        double seconds = 0, fitted = 0;  ///< of POV-Ray, for a picture of 640 x 480
    };
    static Result work(const ParseResult& parsed, std::size_t isosurface, const std::stop_token& stop);
    void finish(const ParseResult& parsed, quint64 revision, const Result& result);
    void take(const ParseResult& parsed, const Result& result);

    SceneEditor* editor_;
    SceneSession* session_;
    NoticeBar* notices_;
    QTimer slow_;
    std::stop_source stop_;  ///< the user's
    bool working_ = false;
    LatestWorker worker_;  // last: its tasks refer to the others
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>
#include <QObject>
#include <stop_token>
#include <string>

#include "core/exchange/frame_sequence.h"
#include "core/language/parse.h"
#include "core/render/render_request.h"
#include "widgets/latest_worker.h"

namespace isoscope {

/// The frames of an animation that are to be drawn.
struct FrameOrder {
    std::string text;
    ParseOptions options;  ///< clock and numbers of frames are set for each frame
    FrameSequence frames;  ///< with the beginning of the files' names
    int width = 800;
    int height = 600;
    bool antialias = true;
    RootFinder rootFinder = RootFinder::lipschitz;
    std::optional<Camera> view;  ///< that all frames are seen from; else each from its own
};

/// Draws the frames of an order one after the other, in the background, and writes each as a PNG file, whole
/// or not at all. The first that cannot be drawn or written ends it.
class FrameWriter : public QObject {
    Q_OBJECT
  public:
    explicit FrameWriter(QObject* parent = nullptr);
    ~FrameWriter() override;

    /// Begins; one at a time.
    void start(const FrameOrder& order);
    /// Ends the frame that is drawn within a moment; finished() comes with `stopped`.
    void stop();
    bool isRunning() const { return running_; }

    /// What finished() says of a stop.
    static constexpr const char* stopped = "stopped";

  signals:
    /// So many frames are written.
    void progressed(int done);
    /// All are written, and `error` is empty, or why not.
    void finished(const QString& error);

  private:
    bool running_ = false;
    std::stop_source stop_;
    LatestWorker worker_;  // last: its task refers to the writer
};

}  // namespace isoscope

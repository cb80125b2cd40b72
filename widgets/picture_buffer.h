// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <QImage>
#include <QRect>
#include <vector>

#include "core/render/progressive_renderer.h"

namespace isoscope {

/// Puts the tiles of a ProgressiveRenderer together. The picture of one job stays until the next job has
/// covered the whole area once, so that nothing flashes and a half-drawn coarse pass is never seen.
class PictureBuffer {
  public:
    /// When the picture of a job replaces the one before.
    enum class Reveal {
        firstPass,     ///< as soon as it covers the area: the picture sharpens before the eyes
        whenComplete,  ///< only at the end of its last pass: for a picture that should look the same
    };

    /// A job that was asked for; its tiles may arrive from now on.
    void expect(std::uint64_t job, QSize size, Reveal reveal = Reveal::firstPass);
    /// Takes tiles in; those of unknown jobs and outside of the picture are dropped. True when the picture
    /// shown has changed.
    bool add(const std::vector<FinishedTile>& tiles);
    /// The job has ended: what waited for the end is shown now, if it covers the area. True when the picture
    /// has changed.
    bool complete(std::uint64_t job);

    /// Null before the first picture. Format_RGB32, in device pixels.
    const QImage& picture() const { return shown_; }
    /// The job that the picture belongs to; 0 before the first.
    std::uint64_t shownJob() const { return shownJob_; }
    void clear();

  private:
    struct Job {
        std::uint64_t number = 0;
        QSize size;
        Reveal reveal = Reveal::firstPass;
    };

    bool start(std::uint64_t job);
    bool reveal();

    std::deque<Job> expected_;
    QImage shown_;
    QImage building_;
    Job buildingJob_;
    std::uint64_t shownJob_ = 0;
    qint64 covered_ = 0;  ///< pixels handed over for buildingJob_, counted once per pass
};

}  // namespace isoscope

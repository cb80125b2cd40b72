// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <QImage>
#include <QRect>
#include <vector>

#include "core/render/progressive/progressive_renderer.h"

namespace isoscope {

/// Puts the tiles of a ProgressiveRenderer together. Coarse passes are drawn smoothly, from the middle of one
/// block to that of the next: what is to come is better guessed so, and nothing jumps when it comes. The
/// picture of one job stays until the next job has covered the whole area once, so that nothing flashes and a
/// half-drawn coarse pass is never seen.
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

    /// The colours of a coarse pass, one a block.
    struct Grid {
        std::uint64_t job = 0;
        int block = 1;
        int columns = 0, rows = 0;
        std::vector<std::uint32_t> colors;
        std::vector<std::uint32_t> left,
            step;  ///< by pixel of a line: the column before it, and how far behind
    };

    bool start(std::uint64_t job);
    bool reveal();
    void begin(const FinishedTile& tile, const QImage& image);
    void note(const FinishedTile& tile);
    void drawSmoothly(const QRect& area, QImage& image);

    std::deque<Job> expected_;
    QImage shown_;
    QImage building_;
    Job buildingJob_;
    std::uint64_t shownJob_ = 0;
    Grid grid_;
    std::vector<std::uint32_t> row_;  ///< memory of drawSmoothly()
    qint64 covered_ = 0;              ///< pixels handed over for buildingJob_, counted once per pass
};

}  // namespace isoscope

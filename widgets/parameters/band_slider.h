// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>
#include <vector>

namespace isoscope {

/// A horizontal slider with a band below its groove that shades parts of its range.
class BandSlider : public QSlider {
    Q_OBJECT
  public:
    /// A part of the range, in steps of the slider.
    struct Span {
        int low = 0;
        int high = 0;
        bool certain = true;  ///< else it is paler
        bool operator==(const Span&) const = default;
    };

    explicit BandSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

    /// What is shaded; nothing for none. `old`: all of it is pale, since it may not hold any more.
    void setBand(std::vector<Span> spans, bool old);
    const std::vector<Span>& band() const { return spans_; }
    bool isBandOld() const { return old_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::vector<Span> spans_;
    bool old_ = false;
};

}  // namespace isoscope

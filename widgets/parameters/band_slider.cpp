// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/band_slider.h"

#include <algorithm>
#include <QPainter>
#include <QStyle>
#include <utility>

namespace isoscope {

namespace {

constexpr double thickness = 3;
constexpr int certainAlpha = 220, uncertainAlpha = 110, oldAlpha = 50;

}  // namespace

void BandSlider::setBand(std::vector<Span> spans, bool old) {
    if (spans == spans_ && old == old_) return;
    spans_ = std::move(spans);
    old_ = old;
    update();
}

void BandSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    if (spans_.empty()) return;
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
    const auto placeOf = [&](int step) {
        return handle / 2.0 +
               QStyle::sliderPositionFromValue(minimum(), maximum(), step, std::max(1, width() - handle));
    };
    QPainter painter(this);
    QColor color(palette().color(QPalette::Base).lightness() < 128 ? 0x5fd38d : 0x1a7f45);
    for (const Span& span : spans_) {
        color.setAlpha(old_ ? oldAlpha : span.certain ? certainAlpha : uncertainAlpha);
        const double left = placeOf(span.low), right = std::max(placeOf(span.high), left + 1);
        painter.fillRect(QRectF(left, height() - thickness, right - left, thickness), color);
    }
}

}  // namespace isoscope

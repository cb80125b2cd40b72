// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QProxyStyle>

class QStyleOptionComplex;

namespace isoscope {

/// The size of letters, icons, marks and scroll bars of the whole interface, in percent of the desktop's:
/// from 100 to 200, others become the nearer of the two. Pictures and charts keep their room. Makes anew the
/// style that applyTheme() has set; before that it only is remembered.
constexpr int usualInterfaceSize = 100, largestInterfaceSize = 200;
void setInterfaceSize(int percent);
int interfaceSize();

/// A length in logical pixels at 100 %, at the present size.
int interfaceLength(int pixels);

/// The font of fixed width for texts of scenes, at the present size.
QFont fixedFont();

/// The edge of the icons of a button or tool bar, in logical pixels at 100 %; follows the size of the
/// interface from then on.
void setIconEdge(QWidget* widget, int pixels);

/// Qt's Fusion, with marks and icons that follow the size of the interface. In high contrast everything that
/// can be pressed, typed into or dragged has an outline, and what has the focus a yellow one.
class InterfaceStyle : public QProxyStyle {
    Q_OBJECT
  public:
    InterfaceStyle();

    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
};

}  // namespace isoscope

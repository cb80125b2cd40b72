// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/interface_style.h"

#include <algorithm>
#include <QAbstractButton>
#include <QApplication>
#include <QFontDatabase>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolBar>

#include "widgets/look.h"

namespace isoscope {
namespace {

constexpr const char* iconEdgeProperty = "iconEdge";

int sizeNow = usualInterfaceSize;

/// The desktop's font, as it was before any change of size.
const QFont& desktopFont() {
    static const QFont font = QApplication::font();
    return font;
}

QFont scaled(QFont font) {
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() * sizeNow / usualInterfaceSize);
    else
        font.setPixelSize(interfaceLength(font.pixelSize()));
    return font;
}

bool inHighContrast(const QStyleOption* option) {
    return option && lookOf(option->palette) == Look::highContrast;
}

/// Fusion outlines what it draws in a darker shade of the window's colour, which on black is black: while
/// this lives, the option's window is white.
class LightOutlines {
  public:
    explicit LightOutlines(const QStyleOption* option)
        : option_(const_cast<QStyleOption*>(option)), palette_(option->palette) {
        option_->palette.setColor(QPalette::Window, Qt::white);
    }
    ~LightOutlines() { option_->palette = palette_; }
    LightOutlines(const LightOutlines&) = delete;
    LightOutlines& operator=(const LightOutlines&) = delete;

  private:
    QStyleOption* option_;
    QPalette palette_;
};

QColor outlineColor(const QStyleOption* option) {
    if (!(option->state & QStyle::State_Enabled))
        return option->palette.color(QPalette::Disabled, QPalette::WindowText);
    return option->palette.color(option->state & QStyle::State_HasFocus ? QPalette::BrightText
                                                                        : QPalette::WindowText);
}

void outline(QPainter* painter, const QStyleOption* option, const QRect& rect) {
    const int width = option->state & QStyle::State_HasFocus ? 2 : 1;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing, false);
    for (int i = 0; i < width; ++i) {
        painter->setPen(outlineColor(option));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(rect.adjusted(i, i, -1 - i, -1 - i));
    }
    painter->restore();
}

/// A button: black, in the colour of what is selected while it is pressed or checked.
void drawButton(QPainter* painter, const QStyleOption* option) {
    const bool down = option->state & (QStyle::State_Sunken | QStyle::State_On);
    const bool flat = (option->state & QStyle::State_AutoRaise) && !down &&
                      !(option->state & (QStyle::State_MouseOver | QStyle::State_HasFocus));
    painter->fillRect(option->rect, option->palette.color(down ? QPalette::Highlight : QPalette::Button));
    if (!flat) outline(painter, option, option->rect);
}

void drawTab(QPainter* painter, const QStyleOptionTab* tab) {
    painter->fillRect(tab->rect, tab->palette.color(QPalette::Window));
    const bool selected = tab->state & QStyle::State_Selected;
    painter->save();
    painter->setPen(tab->palette.color(selected ? QPalette::WindowText : QPalette::Mid));
    painter->drawRect(tab->rect.adjusted(0, 0, -1, -1));
    if (selected) {
        constexpr int bar = 3;
        const bool above = tab->shape == QTabBar::RoundedNorth || tab->shape == QTabBar::TriangularNorth;
        QRect line = tab->rect;
        above ? line.setHeight(bar) : line.setTop(line.bottom() - bar + 1);
        painter->fillRect(line, tab->palette.color(QPalette::BrightText));
    }
    painter->restore();
}

void drawScrollBar(QPainter* painter, const QStyleOptionSlider* bar, const QStyle* style,
                   const QWidget* widget) {
    painter->fillRect(bar->rect, bar->palette.color(QPalette::Base));
    const QRect handle = style->subControlRect(QStyle::CC_ScrollBar, bar, QStyle::SC_ScrollBarSlider, widget);
    const bool active = bar->state & QStyle::State_Enabled;
    painter->fillRect(handle.adjusted(2, 2, -2, -2),
                      bar->palette.color(active ? QPalette::WindowText : QPalette::Mid));
    const bool across = bar->orientation == Qt::Horizontal;
    for (const bool first : {true, false}) {
        QStyleOption arrow(*bar);
        arrow.rect =
            style->subControlRect(QStyle::CC_ScrollBar, bar,
                                  first ? QStyle::SC_ScrollBarSubLine : QStyle::SC_ScrollBarAddLine, widget);
        if (arrow.rect.isEmpty()) continue;
        style->drawPrimitive(across ? (first ? QStyle::PE_IndicatorArrowLeft : QStyle::PE_IndicatorArrowRight)
                                    : (first ? QStyle::PE_IndicatorArrowUp : QStyle::PE_IndicatorArrowDown),
                             &arrow, painter, widget);
    }
}

}  // namespace

void setInterfaceSize(int percent) {
    const QFont& usual = desktopFont();
    sizeNow = std::clamp(percent, usualInterfaceSize, largestInterfaceSize);
    if (!qobject_cast<InterfaceStyle*>(QApplication::style())) return;
    if (QApplication::font() == scaled(usual)) return;
    QApplication::setFont(scaled(usual));
    QApplication::setStyle(new InterfaceStyle);
}

int interfaceSize() { return sizeNow; }

int interfaceLength(int pixels) { return (pixels * sizeNow + usualInterfaceSize / 2) / usualInterfaceSize; }

QFont fixedFont() { return scaled(QFontDatabase::systemFont(QFontDatabase::FixedFont)); }

void setIconEdge(QWidget* widget, int pixels) {
    widget->setProperty(iconEdgeProperty, pixels);
    const QSize size(interfaceLength(pixels), interfaceLength(pixels));
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) button->setIconSize(size);
    if (auto* bar = qobject_cast<QToolBar*>(widget)) bar->setIconSize(size);
}

InterfaceStyle::InterfaceStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {
    setObjectName(QStringLiteral("fusion"));
}

void InterfaceStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    const QVariant edge = widget->property(iconEdgeProperty);
    if (edge.isValid()) setIconEdge(widget, edge.toInt());
}

int InterfaceStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
        case PM_SmallIconSize:
        case PM_LargeIconSize:
        case PM_ButtonIconSize:
        case PM_ToolBarIconSize:
        case PM_TabBarIconSize:
        case PM_ListViewIconSize:
        case PM_MessageBoxIconSize:
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
        case PM_ScrollBarExtent:
        case PM_SliderThickness:
        case PM_SliderControlThickness:
        case PM_SliderLength:
        case PM_MenuButtonIndicator:
        case PM_TabCloseIndicatorWidth:
        case PM_TabCloseIndicatorHeight:
        case PM_ToolBarExtensionExtent: return interfaceLength(usual);
        default: return usual;
    }
}

void InterfaceStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                   const QWidget* widget) const {
    if (!inHighContrast(option)) return QProxyStyle::drawPrimitive(element, option, painter, widget);
    switch (element) {
        case PE_PanelButtonCommand:
        case PE_PanelButtonTool: return drawButton(painter, option);
        case PE_FrameFocusRect: {
            QStyleOption focused(*option);
            focused.state |= State_HasFocus | State_Enabled;
            return outline(painter, &focused, option->rect);
        }
        case PE_FrameLineEdit:
        case PE_FrameMenu:
        case PE_FrameTabWidget:
        case PE_FrameGroupBox: return outline(painter, option, option->rect);
        case PE_Frame: {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return outline(painter, option, option->rect);
        }
        case PE_IndicatorCheckBox:
        case PE_IndicatorRadioButton:
        case PE_IndicatorItemViewItemCheck: {
            const LightOutlines light(option);
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
        }
        default: return QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void InterfaceStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
    if (!inHighContrast(option)) return QProxyStyle::drawControl(element, option, painter, widget);
    switch (element) {
        case CE_TabBarTabShape:
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option))
                return drawTab(painter, tab);
            break;
        case CE_Splitter: return painter->fillRect(option->rect, option->palette.color(QPalette::Mid));
        case CE_HeaderSection:
        case CE_ProgressBarGroove:
        case CE_MenuItem: {
            const LightOutlines light(option);
            return QProxyStyle::drawControl(element, option, painter, widget);
        }
        default: break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void InterfaceStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                        QPainter* painter, const QWidget* widget) const {
    if (!inHighContrast(option)) return QProxyStyle::drawComplexControl(control, option, painter, widget);
    switch (control) {
        case CC_ScrollBar:
            if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option))
                return drawScrollBar(painter, bar, proxy(), widget);
            break;
        case CC_ComboBox:
        case CC_SpinBox:
            QProxyStyle::drawComplexControl(control, option, painter, widget);
            return outline(painter, option, option->rect);
        case CC_Slider:
        case CC_GroupBox: {
            const LightOutlines light(option);
            return QProxyStyle::drawComplexControl(control, option, painter, widget);
        }
        default: break;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

}  // namespace isoscope

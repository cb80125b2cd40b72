// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/numbers/number_tool.h"

#include <algorithm>
#include <QAbstractButton>
#include <QPainter>
#include <QScreen>

#include "core/language/expressions/slider_range.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/numbers/number_literal.h"
#include "widgets/numbers/number_popup.h"
#include "widgets/numbers/number_scrubber.h"
#include "widgets/parameters/parameter_binding.h"

namespace isoscope {
namespace {

using Sci = QsciScintillaBase;

constexpr QSize handleSize{24, 10};

/// A tiny slider.
class NumberHandle : public QAbstractButton {
  public:
    explicit NumberHandle(QWidget* parent) : QAbstractButton(parent) {
        setFocusPolicy(Qt::NoFocus);
        setCursor(Qt::PointingHandCursor);
        resize(handleSize);
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor ground = palette().color(QPalette::Highlight);
        ground.setAlpha(underMouse() ? 255 : 170);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(QRectF(rect()), 3, 3);
        const double middle = height() / 2.0;
        painter.setPen(QPen(palette().color(QPalette::HighlightedText), 1.2));
        painter.drawLine(QPointF(4, middle), QPointF(width() - 4, middle));
        painter.setBrush(palette().color(QPalette::HighlightedText));
        painter.drawEllipse(QPointF(width() * 0.4, middle), 2.2, 2.2);
    }
};

}  // namespace

NumberTool::NumberTool(SceneEditor* editor, const ParameterBinding* binding, QObject* parent)
    : QObject(parent), editor_(editor), binding_(binding), handle_(new NumberHandle(editor->viewport())) {
    handle_->setAccessibleName(NumberTool::tr("Slider for the number at the caret"));
    handle_->setToolTip(NumberTool::tr("Change this number with a slider"));
    handle_->hide();
    connect(handle_, &QAbstractButton::clicked, this, &NumberTool::open);
    connect(editor->scrubber(), &NumberScrubber::clicked, this, &NumberTool::open);
    // Behind every change of text, caret and scrolling.
    connect(editor, &QsciScintillaBase::SCN_UPDATEUI, this, &NumberTool::placeHandle);
    connect(editor, &SceneEditor::focusLost, this, &NumberTool::placeHandle);
}

NumberTool::~NumberTool() = default;

NumberPopup* NumberTool::popup() const { return popup_; }

void NumberTool::open() {
    const auto number = editor_->scrubber()->atCaret();
    if (!number) return emit said(tr("There is no number at the caret."));
    popup_ = new NumberPopup(editor_, number->begin, describe(*number));
    const long x = editor_->SendScintilla(Sci::SCI_POINTXFROMPOSITION, 0UL, static_cast<long>(number->begin));
    const long y = editor_->SendScintilla(Sci::SCI_POINTYFROMPOSITION, 0UL, static_cast<long>(number->begin));
    const QPoint below(static_cast<int>(x), static_cast<int>(y) + editor_->textHeight(0) + 4);
    const QRect screen = editor_->screen()->availableGeometry();
    const QSize size = popup_->sizeHint().expandedTo(popup_->minimumSize());
    QPoint place = editor_->viewport()->mapToGlobal(below);
    place.setX(std::clamp(place.x(), screen.left(), std::max(screen.left(), screen.right() - size.width())));
    // Above the line where there is no room below it.
    if (place.y() + size.height() > screen.bottom())
        place.setY(place.y() - editor_->textHeight(0) - 8 - size.height());
    popup_->move(place);
    popup_->show();
    popup_->setFocus();
}

SceneParameter NumberTool::describe(const NumberLiteral& number) const {
    const auto& parameters = binding_->parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto range = editor_->numberRange(static_cast<int>(i));
        const bool same = range && static_cast<int>(range->begin) == number.begin &&
                          static_cast<int>(range->end) == number.end;
        if (!same || parameters[i].expression || parameters[i].implied) continue;
        SceneParameter known = parameters[i];
        known.value = number.value;
        return known;
    }
    SceneParameter plain;
    plain.name = tr("Number").toStdString();
    plain.value = number.value;
    const SliderRange range = sliderRangeAround(number.value);
    plain.minimum = range.minimum;
    plain.maximum = range.maximum;
    return plain;
}

void NumberTool::placeHandle() {
    const auto number =
        editor_->hasFocus() && !editor_->isListActive() ? editor_->scrubber()->atCaret() : std::nullopt;
    if (!number) return handle_->hide();
    const auto at = [&](int position) {
        return static_cast<int>(
            editor_->SendScintilla(Sci::SCI_POINTXFROMPOSITION, 0UL, static_cast<long>(position)));
    };
    const int y = static_cast<int>(
        editor_->SendScintilla(Sci::SCI_POINTYFROMPOSITION, 0UL, static_cast<long>(number->begin)));
    const int x = (at(number->begin) + at(number->end) - handleSize.width()) / 2;
    handle_->move(x, y + editor_->textHeight(0) - 1);
    handle_->setVisible(editor_->viewport()->rect().contains(handle_->geometry()));
}

}  // namespace isoscope

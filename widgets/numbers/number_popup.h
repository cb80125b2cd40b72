// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QFrame>
#include <string>

#include "core/language/sliders/slider_note.h"
#include "core/scene/scene.h"

namespace isoscope {

class ParameterSlider;
class SceneEditor;

/// A slider for one number of the text, with its value and the ends of its range, that opens at the number
/// and goes with the next click elsewhere. It moves as the text's note says, and its menu writes one. Each
/// drag is one undo step; Enter keeps the number, Escape brings the first text back. Deletes itself when
/// closed.
class NumberPopup : public QFrame {
    Q_OBJECT
  public:
    /// The number begins at byte `begin` of the text; nothing else may change the text meanwhile.
    NumberPopup(SceneEditor* editor, int begin, const SceneParameter& number);

    /// The slider inside; never null, owned by the popup.
    ParameterSlider* slider() const { return slider_; }

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void restore();
    /// Behind the last byte of the number; nothing once it is gone.
    std::optional<std::size_t> numberEnd() const;
    void writeNote(const std::optional<SliderNote>& note);

    SceneEditor* editor_;
    int begin_;
    std::string before_;  ///< the text
    ParameterSlider* slider_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace isoscope {

class SceneEditor;

/// What can be typed, in grey where the first line begins, as long as the text is empty. Takes no clicks.
class EmptyTextHint : public QLabel {
    Q_OBJECT
  public:
    /// A child of the editor's viewport.
    explicit EmptyTextHint(SceneEditor* editor);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void follow();

    SceneEditor* editor_;
};

}  // namespace isoscope

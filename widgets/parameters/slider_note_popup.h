// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "core/language/sliders/slider_note.h"

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace isoscope {

/// The fields of a SliderNote, beside its slider, until the next click elsewhere. Enter or the button sets
/// them, Escape leaves all as it is; what cannot be set is said below the fields. Deletes itself when closed.
class SliderNotePopup : public QFrame {
    Q_OBJECT
  public:
    /// `subject` is the parameter's name, as assistive programs read it.
    SliderNotePopup(const SliderNote& note, const QString& subject, QWidget* parent);

    /// Opens below the widget, or above it where the screen ends.
    void showBelow(const QWidget* widget);

  signals:
    /// The fields were set; the note is usable.
    void chosen(const isoscope::SliderNote& note);

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QLineEdit* addField(QFormLayout* form, const QString& label, const QString& text, const QString& help,
                        const QString& subject);
    void choose();
    /// Why the fields cannot be set; empty when they were read into `note`.
    QString read(SliderNote& note) const;

    SliderNote note_;
    QLineEdit* minimum_;
    QLineEdit* maximum_;
    QLineEdit* step_;
    QLineEdit* decimals_;
    QCheckBox* logarithmic_;
    QLabel* problem_;
};

}  // namespace isoscope

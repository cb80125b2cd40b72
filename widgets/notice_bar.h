// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QFrame>
#include <QString>

class QHBoxLayout;
class QLabel;

namespace isoscope {

/// A line across the window that says something and offers what to do about it, without ever being in the
/// way. Hidden until ask() or tell() is called; a new notice replaces the one before.
class NoticeBar : public QFrame {
    Q_OBJECT
  public:
    struct Choice {
        QString label;
        QString toolTip;
        std::function<void()> act;  ///< called after the bar has gone; may be empty
    };

    explicit NoticeBar(QWidget* parent = nullptr);

    void ask(const QString& text, std::vector<Choice> choices);
    /// The same with a close button only.
    void tell(const QString& text);
    QString text() const;

  private:
    void addButton(Choice choice);

    QLabel* icon_;
    QLabel* text_;
    QHBoxLayout* buttons_;
};

}  // namespace isoscope

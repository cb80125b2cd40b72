// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <QFrame>
#include <QPointer>
#include <QString>
#include <vector>

class QBoxLayout;
class QLabel;

namespace isoscope {

/// A line that says something and offers what to do about it, without ever being in the way. A notice stays
/// until it is answered: one about something else covers it and gives it back; one about the same topic, or
/// another that only tells, takes its place. Keys: Tab between the choices, Enter for one, Escape for the
/// last.
class NoticeBar : public QFrame {
    Q_OBJECT
  public:
    /// A button of a notice, and what it does.
    struct Choice {
        QString label;
        QString toolTip;
        std::function<void()> act;  ///< called after the notice has gone; may be empty
    };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// Lies over the top of `host`, whose child it becomes, and so moves nothing when it comes and goes.
    void floatOver(QWidget* host);

    /// The last choice should be the one that changes nothing.
    void ask(const QString& text, std::vector<Choice> choices, const QString& topic = {});
    /// The same with a close button only.
    void tell(const QString& text);
    /// The notice of this topic has become pointless.
    void withdraw(const QString& topic);
    /// Puts the keyboard focus on the first choice; it goes back to where it was with the answer.
    void takeFocus();

    /// Of the notice that is shown; empty without one.
    QString text() const;
    /// Whether there is a notice of this topic (and of these words), shown or covered.
    bool asks(const QString& topic, const QString& text = {}) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    struct Notice {
        QString text;
        QString topic;
        std::vector<Choice> choices;
    };

    void showLast();
    void showIcon();
    void addButton(std::size_t index);
    void answer(std::size_t index);
    void giveFocusBack();
    /// Choices go below the text where there is little room.
    void fold(int width);
    void place();

    std::vector<Notice> notices_;
    QLabel* icon_ = nullptr;  ///< null while the bar is being made
    QLabel* text_;
    QLabel* more_;
    QBoxLayout* layout_;
    QBoxLayout* buttons_;
    QWidget* host_ = nullptr;
    QPointer<QWidget> before_;  ///< had the focus
};

}  // namespace isoscope

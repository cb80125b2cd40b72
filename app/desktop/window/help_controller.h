// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace isoscope {

class Actions;
class Docks;
class DocumentController;
class FunctionBrowser;
class HelpPanel;
struct HelpScene;
class InsertionController;
class SceneEditor;

/// The help in a panel of its own at the right, made with this object: what F1 opens, and what becomes of the
/// scenes of its pages.
class HelpController : public QObject {
    Q_OBJECT
  public:
    /// All parts outlive the controller.
    struct Parts {
        QMainWindow* window;
        Docks* docks;
        DocumentController* documents;
        SceneEditor* editor;
        FunctionBrowser* functions;
        Actions* actions;
        InsertionController* insertions;
    };
    HelpController(const Parts& parts, QObject* parent);

    /// The page about the word at the caret, or about what the number there belongs to; about the selected
    /// function, the slider or the panel with the focus. The index where the focus is in none, or in an empty
    /// place of the text.
    void showForFocus();
    /// The index, from its list of lessons on.
    void showLessons();

  private:
    /// What to open: an address, and the words to look for on the page.
    struct Topic {
        QString address;
        QString words;
    };

    Topic topicOf(const QWidget* focus) const;
    Topic topicAtCaret() const;
    void show(const Topic& topic);
    void openScene(const HelpScene& scene);
    void followZoom();

    Parts parts_;
    HelpPanel* panel_;
    QDockWidget* dock_;
    QPointer<QWidget> focusBefore_;
};

}  // namespace isoscope

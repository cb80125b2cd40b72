// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QMainWindow;
class QWidget;

namespace isoscope {

class Docks;

/// Takes the focus from pane to pane: the panels that are seen, the picture, the tool bars and the status
/// line. A frame marks the pane, of a tool bar the button, until the focus leaves it or the mouse is used; in
/// a tool bar the arrows go from button to button.
class PaneWalk : public QObject {
    Q_OBJECT
  public:
    /// `picture` is the pane in the middle.
    PaneWalk(QMainWindow* window, const Docks* docks, QWidget* picture);

    /// What lies over the whole picture, and takes its place among the panes while it is seen; may be null.
    void setCover(QWidget* cover) { cover_ = cover; }
    /// To the next pane, or to the one before; after the last comes the first. A pane gets the focus where it
    /// had it last.
    void go(bool forward);
    /// The panes that can have the focus now, in their order.
    QList<QWidget*> panes() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// What takes the keys in a pane; null where nothing does.
    static QWidget* target(const QWidget* pane);
    void mark(QWidget* pane);
    void unmark();

    QMainWindow* window_;
    const Docks* docks_;
    QWidget* picture_;
    QPointer<QWidget> cover_;
    QPointer<QWidget> frame_;  ///< lies in what is marked
    QPointer<QWidget> marked_;
};

}  // namespace isoscope

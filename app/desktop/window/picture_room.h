// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QTimer>

class QAction;
class QDockWidget;
class QMainWindow;
class QToolButton;

namespace isoscope {

class DockTabs;
class Docks;

/// Keeps the picture the largest thing in its window. The text takes a share of the width; what lies below
/// the picture gets what the picture can spare, and where that is too little folds to its row of tabs until
/// there is room again. Sizes that a person dragged, and what a person folds or unfolds, win: they are kept
/// as shares of the window.
class PictureRoom : public QObject {
    Q_OBJECT
  public:
    /// Sizes in pixels of the window between tool bars and status line.
    struct Area {
        int width = 0, height = 0;
        int pictureWidth = 0;  ///< of the middle
        int pictureFrame = 0;  ///< height of the lines above and below the picture in the middle
    };
    /// The height for what lies below; 0 where it should fold. `wanted` is the height that a person chose, 0
    /// for none; `folded` tells how it is now, for it unfolds only when there is room to spare.
    static int heightBelow(const Area& area, int wanted, bool folded);
    /// The width of the text at the left, until the user chooses another.
    static int textWidth(int windowWidth);

    PictureRoom(QMainWindow* window, Docks* docks, QWidget* picture);

    /// What lies below the picture shows its tabs only.
    bool folded() const { return folded_; }
    /// As a person asks for it.
    void fold(bool folded);
    /// For the menu: folds and unfolds.
    QAction* foldAction() const { return foldAction_; }

    /// Forgets what a person chose.
    void reset();
    /// For the settings; "" for nothing chosen.
    QString choices() const;
    void setChoices(const QString& choices);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    enum class Will { none, folded, open };
    /// What a person can drag, in pixels.
    struct Sizes {
        int text = 0, upper = 0, below = 0;
    };

    void settle();
    void apply();
    void setFolded(bool folded);
    void noteDrag(bool begins);
    Area area() const;
    Sizes sizes() const;
    /// Those that fold; none unless they share one row of tabs.
    QList<QDockWidget*> below() const;
    void showButton();

    QMainWindow* window_;
    Docks* docks_;
    QWidget* picture_;
    QAction* foldAction_;
    QToolButton* button_;
    QTimer timer_;
    bool folded_ = false;
    bool applying_ = false;
    bool dragging_ = false;  ///< a person holds a line between panels
    Sizes pressed_;          ///< when a person took hold of a line between panels
    Will will_ = Will::none;
    double textShare_ = 0;   ///< of the width of the window; 0: not chosen
    double upperShare_ = 0;  ///< of the text in its column
    double belowShare_ = 0;  ///< of the height of the window
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>

class QCheckBox;

namespace isoscope {

class GalleryPanel;

/// The page that a new user begins with: the gallery over the whole picture, with the ways to begin above it.
/// Covers `host`, whose child it is, while it is shown. Escape closes it, and whatever is chosen.
class StartPage : public QFrame {
    Q_OBJECT
  public:
    explicit StartPage(QWidget* host);

    /// The panel inside; never null.
    GalleryPanel* gallery() const { return gallery_; }
    /// Whether the program begins with it: at its first start, and where a person has asked for it.
    static bool wantedAtStart();
    /// Shows it with the focus in the search; the focus comes back when it closes.
    void open();
    /// Hides it, where it is shown.
    void leave();

  signals:
    /// Buttons of the page; it has closed by then.
    void newRequested();
    void fileRequested();
    void lessonsRequested();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void build();

    GalleryPanel* gallery_ = nullptr;
    QCheckBox* always_ = nullptr;
    QPointer<QWidget> before_;  ///< had the focus
};

}  // namespace isoscope

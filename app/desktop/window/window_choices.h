// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QSize>

#include "core/scene/scene.h"
#include "widgets/theme.h"

class QMainWindow;

namespace isoscope {

class Actions;
class PictureRoom;
class SceneEditor;
class Viewport;

/// What a person has chosen of the window: its size and layout, theme, root finder, smooth edges, guides, and
/// how the text is wrapped. Acts on the commands that choose it, stores it, and brings it back.
class WindowChoices : public QObject {
    Q_OBJECT
  public:
    /// What the choices are about; the object owns none of it.
    struct Parts {
        QMainWindow* window;
        Actions* actions;
        Viewport* viewport;
        SceneEditor* editor;
        PictureRoom* room;
    };
    /// Takes the present layout of the window for the one that Reset Layout brings back.
    explicit WindowChoices(const Parts& parts);

    /// Of a window without stored choices, on a screen with so much room: never more than that with its
    /// frame.
    static QSize firstSize(QSize available);
    /// Language, theme and size of the interface, before any panel is made, which would otherwise take texts,
    /// icons, colours and letters of the desktop's.
    static void applyStoredLook();
    /// What the last run has stored.
    void read();
    /// What a choice does not store by itself.
    void write() const;
    /// For this run; what the menu chooses is stored.
    void setTheme(Theme theme);
    /// For the present document; what the menu chooses is stored.
    void setRootFinder(RootFinder finder);
    /// The one that was chosen, or else the usual one.
    void restoreRootFinder();

  private:
    void connectActions();
    void readPicture();
    void chooseTheme(Theme theme);
    void chooseInterfaceSize(int percent);
    void chooseRootFinder(RootFinder finder);

    Parts parts_;
    QByteArray factoryLayout_;
};

}  // namespace isoscope

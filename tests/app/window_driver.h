// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "app/desktop/window/main_window.h"
#include "tests/support/image_pixels.h"

class QSlider;

namespace isoscope::test {

/// A window with settings, caches and recovery folder of its own, as a user would drive it.
class WindowDriver {
  public:
    WindowDriver();
    ~WindowDriver();

    MainWindow* operator->() const { return window_.get(); }
    MainWindow& window() const { return *window_; }
    /// Closes the window and opens another one with the same settings, as at the next start.
    void restart();
    /// The window goes without closing, as in a crash.
    void crash();

    /// Everything parsed, drawn and idle; false after `milliseconds`.
    bool rests(int milliseconds = 20000) const;
    QImage picture() const;
    /// Sets the caret behind the first occurrence of `text` and types.
    void typeBehind(const QString& text, const QString& typed);
    /// Number of the parameter of that name, -1 if there is none.
    int parameter(const QString& name) const;
    /// Drags the slider's handle by `pixels` in small steps; calls `midway` half way with the button down.
    void drag(int parameter, int pixels, const std::function<void()>& midway = {}) const;
    void dragViewport(QPoint from, QPoint by, Qt::MouseButton button = Qt::LeftButton) const;
    void wheel(QWidget* widget, QPoint at, int turn) const;
    /// The number that stands in the text behind `key`.
    double numberBehind(const QString& key) const;
    /// Lets the menu command act.
    static void trigger(QAction* action);
    /// Lets the menu command act, which asks for a file, and types `path` into that dialog; the name that it
    /// had suggested.
    static QString triggerAndChoose(QAction* action, const QString& path);
    /// Clicks the button with this text that is seen in `bar`; false without one.
    static bool press(const QWidget* bar, const QString& text);
    /// Writes a file of this name into the driver's folder and opens it; false when that fails.
    bool openText(const QByteArray& text, const QString& name = QStringLiteral("scene.pov")) const;

  private:
    void open();

    std::unique_ptr<MainWindow> window_;
    QTemporaryDir folder_;  ///< of openText()
};

/// Part of the pixels that differ by more than 8 in a channel; 1 for images of different size.
double difference(const QImage& a, const QImage& b);

}  // namespace isoscope::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <memory>
#include <QElapsedTimer>
#include <QImage>
#include <QString>
#include <QTimer>
#include <QWidget>

class vtkGenericOpenGLRenderWindow;
class vtkGenericRenderWindowInteractor;
class vtkTextProperty;

namespace isoscope {

class EglContext;

/// A plain widget that shows what a VTK render window draws off screen. Mouse events reach the window's
/// interactor, and the interactor's timers run on Qt timers. Frames are drawn inside paintEvent only,
/// coalesced, and without anti-aliasing until nothing has changed for a moment. OpenGL, which takes a tenth
/// of a second to start, is started for the first frame that has something to show. Without OpenGL the panel
/// shows the reason as text.
class VtkPanel : public QWidget {
    Q_OBJECT
  public:
    explicit VtkPanel(QWidget* parent = nullptr);
    ~VtkPanel() override;

    /// Asks for a new frame soon; call it after every change of what is shown.
    void refresh();
    /// The latest frame, in device pixels; null before the first.
    const QImage& frame() const { return frame_; }
    /// True when the latest frame is the smooth one.
    bool settled() const { return settled_ || !hasContent(); }
    bool started() const { return context_ != nullptr; }

    QSize sizeHint() const override { return {360, 300}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

  protected:
    /// Whether there is something to show. Where there is not, no frame is drawn, and the panel is as empty
    /// as the window around it.
    virtual bool hasContent() const { return true; }
    /// Both are made when they are first asked for.
    vtkGenericOpenGLRenderWindow* renderWindow();
    vtkGenericRenderWindowInteractor* interactor();
    /// Gives VTK text the program's own font; VTK's built-in ones lack Greek.
    static void useApplicationFont(vtkTextProperty* property);

    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    class Timers;

    void makeWindow();
    void start();
    void connectWindow();
    /// An event for the interactor, which there is from the first frame on.
    void tell(unsigned long event);
    void setMousePosition(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void draw();

    std::shared_ptr<EglContext> context_;                   ///< null before the first frame
    vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;  ///< null until it is needed
    vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor_;
    std::unique_ptr<Timers> timers_;
    QElapsedTimer drawn_;  ///< since the latest frame
    QTimer updateTimer_;
    QTimer settleTimer_;
    QImage frame_;
    bool dirty_ = true;
    bool smooth_ = false;
    bool settled_ = false;
    bool drawing_ = false;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/vtk_panel.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkOutputWindow.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <algorithm>
#include <map>
#include <QEnterEvent>
#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "widgets/interface_style.h"
#include "widgets/section/egl_context.h"
#include "widgets/section/font_file.h"
#include "widgets/timing.h"

namespace isoscope {

namespace {

constexpr int smoothSamples = 4;
constexpr double vtkDotsPerInch = 72;

void observe(vtkObject* object, unsigned long event, void* client,
             void (*callback)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(client);
    command->SetCallback(callback);
    object->AddObserver(event, command);
}

/// VTK's messages go where the program's own go, not to a stream of their own.
class MessageLog : public vtkOutputWindow {
  public:
    static MessageLog* New();

    void DisplayText(const char* text) override { qWarning("VTK: %s", text); }

    static void install() {
        static const bool done = [] {
            vtkNew<MessageLog> log;
            vtkOutputWindow::SetInstance(log);
            return true;
        }();
        Q_UNUSED(done)
    }

    // Behind the last member: the macro ends with a function, and a semicolon behind it were one too many.
    vtkTypeMacro(MessageLog, vtkOutputWindow)
};
vtkStandardNewMacro(MessageLog);

}  // namespace

/// The timers of an interactor. Charts redraw through one-shot timers: without this, wheel and drag change
/// nothing on the screen.
class VtkPanel::Timers {
  public:
    explicit Timers(vtkGenericRenderWindowInteractor* interactor) : interactor_(interactor) {
        interactor->TimerEventResetsTimerOff();
        observe(interactor, vtkCommand::CreateTimerEvent, this,
                [](vtkObject*, unsigned long, void* self, void* id) {
                    static_cast<Timers*>(self)->start(*static_cast<int*>(id));
                });
        observe(interactor, vtkCommand::DestroyTimerEvent, this,
                [](vtkObject*, unsigned long, void* self, void* id) {
                    static_cast<Timers*>(self)->timers_.erase(*static_cast<int*>(id));
                });
    }
    ~Timers() {
        interactor_->RemoveObservers(vtkCommand::CreateTimerEvent);
        interactor_->RemoveObservers(vtkCommand::DestroyTimerEvent);
    }

  private:
    /// A timer may be replaced from its own timeout, so it goes when control is back in the event loop.
    struct DeleteLater {
        void operator()(QTimer* timer) const {
            timer->stop();
            timer->deleteLater();
        }
    };

    void start(int id) {
        std::unique_ptr<QTimer, DeleteLater> timer(new QTimer);
        timer->setSingleShot(interactor_->IsOneShotTimer(id) != 0);
        QObject::connect(timer.get(), &QTimer::timeout, timer.get(), [this, id] {
            int number = id;
            interactor_->InvokeEvent(vtkCommand::TimerEvent, &number);
        });
        timer->start(static_cast<int>(interactor_->GetTimerDuration(id)));
        timers_[id] = std::move(timer);
    }

    vtkGenericRenderWindowInteractor* interactor_;
    std::map<int, std::unique_ptr<QTimer, DeleteLater>> timers_;
};

VtkPanel::VtkPanel(QWidget* parent) : QWidget(parent) {
    MessageLog::install();
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    updateTimer_.setSingleShot(true);
    connect(&updateTimer_, &QTimer::timeout, this, [this] { update(); });
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(timing::settlePause);
    connect(&settleTimer_, &QTimer::timeout, this, [this] {
        smooth_ = dirty_ = true;
        update();
    });
}

void VtkPanel::makeWindow() {
    if (window_) return;
    window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    interactor_ = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
    connectWindow();
    interactor_->EnableRenderOff();
    interactor_->SetRenderWindow(window_);
    timers_ = std::make_unique<Timers>(interactor_);
}

VtkPanel::~VtkPanel() {
    if (!window_) return;
    timers_.reset();
    if (context_ && context_->makeCurrent()) window_->Finalize();
    interactor_->SetRenderWindow(nullptr);
    window_->RemoveAllObservers();
}

void VtkPanel::start() {
    context_ = EglContext::shared();
    if (!context_->makeCurrent()) return;
    window_->SetFrameBlitModeToNoBlit();
    window_->SetOwnContext(0);
    window_->SetReadyForRendering(true);
    window_->OpenGLInitContext();
    // Wider hardware lines lose pieces on Mesa's software renderer when multi-sampling is on.
    window_->SetForceMaximumHardwareLineWidth(1);
}

void VtkPanel::connectWindow() {
    observe(window_, vtkCommand::WindowMakeCurrentEvent, this,
            [](vtkObject*, unsigned long, void* self, void*) {
                const auto& context = static_cast<VtkPanel*>(self)->context_;
                if (context) context->makeCurrent();
            });
    observe(window_, vtkCommand::WindowIsCurrentEvent, this,
            [](vtkObject*, unsigned long, void* self, void* answer) {
                const auto& context = static_cast<VtkPanel*>(self)->context_;
                *static_cast<bool*>(answer) = context && context->isCurrent();
            });
    observe(window_, vtkCommand::WindowSupportsOpenGLEvent, this,
            [](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
    // Whoever asks VTK to render (charts, interactor styles) only marks the frame as old: drawing happens in
    // paintEvent.
    const auto markOld = [](vtkObject*, unsigned long, void* self, void*) {
        auto* panel = static_cast<VtkPanel*>(self);
        if (!panel->drawing_) panel->refresh();
    };
    observe(window_, vtkCommand::WindowFrameEvent, this, markOld);
    observe(interactor_, vtkCommand::RenderEvent, this, markOld);
}

vtkGenericOpenGLRenderWindow* VtkPanel::renderWindow() {
    makeWindow();
    return window_;
}

vtkGenericRenderWindowInteractor* VtkPanel::interactor() {
    makeWindow();
    return interactor_;
}

void VtkPanel::useApplicationFont(vtkTextProperty* property) {
    static const QByteArray file = QFile::encodeName(fontFile(QApplication::font().family()));
    if (file.isEmpty()) return;  // VTK's own font then
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.constData());
}

void VtkPanel::refresh() {
    dirty_ = true;
    smooth_ = settled_ = false;
    settleTimer_.start();
    if (!isVisible() || updateTimer_.isActive()) return;
    // At once where the last frame is old enough.
    const qint64 since = drawn_.isValid() ? drawn_.elapsed() : timing::panelInterval;
    updateTimer_.start(std::max(
        0, timing::panelInterval - static_cast<int>(std::min<qint64>(since, timing::panelInterval))));
}

void VtkPanel::draw() {
    const qreal ratio = devicePixelRatioF();
    const QSize size = (QSizeF(this->size()) * ratio).toSize();
    if (size.isEmpty()) return;
    makeWindow();
    if (!started()) start();
    if (!context_->makeCurrent()) {
        settled_ = true;  // there is nothing to wait for
        return;
    }
    drawing_ = true;
    window_->SetSize(size.width(), size.height());
    interactor_->SetSize(size.width(), size.height());
    // Letters of charts and colour bars grow with those of the interface.
    const double dots = vtkDotsPerInch * interfaceSize() / 100;
    window_->SetDPI(static_cast<int>(dots * ratio + 0.5));
    window_->SetMultiSamples(smooth_ ? smoothSamples : 0);
    vtkOpenGLState* state = window_->GetState();
    state->Reset();
    state->Push();
    window_->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, pixels);
    state->Pop();
    drawing_ = false;
    // OpenGL's rows run from the bottom.
    frame_ =
        QImage(pixels->GetPointer(0), size.width(), size.height(), size.width() * 4, QImage::Format_RGBX8888)
            .mirrored()
            .convertToFormat(QImage::Format_RGB32);
    frame_.setDevicePixelRatio(ratio);
    dirty_ = false;
    drawn_.start();
    settled_ = smooth_;
}

void VtkPanel::paintEvent(QPaintEvent*) {
    if (!hasContent()) return QPainter(this).fillRect(rect(), palette().window());
    if (dirty_ || (frame_.size() != (QSizeF(size()) * devicePixelRatioF()).toSize())) draw();
    QPainter painter(this);
    if (!frame_.isNull()) {
        painter.drawImage(QPoint(0, 0), frame_);
        return;
    }
    painter.fillRect(rect(), palette().window());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("This panel cannot be drawn: %1.").arg(QString::fromStdString(context_->problem())));
}

void VtkPanel::setMousePosition(const QPointF& position, Qt::KeyboardModifiers modifiers) {
    if (!interactor_) return;
    const QPointF device = position * devicePixelRatioF();
    interactor_->SetEventInformationFlipY(static_cast<int>(device.x()), static_cast<int>(device.y()),
                                          modifiers.testFlag(Qt::ControlModifier),
                                          modifiers.testFlag(Qt::ShiftModifier));
}

void VtkPanel::tell(unsigned long event) {
    if (interactor_) interactor_->InvokeEvent(event);
}

void VtkPanel::mousePressEvent(QMouseEvent* event) {
    setMousePosition(event->position(), event->modifiers());
    if (event->button() == Qt::LeftButton) tell(vtkCommand::LeftButtonPressEvent);
    if (event->button() == Qt::MiddleButton) tell(vtkCommand::MiddleButtonPressEvent);
    if (event->button() == Qt::RightButton) tell(vtkCommand::RightButtonPressEvent);
}

void VtkPanel::mouseReleaseEvent(QMouseEvent* event) {
    setMousePosition(event->position(), event->modifiers());
    if (event->button() == Qt::LeftButton) tell(vtkCommand::LeftButtonReleaseEvent);
    if (event->button() == Qt::MiddleButton) tell(vtkCommand::MiddleButtonReleaseEvent);
    if (event->button() == Qt::RightButton) tell(vtkCommand::RightButtonReleaseEvent);
}

void VtkPanel::mouseMoveEvent(QMouseEvent* event) {
    setMousePosition(event->position(), event->modifiers());
    tell(vtkCommand::MouseMoveEvent);
}

void VtkPanel::wheelEvent(QWheelEvent* event) {
    setMousePosition(event->position(), event->modifiers());
    const int turn = event->angleDelta().y();
    if (turn > 0) tell(vtkCommand::MouseWheelForwardEvent);
    if (turn < 0) tell(vtkCommand::MouseWheelBackwardEvent);
    event->accept();
}

void VtkPanel::enterEvent(QEnterEvent* event) {
    setMousePosition(event->position(), event->modifiers());
    tell(vtkCommand::EnterEvent);
}

void VtkPanel::leaveEvent(QEvent*) { tell(vtkCommand::LeaveEvent); }

void VtkPanel::resizeEvent(QResizeEvent*) { refresh(); }

}  // namespace isoscope

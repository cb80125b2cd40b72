// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_driver.h"

#include <cmath>
#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QRegularExpression>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QStandardPaths>
#include <QStyle>
#include <QStyleOptionSlider>

#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/viewport/viewport.h"

namespace isoscope::test {

WindowDriver::WindowDriver() {
    QCoreApplication::setApplicationName(QStringLiteral("isoscope-test"));
    QCoreApplication::setOrganizationName(QStringLiteral("isoscope"));
    QStandardPaths::setTestModeEnabled(true);
    QSettings().clear();
    // By itself only pictures that come quickly get smooth edges: with them no two runs could be compared.
    QSettings().setValue(QStringLiteral("view/antialias"), false);
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).removeRecursively();
    open();
    window_->showTutorial();
}

WindowDriver::~WindowDriver() = default;

void WindowDriver::open() {
    window_ = std::make_unique<MainWindow>();
    // The screen of offscreen windows has 800 x 800, where the first window of a desktop is seldom as small.
    if (!QSettings().contains(QStringLiteral("window/geometry"))) window_->resize(1280, 800);
    window_->show();
    window_->activateWindow();
    if (!QTest::qWaitForWindowExposed(window_.get())) qWarning("the window was never exposed");
}

void WindowDriver::restart() {
    window_->close();
    window_.reset();
    open();
}

void WindowDriver::crash() {
    window_.reset();
    open();
}

bool WindowDriver::rests(int milliseconds) const {
    // Work that was asked for may still be a queued signal away.
    QCoreApplication::processEvents();
    return QTest::qWaitFor([this] { return window_->atRest(); }, milliseconds);
}

QImage WindowDriver::picture() const { return window_->viewport()->picture().copy(); }

void WindowDriver::typeBehind(const QString& text, const QString& typed) {
    SceneEditor* editor = window_->editor();
    const int at = editor->sceneText().toUtf8().indexOf(text.toUtf8());
    if (at < 0) qFatal("the text has no \"%s\"", qPrintable(text));
    editor->SendScintilla(QsciScintilla::SCI_GOTOPOS, at + static_cast<int>(text.toUtf8().size()));
    editor->setFocus();
    QTest::keyClicks(editor->viewport(), typed);
}

int WindowDriver::parameter(const QString& name) const {
    ParameterPanel* panel = window_->parameters();
    for (int i = 0; i < panel->count(); ++i)
        if (panel->slider(i) && panel->slider(i)->name() == name) return i;
    return -1;
}

void WindowDriver::drag(int parameter, int pixels, const std::function<void()>& midway) const {
    // A parse that comes back meanwhile may take the row away.
    const QPointer<QSlider> slider = window_->parameters()->slider(parameter)->findChild<QSlider*>();
    QStyleOptionSlider option;
    option.initFrom(slider.data());
    option.orientation = slider->orientation();
    option.minimum = slider->minimum();
    option.maximum = slider->maximum();
    option.sliderPosition = slider->sliderPosition();
    option.sliderValue = slider->value();
    option.upsideDown = slider->invertedAppearance();
    const QPoint handle =
        slider->style()
            ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider.data())
            .center();
    constexpr int steps = 24;
    QTest::mousePress(slider, Qt::LeftButton, {}, handle);
    for (int i = 1; i <= steps && slider; ++i) {
        QTest::mouseMove(slider, handle + QPoint(pixels * i / steps, 0));
        QTest::qWait(4);
        if (i == steps / 2 && midway) midway();
    }
    if (slider) QTest::mouseRelease(slider, Qt::LeftButton, {}, handle + QPoint(pixels, 0));
}

void WindowDriver::dragViewport(QPoint from, QPoint by, Qt::MouseButton button) const {
    Viewport* viewport = window_->viewport();
    constexpr int steps = 10;
    QTest::mousePress(viewport, button, {}, from);
    for (int i = 1; i <= steps; ++i) {
        QTest::mouseMove(viewport, from + by * i / steps);
        QTest::qWait(4);
    }
    QTest::mouseRelease(viewport, button, {}, from + by);
}

void WindowDriver::wheel(QWidget* widget, QPoint at, int turn) const {
    QWheelEvent event(at, widget->mapToGlobal(QPointF(at)), {}, {0, turn}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
}

double WindowDriver::numberBehind(const QString& key) const {
    const QString text = window_->editor()->sceneText();
    const int at = static_cast<int>(text.indexOf(key));
    if (at < 0) return std::nan("");
    static const QRegularExpression number(QStringLiteral(R"(^\s*([-+]?[0-9]*\.?[0-9]+(e[-+]?[0-9]+)?))"));
    const auto match = number.match(text.mid(at + key.size(), 40));
    return match.hasMatch() ? match.captured(1).toDouble() : std::nan("");
}

void WindowDriver::trigger(QAction* action) { action->trigger(); }

QString WindowDriver::triggerAndChoose(QAction* action, const QString& path) {
    QString suggested;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        auto* name = dialog ? dialog->findChild<QLineEdit*>() : nullptr;
        if (!name) return;
        poll.stop();
        suggested = dialog->selectedFiles().value(0);
        name->setText(path);
        QTest::keyClick(name, Qt::Key_Return);
    });
    poll.start(10);
    action->trigger();
    return suggested;
}

bool WindowDriver::press(const QWidget* bar, const QString& text) {
    for (QPushButton* button : bar->findChildren<QPushButton*>())
        if (button->isVisible() && button->text() == text) {
            QTest::mouseClick(button, Qt::LeftButton);
            return true;
        }
    return false;
}

bool WindowDriver::openText(const QByteArray& text, const QString& name) const {
    QFile file(folder_.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) return false;
    file.close();
    return window_->openFile(file.fileName());
}

double difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull()) return 1;
    constexpr int tolerance = 8;
    qint64 different = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            different += std::abs(qRed(p) - qRed(q)) > tolerance ||
                         std::abs(qGreen(p) - qGreen(q)) > tolerance ||
                         std::abs(qBlue(p) - qBlue(q)) > tolerance;
        }
    return static_cast<double>(different) / (static_cast<double>(a.width()) * a.height());
}

}  // namespace isoscope::test

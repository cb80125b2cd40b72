// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/desktop/real_input.h"

#include <cstdlib>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QProcess>
#include <QStyleHints>
#include <QTest>
#include <QWidget>

namespace isoscope::test {

namespace {

constexpr int dragSteps = 10;

QStringList goTo(QPoint place) {
    return {QStringLiteral("mousemove"), QString::number(place.x()), QString::number(place.y()),
            QStringLiteral("sleep"), QStringLiteral("0.01")};
}

QStringList modifiers(const QString& held, const QString& command) {
    QStringList arguments;
    for (const QString& name : held.split(QLatin1Char('+'), Qt::SkipEmptyParts)) arguments << command << name;
    return arguments;
}

QStringList down(const QString& held) { return modifiers(held, QStringLiteral("keydown")); }
QStringList up(const QString& held) { return modifiers(held, QStringLiteral("keyup")); }

QStringList clicks(RealInput::Button button, int times) {
    QStringList arguments;
    for (const QString number = QString::number(button); times > 0; --times)
        arguments << QStringLiteral("mousedown") << number << QStringLiteral("mouseup") << number;
    return arguments;
}

/// When mouse buttons were pressed while this lives, in milliseconds by the server's clock.
class PressTimes : public QObject {
  public:
    PressTimes() { qApp->installEventFilter(this); }
    const QList<quint64>& times() const { return times_; }

    bool eventFilter(QObject* receiver, QEvent* event) override {
        // The window's event comes once; widgets may pass theirs on.
        const bool press = event->type() == QEvent::MouseButtonPress && receiver->isWindowType();
        if (press) times_ << static_cast<QMouseEvent*>(event)->timestamp();
        return false;
    }

  private:
    QList<quint64> times_;
};

}  // namespace

bool RealInput::available() { return QGuiApplication::platformName() == QLatin1String("xcb"); }

void RealInput::run(const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral("xdotool"), arguments);
    const bool done = QTest::qWaitFor([&] { return program.state() == QProcess::NotRunning; }, 20000) &&
                      program.exitStatus() == QProcess::NormalExit && program.exitCode() == 0;
    if (!done) qFatal("xdotool %s failed", qPrintable(arguments.join(QLatin1Char(' '))));
    // What the server has sent by now is read.
    QTest::qWait(20);
}

void RealInput::moveTo(const QWidget* widget, QPoint at) const { run(goTo(widget->mapToGlobal(at))); }

void RealInput::click(const QWidget* widget, QPoint at, Button button) const {
    run(goTo(widget->mapToGlobal(at)) + clicks(button, 1));
}

void RealInput::doubleClick(const QWidget* widget, QPoint at, Button button) const {
    const int interval = QGuiApplication::styleHints()->mouseDoubleClickInterval();
    for (int tries = 0; tries < 20; ++tries) {
        const PressTimes presses;
        run(goTo(widget->mapToGlobal(at)) + clicks(button, 2));
        if (!QTest::qWaitFor([&] { return presses.times().size() >= 2; })) qFatal("a press did not arrive");
        if (presses.times()[1] - presses.times()[0] < static_cast<quint64>(interval)) return;
        QTest::qWait(2 * interval);
    }
    qFatal("no two presses within %d ms", interval);
}

void RealInput::dragAndHold(const QWidget* widget, QPoint from, QPoint by, Button button,
                            const QString& held) const {
    const QPoint start = widget->mapToGlobal(from);
    QStringList arguments =
        goTo(start) + down(held) + QStringList{QStringLiteral("mousedown"), QString::number(button)};
    for (int i = 1; i <= dragSteps; ++i) arguments += goTo(start + by * i / dragSteps);
    run(arguments);
}

void RealInput::release(Button button, const QString& held) const {
    run(QStringList{QStringLiteral("mouseup"), QString::number(button)} + up(held));
}

void RealInput::drag(const QWidget* widget, QPoint from, QPoint by, Button button,
                     const QString& held) const {
    dragAndHold(widget, from, by, button, held);
    release(button, held);
}

void RealInput::wheel(const QWidget* widget, QPoint at, int notches, const QString& held) const {
    QStringList arguments = goTo(widget->mapToGlobal(at)) + down(held);
    for (int i = std::abs(notches); i > 0; --i)
        arguments << QStringLiteral("click") << (notches > 0 ? QStringLiteral("4") : QStringLiteral("5"));
    run(arguments + up(held));
}

void RealInput::key(const QString& combination) const { run({QStringLiteral("key"), combination}); }

void RealInput::type(const QString& text) const { run({QStringLiteral("type"), text}); }

}  // namespace isoscope::test

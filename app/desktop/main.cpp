// SPDX-License-Identifier: GPL-3.0-or-later
#include <clocale>
#include <cstdio>
#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QProcess>
#include <QTimer>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/main_window.h"
#include "widgets/notice_bar.h"
#include "widgets/theme.h"

namespace {

/// A picture of the window that never comes to rest is taken after this time, in milliseconds.
constexpr int screenshotLimit = 60000;
constexpr int screenshotInterval = 50;

struct Options {
    QString file;
    QString screenshot;
    QString theme;
    QSize size;
};

Options readOptions(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QObject::tr("Type a function of x, y, z in POV-Ray's language and see its surface at once."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"), QObject::tr("A .pov, .inc or .vl file to open."),
                                 QStringLiteral("[FILE]"));
    const QCommandLineOption screenshot(
        QStringLiteral("screenshot"),
        QObject::tr("Write a picture of the window to OUT.png as soon as everything is drawn, then end."),
        QStringLiteral("OUT.png"));
    const QCommandLineOption size(QStringLiteral("size"), QObject::tr("Size of the window."),
                                  QStringLiteral("WxH"));
    const QCommandLineOption theme(QStringLiteral("theme"), QObject::tr("system, light or dark."),
                                   QStringLiteral("NAME"));
    parser.addOptions({screenshot, size, theme});
    parser.process(application);

    Options options;
    options.file = parser.positionalArguments().value(0);
    options.screenshot = parser.value(screenshot);
    options.theme = parser.value(theme);
    const QStringList sides = parser.value(size).split(QLatin1Char('x'));
    if (sides.size() == 2) options.size = {sides[0].toInt(), sides[1].toInt()};
    if (parser.positionalArguments().size() > 1 || (parser.isSet(size) && options.size.isEmpty())) {
        std::fprintf(stderr, "%s\n", qPrintable(parser.helpText()));
        std::exit(2);
    }
    return options;
}

/// Ends the program with a picture of the window; the exit status says whether it could be written.
void takeScreenshot(isoscope::MainWindow& window, const QString& file) {
    auto* timer = new QTimer(&window);
    QElapsedTimer since;
    since.start();
    QObject::connect(timer, &QTimer::timeout, &window, [&window, timer, file, since] {
        if (!window.atRest() && !since.hasExpired(screenshotLimit)) return;
        timer->stop();
        QCoreApplication::sendPostedEvents();  // layouts that wait for texts of the last moment
        const bool written = window.grab().save(file);
        if (!written) std::fprintf(stderr, "%s cannot be written\n", qPrintable(file));
        QCoreApplication::exit(written ? 0 : 1);
    });
    timer->start(screenshotInterval);
}

/// For whoever started the program in a terminal; the window says it, too.
void tellUnread(const QString& problem) {
    if (!problem.isEmpty()) std::fprintf(stderr, "isoscope: %s\n", qPrintable(problem));
}

}  // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    // Qt took the system's locale: with its decimal comma, libraries that print and read numbers in C go
    // wrong.
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setApplicationName(QStringLiteral("isoscope"));
    QApplication::setOrganizationName(QStringLiteral("isoscope"));
    QApplication::setApplicationVersion(QStringLiteral(ISOSCOPE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("isoscope"));
    const Options options = readOptions(application);
    isoscope::MainWindow window;
    // A program of its own: what one window computes, or loses in a crash, is none of the other's business.
    QObject::connect(&window, &isoscope::MainWindow::windowRequested, &window, [&window] {
        if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), {}))
            window.notices()->tell(isoscope::MainWindow::tr("Another window could not be opened."));
    });
    if (!options.theme.isEmpty()) window.setTheme(isoscope::themeFromName(options.theme));
    if (!options.size.isEmpty()) window.resize(options.size);
    window.show();
    if (options.screenshot.isEmpty()) {
        tellUnread(window.start(options.file));
        return QApplication::exec();
    }
    // A picture is the same whatever was done before.
    if (options.file.isEmpty() || !window.openFile(options.file)) {
        tellUnread(window.documents()->document()->errorText());
        window.showTutorial();
    }
    takeScreenshot(window, options.screenshot);
    return QApplication::exec();
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <QApplication>
#include <QBuffer>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QProcess>
#include <QTimer>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/main_window.h"
#include "app/man_page.h"
#include "core/text/whole_file.h"
#include "widgets/interface_language.h"
#include "widgets/notice_bar.h"
#include "widgets/section/font_file.h"
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

QString description() {
    return QObject::tr("Type a function of x, y, z in POV-Ray's language and see its surface at once.");
}

/// All options beside those that every program has; help and manual page are made of them.
QList<QCommandLineOption> options() {
    return {
        {QStringLiteral("screenshot"),
         QObject::tr("Write a picture of the window to OUT.png as soon as everything is drawn, then end."),
         QStringLiteral("OUT.png")},
        {QStringLiteral("size"), QObject::tr("Size of the window."), QStringLiteral("WxH")},
        {QStringLiteral("theme"), QObject::tr("system, light, dark or high-contrast."),
         QStringLiteral("NAME")}};
}

QString fileDescription() { return QObject::tr("A .pov, .inc or .vl file to open."); }

/// The manual page, in man(7).
std::string manual() {
    isoscope::ManPage page{"isoscope",
                           ISOSCOPE_VERSION,
                           "instrument for isosurfaces in POV-Ray's language",
                           "[OPTIONS] [FILE]",
                           {}};
    page.sections.push_back({"DESCRIPTION",
                             description().toStdString() +
                                 "\n\nEvery number of the text is a slider. F1 opens the help, Ctrl+Shift+P "
                                 "finds every command.",
                             {}});
    isoscope::ManSection list{"OPTIONS", "", {{"FILE", fileDescription().toStdString()}}};
    for (const QCommandLineOption& option : options())
        list.entries.push_back(
            {"--" + option.names().constFirst().toStdString() + ' ' + option.valueName().toStdString(),
             option.description().toStdString()});
    list.entries.push_back({"--help", "Displays help on commandline options."});
    list.entries.push_back({"--version", "Displays version information."});
    page.sections.push_back(list);
    page.sections.push_back({"ENVIRONMENT",
                             "",
                             {{"LANG", "Language of the window, where it is one of those that it has."},
                              {"XDG_CONFIG_HOME, XDG_DATA_HOME, XDG_CACHE_HOME",
                               "Where choices, unsaved texts and little pictures are kept."}}});
    page.sections.push_back({"SEE ALSO", "isoscope-cli(1), povray(1)", {}});
    return toRoff(page);
}

Options readOptions(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(description());
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"), fileDescription(), QStringLiteral("[FILE]"));
    parser.addOptions(options());
    parser.process(application);

    Options given;
    given.file = parser.positionalArguments().value(0);
    given.screenshot = parser.value(QStringLiteral("screenshot"));
    given.theme = parser.value(QStringLiteral("theme"));
    const QString size = QStringLiteral("size");
    const QStringList sides = parser.value(size).split(QLatin1Char('x'));
    if (sides.size() == 2) given.size = {sides[0].toInt(), sides[1].toInt()};
    if (parser.positionalArguments().size() > 1 || (parser.isSet(size) && given.size.isEmpty())) {
        std::fprintf(stderr, "%s\n", qPrintable(parser.helpText()));
        std::exit(2);
    }
    return given;
}

/// Writes a picture whole or not at all, in the format that the name's ending says. Returns why it could not.
std::string writePicture(const QPixmap& picture, const QString& file) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, QFileInfo(file).suffix().toLatin1().constData()))
        return "no format of pictures has this ending; use .png";
    return isoscope::writeWhole(QFile::encodeName(file).toStdString(),
                                {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

/// Ends the program with a picture of the window; the exit status says whether it could be written.
void takeScreenshot(isoscope::MainWindow& window, const QString& file) {
    auto* timer = new QTimer(&window);
    QElapsedTimer since;
    since.start();
    QObject::connect(timer, &QTimer::timeout, &window, [&window, timer, file, since] {
        const bool rests = window.atRest();
        if (!rests && !since.hasExpired(screenshotLimit)) return;
        timer->stop();
        if (!rests)
            std::fprintf(stderr, "isoscope: not everything is drawn after %d seconds\n",
                         screenshotLimit / 1000);
        QCoreApplication::sendPostedEvents();  // layouts that wait for texts of the last moment
        const std::string problem = writePicture(window.grab(), file);
        if (!problem.empty())
            std::fprintf(stderr, "%s cannot be written: %s\n", qPrintable(file), problem.c_str());
        QCoreApplication::exit(problem.empty() ? 0 : 1);
    });
    timer->start(screenshotInterval);
}

/// For whoever started the program in a terminal; the window says it, too.
void tellUnread(const QString& problem) {
    if (!problem.isEmpty()) std::fprintf(stderr, "isoscope: %s\n", qPrintable(problem));
}

/// Ends the program with the reason where Qt finds nothing to draw on: Qt itself would abort, which looks
/// like a crash and says that the program should be installed anew. There is no translation before there is
/// an application.
void endWithoutDisplay(QtMsgType type, const QMessageLogContext&, const QString& message) {
    const QByteArray text = message.toLocal8Bit();
    if (type != QtFatalMsg) {
        std::fprintf(stderr, "%s\n", text.constData());
        return;
    }
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM"), display = qgetenv("DISPLAY");
    if (!platform.isEmpty())
        std::fprintf(stderr, "isoscope: the platform \"%s\" of QT_QPA_PLATFORM cannot be used.\n",
                     platform.constData());
    else if (display.isEmpty() && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        std::fprintf(stderr, "isoscope: there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set.\n");
    else
        std::fprintf(stderr, "isoscope: the display cannot be used (DISPLAY=%s).\n%s\n", display.constData(),
                     text.constData());
    std::fputs("isoscope-cli draws, measures and checks scenes without one.\n", stderr);
    std::_Exit(1);
}

/// Without fonts every letter is a box, so that the window cannot tell of it.
void tellMissingFonts() {
    if (!isoscope::hasFonts())
        std::fputs("isoscope: no fonts are installed, so that all letters are drawn as boxes.\n", stderr);
}

int run(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--manual") == 0) {
        std::fputs(manual().c_str(), stdout);
        return std::fflush(stdout) == 0 ? 0 : 1;
    }
    // What only prints needs no display, nor does it ask for one that may be wrong.
    const bool prints = std::any_of(argv + 1, argv + argc, [](const char* word) {
        return std::strcmp(word, "--help") == 0 || std::strcmp(word, "-h") == 0 ||
               std::strcmp(word, "--version") == 0 || std::strcmp(word, "-v") == 0;
    });
    if (prints) qputenv("QT_QPA_PLATFORM", "offscreen");
    const QtMessageHandler usual = qInstallMessageHandler(endWithoutDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(usual);
    // Qt took the system's locale: with its decimal comma, libraries that print and read numbers in C go
    // wrong.
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setApplicationName(QStringLiteral("isoscope"));
    QApplication::setOrganizationName(QStringLiteral("isoscope"));
    QApplication::setApplicationVersion(QStringLiteral(ISOSCOPE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("isoscope"));
    isoscope::applyInterfaceLanguage();  // help and mistakes of the command line, too
    const Options options = readOptions(application);
    tellMissingFonts();
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

}  // namespace

int main(int argc, char** argv) {
    // Memory and threads may be refused. The text is kept as it is for any other end of the program.
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("isoscope: there is not enough memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "isoscope: %s\n", error.what());
    }
    return 1;
}

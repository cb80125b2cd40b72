// SPDX-License-Identifier: GPL-3.0-or-later
// The window is killed at random moments of a scripted use: nothing older than two seconds is lost, no file
// is damaged, and what was not saved is offered once. ISOSCOPE_KILLS sets how often (20).
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <time.h>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/main_window.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

using namespace isoscope;

namespace {

/// What is promised, in milliseconds.
constexpr qint64 promised = 2000;
const QString sceneName = QStringLiteral("scene.pov");
const QByteArray begun = "sphere { 0, 1 pigment { rgb 1 } }\n";

/// The same clock in all processes.
qint64 now() {
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000 + time.tv_nsec / 1'000'000;
}

/// Every state of the text ends with the number of the edit that made it, so that a text tells how old it is.
QByteArray mark(int edit) { return "//" + QByteArray::number(edit) + "\n"; }

int numberOf(const QByteArray& text) {
    const qsizetype at = text.lastIndexOf("//");
    return at < 0 ? 0 : text.mid(at + 2).trimmed().toInt();
}

/// Whole: as the script writes it, from the first line to the last.
bool isWhole(const QByteArray& text) {
    QByteArray expected = begun;
    for (int edit = 1; edit <= numberOf(text); ++edit) expected += mark(edit);
    return text == expected;
}

/// The killed program: edits, saves and now and then does nothing, for ever. Each edit is told, with its
/// time, before the next.
int useUntilKilled(const QString& folder, quint32 seed) {
    QRandomGenerator random(seed);
    MainWindow window;
    window.show();
    window.start(folder + '/' + sceneName);
    const int log =
        ::open(QFile::encodeName(folder + "/log").constData(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    int edit = numberOf(window.editor()->sceneText().toUtf8());
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        if (random.bounded(100) < 70) {
            window.editor()->append(QString::fromLatin1(mark(++edit)));
            const QByteArray line = QByteArray::number(edit) + ' ' + QByteArray::number(now()) + '\n';
            if (::write(log, line.constData(), static_cast<std::size_t>(line.size())) != line.size())
                std::abort();
        } else if (random.bounded(100) < 25) {
            window.documents()->save();
        }
        timer.setInterval(random.bounded(1, 250));
    });
    timer.start(1);
    return QApplication::exec();
}

/// The next start: prints what the file, and the text that is offered, hold.
int lookAndEnd(const QString& folder) {
    MainWindow window;
    window.show();
    window.start(folder + '/' + sceneName);
    const QString notice = window.notices()->isVisible() ? window.notices()->text() : QString();
    if (!notice.isEmpty()) window.notices()->findChild<QPushButton*>()->click();
    const QByteArray text = window.editor()->sceneText().toUtf8();
    QFile out(folder + "/seen");
    if (!out.open(QIODevice::WriteOnly)) return 1;
    out.write(notice.toUtf8().replace('\n', ' ') + '\n' + text);
    // Saved: the next kill begins with it.
    return window.documents()->save() ? 0 : 2;
}

}  // namespace

class KillTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString path(const QString& name) const { return folder_.filePath(name); }
    QByteArray contentOf(const QString& name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }
    /// The program with a home of its own.
    void begin(QProcess& process, const QStringList& arguments) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name :
             {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
            environment.insert(QString::fromLatin1(name), path(QStringLiteral("home")));
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), arguments);
    }
    /// The last edit that was made at `limit` or before.
    int lastEditUntil(qint64 limit) const {
        int last = 0;
        for (const QByteArray& line : contentOf(QStringLiteral("log")).split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words.size() == 2 && words[1].toLongLong() <= limit) last = words[0].toInt();
        }
        return last;
    }

  private slots:
    void nothingOlderThanTwoSecondsIsLost() {
        const int kills = std::max(1, qEnvironmentVariableIntValue("ISOSCOPE_KILLS") > 0
                                          ? qEnvironmentVariableIntValue("ISOSCOPE_KILLS")
                                          : 20);
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("%d kills, seed %u", kills, seed);
        QRandomGenerator random(seed);
        QVERIFY(QDir().mkpath(path(QStringLiteral("home"))));
        QFile file(path(sceneName));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(begun);
        file.close();
        int offered = 0;
        qint64 worst = 0;
        for (int kill = 0; kill < kills; ++kill) {
            QFile::remove(path(QStringLiteral("log")));
            QProcess process;
            begin(process, {"--use", folder_.path(), QString::number(random.generate())});
            // From the first edit on, so that a slow start is no easy round.
            QTRY_VERIFY_WITH_TIMEOUT(contentOf(QStringLiteral("log")).contains('\n'), 60000);
            QTest::qWait(random.bounded(4000));
            ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
            const qint64 killed = now();
            QVERIFY(process.waitForFinished());

            const QByteArray onDisk = contentOf(sceneName);
            QVERIFY2(isWhole(onDisk), onDisk.right(200).constData());
            QProcess next;
            begin(next, {"--look", folder_.path()});
            QVERIFY(next.waitForFinished(60000));
            QCOMPARE(next.exitCode(), 0);
            const QByteArray seen = contentOf(QStringLiteral("seen")), notice = seen.left(seen.indexOf('\n')),
                             text = seen.mid(seen.indexOf('\n') + 1);
            const QByteArray where = "kill " + QByteArray::number(kill) + ": " + notice;
            QVERIFY2(isWhole(text), where + text.right(200));
            const int kept = numberOf(text);
            QVERIFY2(kept >= lastEditUntil(killed - promised),
                     where + " has edit " + QByteArray::number(kept) + " of " +
                         QByteArray::number(lastEditUntil(killed - promised)));
            for (qint64 age = 0; age < promised; age += 10)
                if (lastEditUntil(killed - age) > kept) worst = std::max(worst, age);
            // Offered when there is something that the file has not, and once only.
            if (kept > numberOf(onDisk)) {
                QVERIFY2(notice.contains("An unsaved text was kept: scene.pov"), where);
                ++offered;
            }
            QDirIterator copies(path(QStringLiteral("home")), {"*.json"}, QDir::Files,
                                QDirIterator::Subdirectories);
            QVERIFY2(!copies.hasNext(), where);
            QProcess again;
            begin(again, {"--look", folder_.path()});
            QVERIFY(again.waitForFinished(60000));
            QVERIFY2(contentOf(QStringLiteral("seen")).startsWith('\n'), contentOf(QStringLiteral("seen")));
            QCOMPARE(contentOf(sceneName), text);
        }
        qInfo("%d of %d texts were offered; the oldest edit that was lost was %lld ms old", offered, kills,
              static_cast<long long>(worst));
        QVERIFY(kills < 10 || offered > 0);
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("isoscope"));
    QApplication::setOrganizationName(QStringLiteral("isoscope"));
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--use") return useUntilKilled(arguments.value(2), arguments.value(3).toUInt());
    if (arguments.value(1) == "--look") return lookAndEnd(arguments.value(2));
    // Longer than what QtTest takes for hanging.
    qputenv("QTEST_FUNCTION_TIMEOUT", "7200000");
    KillTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "kill_test.moc"

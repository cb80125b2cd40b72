// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/whole_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/program.h"
#include "tests/support/small_disk.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
}

struct stat stateOf(const QString& path) {
    struct stat state {};
    ::stat(path.toLocal8Bit().constData(), &state);
    return state;
}

std::string write(const QString& path, std::string_view content, const WholeFileOptions& options = {}) {
    return writeWhole(path.toStdString(), content, options);
}

}  // namespace

/// P4: what a file is besides its content survives, and a failure leaves what was there.
class WholeFileTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    QString path(const QString& name) const { return folder_->filePath(name); }
    QString file(const QString& name, const QByteArray& text = "old") const {
        return writeFile(folder_->path(), name, text);
    }

  private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }
    void cleanup() {
        // Nothing stays behind but what the test made.
        QVERIFY(QDir(folder_->path()).entryList({"*.part"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    void newFilesHaveTheUsualMode() {
        const mode_t mask = ::umask(022);
        QCOMPARE(write(path("new"), "text"), std::string());
        QCOMPARE(write(path("secret"), "text", {.ownerOnly = true}), std::string());
        ::umask(mask);
        QCOMPARE(stateOf(path("new")).st_mode & 07777, mode_t(0644));
        QCOMPARE(stateOf(path("secret")).st_mode & 07777, mode_t(0600));
        QCOMPARE(contentOf(path("new")), QByteArray("text"));
    }

    void modeOwnerAndGroupStay() {
        const QString scene = file("scene.pov");
        QCOMPARE(::chmod(qPrintable(scene), 0640), 0);
        const bool given = ::chown(qPrintable(scene), 1000, 1001) == 0;
        const struct stat before = stateOf(scene);
        QCOMPARE(write(scene, "new"), std::string());
        QCOMPARE(contentOf(scene), QByteArray("new"));
        QCOMPARE(stateOf(scene).st_mode, before.st_mode);
        QCOMPARE(stateOf(scene).st_uid, before.st_uid);
        QCOMPARE(stateOf(scene).st_gid, before.st_gid);
        if (!given) QSKIP("only root gives files away");
    }

    void hardLinksStayTogether() {
        const QString scene = file("scene.pov", "a longer old text"), other = path("other.pov");
        QCOMPARE(::link(qPrintable(scene), qPrintable(other)), 0);
        for (const char* text : {"new", "a text that is longer than the one before"}) {
            QCOMPARE(write(scene, text), std::string());
            QCOMPARE(contentOf(other), QByteArray(text));
        }
        QCOMPARE(stateOf(scene).st_nlink, nlink_t(2));
    }

    void linksStayLinks() {
        file("target.pov");
        QVERIFY(QFile::link("target.pov", path("link.pov")) && QFile::link("none.pov", path("dangling.pov")));
        QCOMPARE(write(path("link.pov"), "new"), std::string());
        QCOMPARE(write(path("dangling.pov"), "made"), std::string());
        QCOMPARE(contentOf(path("target.pov")), QByteArray("new"));
        QCOMPARE(contentOf(path("none.pov")), QByteArray("made"));
        QVERIFY(QFileInfo(path("link.pov")).isSymLink() && QFileInfo(path("dangling.pov")).isSymLink());
    }

    void attributesStay() {
        const QString scene = file("scene.pov");
        if (runProgram("setfattr", {"-n", "user.note", "-v", "mine", scene}).status != 0)
            QSKIP("no setfattr, or a file system without attributes");
        QCOMPARE(write(scene, "new"), std::string());
        QVERIFY(runProgram("getfattr", {"-n", "user.note", scene}).output.contains("mine"));
        QCOMPARE(contentOf(scene), QByteArray("new"));
    }

    void devicesAreWrittenTo() {
        QCOMPARE(write("/dev/null", "text"), std::string());
        QVERIFY(QByteArray::fromStdString(write("/dev/full", "text")).startsWith("No space left"));
        QVERIFY(S_ISCHR(stateOf("/dev/null").st_mode) && S_ISCHR(stateOf("/dev/full").st_mode));
        QVERIFY(!write(folder_->path(), "text").empty());
        QVERIFY(!write(path("no/such/folder"), "text").empty());
    }

    void aFullDiskCostsNothing_data() {
        QTest::addColumn<bool>("linked");
        QTest::newRow("renamed") << false;
        QTest::newRow("in place") << true;
    }
    void aFullDiskCostsNothing() {
        QFETCH(bool, linked);
        const SmallDisk disk;
        if (!disk.mounted()) QSKIP("a file system can be mounted by root only");
        const QByteArray before(5000, 'o'), after(20000, 'n');
        const QString scene = disk.path("scene.pov");
        QCOMPARE(write(scene, before.toStdString()), std::string());
        if (linked) QCOMPARE(::link(qPrintable(scene), qPrintable(disk.path("other.pov"))), 0);
        disk.fill();
        QCOMPARE(write(scene, after.toStdString()), std::string("No space left on device"));
        QCOMPARE(contentOf(scene), before);
        // Room for the copy beside it, but not for both.
        disk.empty();
        QCOMPARE(write(disk.path("much"), std::string(28 << 10, 'm')), std::string());
        const std::string second = write(scene, after.toStdString());
        QCOMPARE(second.empty(), !linked);
        QCOMPARE(contentOf(scene), linked ? before : after);
        QCOMPARE(QDir(disk.path({})).entryList({"*.part"}, QDir::Files | QDir::Hidden), QStringList());
    }

    void growingFilesTakeTheirPlaceAtTheEnd() {
        for (const bool linked : {false, true}) {
            const QString scene = file("scene.pov");
            QCOMPARE(::chmod(qPrintable(scene), 0640), 0);
            if (linked) QCOMPARE(::link(qPrintable(scene), qPrintable(path("other.pov"))), 0);
            GrowingFile growing(scene.toStdString());
            QVERIFY(growing.append("head 0000 body"));
            QVERIFY(growing.append(" tail"));
            QVERIFY(growing.write(5, "1234"));
            QVERIFY(growing.write(15, "tail, longer"));
            QVERIFY(!growing.write(100, "beyond the end"));
            QCOMPARE(growing.size(), std::uint64_t{27});
            QCOMPARE(contentOf(scene), QByteArray("old"));
            QCOMPARE(growing.finish(), std::string());
            QCOMPARE(contentOf(scene), QByteArray("head 1234 body tail, longer"));
            QCOMPARE(stateOf(scene).st_mode & 07777, mode_t(0640));
            QCOMPARE(stateOf(scene).st_nlink, nlink_t(linked ? 2 : 1));
        }
    }

    void growingFilesLeaveNothingUnfinished() {
        const QString scene = file("scene.pov");
        { QVERIFY(GrowingFile(scene.toStdString()).append("new")); }
        QCOMPARE(contentOf(scene), QByteArray("old"));
        QCOMPARE(GrowingFile(path("no/such/folder").toStdString()).problem(),
                 std::string("No such file or directory"));
        QVERIFY(!GrowingFile(folder_->path().toStdString()).finish().empty());
        GrowingFile full("/dev/full");
        QVERIFY(full.append("text"));
        QVERIFY(QByteArray::fromStdString(full.finish()).startsWith("No space left"));
        const SmallDisk disk;
        if (!disk.mounted()) QSKIP("a file system can be mounted by root only");
        GrowingFile large(disk.path("large").toStdString());
        bool written = true;
        for (int i = 0; written && i < 100; ++i) written = large.append(std::string(10000, 'x'));
        QVERIFY(!written);
        QCOMPARE(large.finish(), std::string("No space left on device"));
        QVERIFY(!QFile::exists(disk.path("large")));
    }

    void readOnlyIsSaid() {
        const SmallDisk disk;
        if (!disk.mounted()) QSKIP("a file system can be mounted by root only");
        const QString scene = disk.path("scene.pov");
        QCOMPARE(write(scene, "old"), std::string());
        disk.setReadOnly(true);
        QCOMPARE(write(scene, "new"), std::string("Read-only file system"));
        QCOMPARE(contentOf(scene), QByteArray("old"));
    }

    /// The file may be written though its folder takes no new one.
    void aFolderThatTakesNoNewFile() {
        const QString scene = file("scene.pov");
        if (runProgram("chattr", {"+i", folder_->path()}).status != 0)
            QSKIP("chattr needs root and a file system that knows it");
        const std::string reason = write(scene, "new");
        runProgram("chattr", {"-i", folder_->path()});
        QCOMPARE(reason, std::string());
        QCOMPARE(contentOf(scene), QByteArray("new"));
        QCOMPARE(runProgram("chattr", {"+i", scene}).status, 0);
        const std::string refused = write(scene, "newer");
        runProgram("chattr", {"-i", scene});
        QVERIFY(!refused.empty());
        QCOMPARE(contentOf(scene), QByteArray("new"));
    }
};

QTEST_APPLESS_MAIN(WholeFileTest)
#include "whole_file_test.moc"

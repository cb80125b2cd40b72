// SPDX-License-Identifier: GPL-3.0-or-later
// What may happen to a file, at each moment of working with it: a message, both versions kept, and nothing
// written over unasked. Real files, on a small file system of the test's own.
#include <QAction>
#include <QPushButton>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "tests/support/small_disk.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

enum class Trouble { changed, removed, readOnly, full };
enum class Moment { open, edit, save };

const QByteArray original = "sphere { 0, 1 pigment { rgb 1 } }\n// end\n";
const QByteArray theirs = "box { 0, 1 }\n";

}  // namespace
Q_DECLARE_METATYPE(Trouble)
Q_DECLARE_METATYPE(Moment)

class FileTroublesTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    std::unique_ptr<SmallDisk> disk_;

    WindowDriver& d() const { return *driver_; }
    QString path() const { return disk_->path(QStringLiteral("scene.pov")); }
    QByteArray onDisk() const {
        QFile file(path());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(no file)");
    }
    void cause(Trouble trouble) const {
        switch (trouble) {
            case Trouble::changed: writeFile(disk_->path({}), QStringLiteral("scene.pov"), theirs); break;
            case Trouble::removed: QFile::remove(path()); break;
            case Trouble::readOnly: disk_->setReadOnly(true); break;
            case Trouble::full: disk_->fill(); break;
        }
    }
    void press(const QString& label) const {
        QVERIFY2(WindowDriver::press(d()->notices(), label),
                 qPrintable("no button " + label + " beside: " + d()->notices()->text()));
    }

  private slots:
    void init() {
        driver_ = std::make_unique<WindowDriver>();
        disk_ = std::make_unique<SmallDisk>();
        if (!disk_->mounted()) QSKIP("a file system can be mounted by root only");
        QVERIFY(d().rests());
        writeFile(disk_->path({}), QStringLiteral("scene.pov"), original);
    }
    void cleanup() {
        driver_.reset();
        disk_.reset();
    }

    void bothVersionsStay_data() {
        QTest::addColumn<Moment>("moment");
        QTest::addColumn<Trouble>("trouble");
        QTest::addColumn<QString>("message");  // "" means that nothing is to be said
        QTest::newRow("open, changed") << Moment::open << Trouble::changed << "";
        QTest::newRow("open, removed") << Moment::open << Trouble::removed << "No such file";
        QTest::newRow("open, read-only") << Moment::open << Trouble::readOnly << "Read-only file system";
        QTest::newRow("open, full") << Moment::open << Trouble::full << "No space left on device";
        QTest::newRow("edit, changed") << Moment::edit << Trouble::changed << "Another program changed";
        QTest::newRow("edit, removed") << Moment::edit << Trouble::removed << "is no longer there";
        QTest::newRow("edit, read-only") << Moment::edit << Trouble::readOnly << "Read-only file system";
        QTest::newRow("edit, full") << Moment::edit << Trouble::full << "No space left on device";
        QTest::newRow("save, changed") << Moment::save << Trouble::changed << "Not saved: another program";
        QTest::newRow("save, removed") << Moment::save << Trouble::removed << "Not saved:";
        QTest::newRow("save, read-only") << Moment::save << Trouble::readOnly << "Read-only file system";
        QTest::newRow("save, full") << Moment::save << Trouble::full << "No space left on device";
    }
    void bothVersionsStay() {
        QFETCH(Moment, moment);
        QFETCH(Trouble, trouble);
        QFETCH(QString, message);
        NoticeBar* bar = d()->notices();
        const auto says = [&] { return bar->isVisible() && bar->text().contains(message); };

        if (moment == Moment::open) cause(trouble);
        const bool missing = moment == Moment::open && trouble == Trouble::removed;
        QCOMPARE(d()->openFile(path()), !missing);
        if (missing) {
            QVERIFY2(says(), qPrintable(bar->text()));
            return;
        }
        QVERIFY(d().rests());
        const QByteArray read = onDisk();
        QCOMPARE(d()->editor()->sceneText().toUtf8(), read);
        if (moment == Moment::edit) cause(trouble);
        d()->editor()->append(QString(QByteArray("// mine\n").repeated(800)));
        const QByteArray mine = d()->editor()->sceneText().toUtf8();
        const bool others = trouble == Trouble::changed || trouble == Trouble::removed;
        if (moment == Moment::edit && others) QTRY_VERIFY2(says(), qPrintable(bar->text()));
        if (moment == Moment::save) cause(trouble);
        const QByteArray before = onDisk();

        const bool saved = d()->documents()->save();
        if (message.isEmpty()) {
            QVERIFY2(saved, qPrintable(bar->text()));
            QCOMPARE(onDisk(), mine);
            return;
        }
        QVERIFY(!saved);
        if (moment != Moment::edit || !others) QVERIFY2(says(), qPrintable(bar->text()));
        QVERIFY2(bar->isVisible() && !bar->text().contains(QStringLiteral("Unknown error")),
                 qPrintable(bar->text()));
        // Theirs, or what was there before, on the disk; mine in the editor and, after a kill, kept.
        QCOMPARE(onDisk(), before);
        QCOMPARE(d()->editor()->sceneText().toUtf8(), mine);
        QVERIFY(d()->isWindowModified());
        d().crash();
        d()->start({});
        QVERIFY2(d()->notices()->text().contains(QStringLiteral("kept: scene.pov")),
                 qPrintable(d()->notices()->text()));
        QCOMPARE(onDisk(), before);
        press(QStringLiteral("Bring Back"));
        QCOMPARE(d()->editor()->sceneText().toUtf8(), mine);
        QCOMPARE(onDisk(), before);
    }
};

QTEST_MAIN(FileTroublesTest)
#include "file_troubles_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/document/recent_files.h"

#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

using namespace isoscope;

class RecentFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        QCoreApplication::setOrganizationName("isoscope-test");
        QCoreApplication::setApplicationName("recent_files_test");
        QSettings().clear();
    }

    void keepsTheNewestFirst() {
        RecentFiles recent;
        for (int i = 0; i < RecentFiles::limit + 3; ++i) recent.add(QString("/tmp/%1.pov").arg(i));
        QCOMPARE(recent.paths().size(), RecentFiles::limit);
        QCOMPARE(recent.paths().first(), QString("/tmp/12.pov"));
        recent.add("/tmp/8.pov");
        QCOMPARE(recent.paths().first(), QString("/tmp/8.pov"));
        QCOMPARE(recent.paths().count("/tmp/8.pov"), 1);
    }

    void staysForTheNextStart() {
        RecentFiles().add("/tmp/a.pov");
        QCOMPARE(RecentFiles().paths(), QStringList{"/tmp/a.pov"});
        RecentFiles().remove("/tmp/a.pov");
        QVERIFY(RecentFiles().paths().isEmpty());
    }

    void fillsAMenu() {
        RecentFiles recent;
        QMenu menu;
        recent.fill(&menu);
        QCOMPARE(menu.actions().size(), 1);
        QVERIFY(!menu.actions().first()->isEnabled());
        recent.add("/tmp/a & b.pov");
        QCOMPARE(menu.actions().size(), 3);
        QCOMPARE(menu.actions().first()->text(), QString("&1  /tmp/a && b.pov"));
        QSignalSpy opened(&recent, &RecentFiles::openRequested);
        menu.actions().first()->trigger();
        QCOMPARE(opened.takeFirst().first().toString(), QString("/tmp/a & b.pov"));
        menu.actions().last()->trigger();
        QTRY_COMPARE(menu.actions().size(), 1);
        QVERIFY(recent.paths().isEmpty());
    }
};

QTEST_MAIN(RecentFilesTest)
#include "recent_files_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_sources.h"

#include <QFile>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include "core/language/parse.h"
#include "widgets/gallery/gallery_model.h"
#include "widgets/gallery/own_collection.h"

using namespace isoscope;

class GallerySourcesTest : public QObject {
    Q_OBJECT

  private slots:
    void everySceneOfTheLessonsIsThereAndParses() {
        const QList<GalleryEntry> lessons = lessonEntries();
        QSet<QString> headings;
        for (const GalleryEntry& entry : lessons) {
            headings << entry.title;
            QVERIFY(entry.kind == GalleryEntry::Kind::lesson);
            QVERIFY2(!entry.title.startsWith(QLatin1Char('#')), qPrintable(entry.title));
            QVERIFY2(!entry.sentence.isEmpty(), qPrintable(entry.title));
            QVERIFY2(parseScene(entry.text.toStdString()).ok(),
                     qPrintable(entry.title + ": " + entry.sentence));
        }
        QVERIFY2(headings.size() >= 11, qPrintable(QString::number(headings.size())));
        QVERIFY(headings.contains(QStringLiteral("3. The container")));
    }

    void everyFunctionHasASentence() {
        for (const GalleryEntry& entry : functionEntries())
            QVERIFY2(!entry.sentence.isEmpty(), qPrintable(entry.title));
    }

    void ownScenesAreRenamed() {
        const QTemporaryDir folder;
        const OwnCollection own(folder.path());
        QVERIFY(own.add(QStringLiteral("One"), QStringLiteral("// First.\n")));
        QVERIFY(own.add(QStringLiteral("Two"), QStringLiteral("// Second.\n")));
        const QString file = own.entries().constFirst().file;
        // A title that is taken, and one with characters that no file has.
        QVERIFY(own.rename(file, QStringLiteral("Two")));
        QCOMPARE(own.entries().size(), 2);
        const auto titled = [&own](const QString& title) {
            for (const GalleryEntry& entry : own.entries())
                if (entry.title == title) return entry;
            return GalleryEntry();
        };
        QCOMPARE(titled(QStringLiteral("Two")).sentence, QStringLiteral("Second."));
        QCOMPARE(titled(QStringLiteral("Two (2)")).sentence, QStringLiteral("First."));
        QVERIFY(own.rename(titled(QStringLiteral("Two (2)")).file, QStringLiteral("a/b: ..\\é 図")));
        QStringList titles;
        for (const GalleryEntry& entry : own.entries()) titles << entry.title;
        QVERIFY2(titles.contains(QStringLiteral("a/b: ..\\é 図")), qPrintable(titles.join(", ")));
        // Not what lies elsewhere, is missing, or has no name.
        const QString other = QTemporaryDir().path();
        QVERIFY(!own.rename(other + QStringLiteral("/x.scene"), QStringLiteral("X")));
        QVERIFY(!own.rename(file, QStringLiteral("X")));
        QVERIFY(!own.rename(own.entries()[0].file, QStringLiteral("  ")));
        QCOMPARE(own.entries().size(), 2);
    }

    void onlyOwnScenesTakeAnotherTitle() {
        GalleryModel model;
        GalleryEntry own, other;
        own.kind = GalleryEntry::Kind::own;
        own.title = QStringLiteral("Mine");
        other.title = QStringLiteral("Theirs");
        model.setEntries({own, other});
        QVERIFY(model.flags(model.index(0)) & Qt::ItemIsEditable);
        QVERIFY(!(model.flags(model.index(1)) & Qt::ItemIsEditable));
        QStringList asked;
        connect(&model, &GalleryModel::renamed, this,
                [&asked](int row, const QString& title) { asked << QString::number(row) + title; });
        QVERIFY(!model.setData(model.index(0), QStringLiteral(" Mine "), Qt::EditRole));
        QVERIFY(!model.setData(model.index(0), QString(), Qt::EditRole));
        QVERIFY(model.setData(model.index(0), QStringLiteral("My  ball"), Qt::EditRole));
        QCOMPARE(asked, QStringList{QStringLiteral("0My ball")});
    }
};

QTEST_MAIN(GallerySourcesTest)
#include "gallery_sources_test.moc"

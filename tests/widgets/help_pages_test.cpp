// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the help: their links, their words, and the search for them.
#include <QLineEdit>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTreeView>

#include "core/function/builtins/builtin.h"
#include "widgets/functions/function_snippet.h"
#include "widgets/help/help_browser.h"
#include "widgets/help/help_library.h"
#include "widgets/help/help_markdown.h"
#include "widgets/help/help_panel.h"
#include "widgets/theme.h"

using namespace isoscope;

namespace {

PreparedPage prepared(const HelpLibrary& library, const QString& address) {
    return preparedPage(library.text(address), address,
                        [&library](const QString& page) { return library.isPage(page); });
}

void read(QTextDocument& document, const PreparedPage& page) {
    document.setMarkdown(page.markdown);
    dressDocument(&document, themePalette(Look::light));
}

/// What the links of a document lead to, and the names that can be scrolled to.
struct Anchors {
    QStringList links;
    QSet<QString> names;
};

Anchors anchorsOf(const QTextDocument& document) {
    Anchors anchors;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            const QTextCharFormat format = it.fragment().charFormat();
            if (!format.anchorHref().isEmpty()) anchors.links << format.anchorHref();
            for (const QString& name : format.anchorNames()) anchors.names << name;
        }
    return anchors;
}

}  // namespace

class HelpPagesTest : public QObject {
    Q_OBJECT

    HelpLibrary library_;

    QString shownText(HelpPanel& panel) const { return panel.browser()->toPlainText(); }

  private slots:
    void theIndexNamesPages() {
        QVERIFY(library_.isPage(HelpLibrary::index()));
        int lessons = 0;
        for (const HelpPage& page : library_.contents()) {
            QVERIFY2(library_.isPage(page.address), qPrintable(page.address));
            QVERIFY2(!page.title.isEmpty(), qPrintable(page.address));
            lessons += page.address.startsWith("help/lessons/");
        }
        QCOMPARE(lessons, 12);
    }

    void everyLinkLeadsToAPage() {
        QHash<QString, QSet<QString>> names;
        const auto namesOf = [&](const QString& address) {
            if (!names.contains(address)) {
                QTextDocument document;
                read(document, prepared(library_, address));
                names[address] = anchorsOf(document).names;
            }
            return names[address];
        };
        int count = 0;
        for (const QString& address : library_.all()) {
            const PreparedPage page = prepared(library_, address);
            QVERIFY2(!page.markdown.trimmed().isEmpty(), qPrintable(address));
            QTextDocument document;
            read(document, page);
            for (const QString& link : anchorsOf(document).links) {
                const QString where = address + ": " + link;
                ++count;
                if (link.startsWith("scene:")) {
                    QVERIFY2(link.mid(6).toUInt() < page.scenes.size(), qPrintable(where));
                    continue;
                }
                QVERIFY2(link.startsWith('/'), qPrintable(where));
                const QString target = link.mid(1).section('#', 0, 0), anchor = link.section('#', 1);
                QVERIFY2(library_.isPage(target), qPrintable(where));
                QVERIFY2(anchor.isEmpty() || namesOf(target).contains(anchor), qPrintable(where));
            }
        }
        qInfo("%d links", count);
        QVERIFY(count > 400);
    }

    void linksToNoPageAreText() {
        const auto page = preparedPage("See [a](b.h), [c](d.md#e) and\n[two\nlines](../f.md).\n", "a/x.md",
                                       [](const QString& address) { return address == "a/d.md"; });
        QCOMPARE(page.markdown.trimmed(), QString("See a, [c](/a/d.md#e) and\ntwo\nlines."));
    }

    void aSceneIsOpenedAsItStands() {
        const auto page =
            preparedPage("a\n```mermaid\nx\n```\n```pov as-povray\n// A ball.\nsphere { 0, 1 }\n```\n",
                         "a/x.md", [](const QString&) { return true; });
        QCOMPARE(page.scenes.size(), std::size_t(1));
        QCOMPARE(page.scenes[0].text, QString("// A ball.\nsphere { 0, 1 }\n"));
        QCOMPARE(page.scenes[0].title, QString("A ball"));
        QVERIFY(page.scenes[0].asPovray);
        QVERIFY(page.markdown.contains("(scene:0)"));
        QVERIFY(!page.markdown.contains("mermaid") && !page.markdown.contains("x\n"));
    }

    /// What the function list says, and the scene of its picture.
    void everyBuiltInHasAPage() {
        int count = 0;
        for (const Builtin& builtin : builtins()) {
            if (builtin.name.empty()) continue;
            ++count;
            const QString address = "function/" + QString::fromStdString(builtin.name);
            const PreparedPage page = prepared(library_, address);
            QTextDocument document;
            read(document, page);
            const QString text = document.toPlainText();
            QVERIFY2(text.contains(signature(builtin)), qPrintable(address));
            QVERIFY2(text.contains(QString::fromStdString(builtin.formula)), qPrintable(text));
            for (const BuiltinParameter& parameter : builtin.parameters)
                QVERIFY2(text.contains(QString::fromStdString(parameter.name)), qPrintable(address));
            QCOMPARE(page.scenes.size(), std::size_t(1));
            QVERIFY(page.scenes[0].text.endsWith(QString::fromStdString(thumbnailScene(builtin))));
            QCOMPARE(page.scenes[0].title, QString::fromStdString(builtin.name));
        }
        QVERIFY(count > 100);
    }

    void aWordHasItsPage_data() {
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("address");
        for (const char* setting : {"function", "contained_by", "threshold", "accuracy", "max_gradient",
                                    "evaluate", "open", "max_trace", "all_intersections"})
            QTest::newRow(setting) << setting << QString("help/isosurface.md#%1").arg(setting);
        QTest::newRow("isosurface") << "isosurface"
                                    << "help/isosurface.md";
        QTest::newRow("f_torus") << "f_torus"
                                 << "function/f_torus";
        QTest::newRow("select") << "select"
                                << "povray/operators.md";
        QTest::newRow("a name") << "Radius" << QString();
        QTest::newRow("nothing") << QString() << QString();
        QTest::newRow("no word") << ".*" << QString();
    }
    void aWordHasItsPage() {
        QFETCH(QString, word);
        QFETCH(QString, address);
        QCOMPARE(library_.addressOf(word), address);
    }

    void searchFindsAPage() {
        HelpPanel panel;
        panel.resize(400, 600);
        panel.show();
        panel.open(HelpLibrary::index());
        QVERIFY(!panel.listShown());
        auto* search = panel.findChild<QLineEdit*>();
        search->setFocus();
        QTest::keyClicks(search, "GYROID ball");
        QVERIFY(panel.listShown());
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(!panel.listShown());
        QCOMPARE(panel.browser()->address(), QString("help/lessons/03-container.md"));
        QVERIFY(!panel.browser()->extraSelections().isEmpty());

        // A title that has the word wins over pages that only speak of it.
        search->clear();
        QTest::keyClicks(search, "accuracy");
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(panel.browser()->address(), QString("help/lessons/06-accuracy.md"));
        search->clear();
        QTest::keyClicks(search, "f_torus");
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(panel.browser()->address(), QString("function/f_torus"));

        search->clear();
        QTest::keyClicks(search, "no page has such wordzz");
        QCOMPARE(panel.findChild<QTreeView*>()->model()->rowCount(), 0);
        QTest::keyClick(search, Qt::Key_Return);
        QVERIFY(panel.listShown());
        QTest::keyClick(search, Qt::Key_Escape);
        QVERIFY(!panel.listShown());
        QSignalSpy released(&panel, &HelpPanel::focusReleased);
        QTest::keyClick(search, Qt::Key_Escape);
        QCOMPARE(released.size(), 1);
    }

    void theWayGoesBackAndForward() {
        HelpPanel panel;
        HelpBrowser* browser = panel.browser();
        browser->open("help/isosurface.md#max_gradient");
        browser->open("help/isosurface.md#max_gradient");
        QVERIFY(!browser->canGoBack());
        browser->open("function/f_torus");
        browser->open("no such page.md");
        QCOMPARE(browser->address(), HelpLibrary::index());
        browser->backward();
        QCOMPARE(browser->address(), QString("function/f_torus"));
        browser->backward();
        QCOMPARE(browser->address(), QString("help/isosurface.md#max_gradient"));
        browser->backward();
        QVERIFY(shownText(panel).contains("The isosurface statement"));
        browser->forward();
        QVERIFY(shownText(panel).contains("f_torus"));
        // A new page ends the way forward.
        browser->open("help/window.md");
        QVERIFY(!browser->canGoForward());
    }

    void aTextIsFoundOnThePage() {
        HelpPanel panel;
        HelpBrowser* browser = panel.browser();
        browser->open("help/lessons/02-threshold.md");
        const int places = browser->findText("threshold", true);
        QVERIFY(places > 5);
        const int first = browser->textCursor().selectionStart();
        QCOMPARE(browser->findText("threshold", true), places);
        QVERIFY(browser->textCursor().selectionStart() > first);
        browser->findText("threshold", false);
        QCOMPARE(browser->textCursor().selectionStart(), first);
        // Round at the ends.
        browser->findText("threshold", false);
        QVERIFY(browser->textCursor().selectionStart() > first);
        browser->findText("threshold", true);
        QCOMPARE(browser->textCursor().selectionStart(), first);
        QCOMPARE(browser->findText("no such text", true), 0);
    }
};

QTEST_MAIN(HelpPagesTest)
#include "help_pages_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The window in each of its languages.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "test_folders.h"
#include "tests/app/cut_texts.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/reading_bar.h"
#include "widgets/interface_language.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

const QChar opening(0x27e6), closing(0x27e7);

/// A language whose words are the English ones in brackets.
class Brackets : public QTranslator {
  public:
    bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* text, const char*, int) const override {
        // Qt's own texts are translated by Qt.
        if (QByteArray(context).startsWith('Q') && qstrcmp(context, "QObject") != 0) return {};
        return opening + QString::fromUtf8(text) + closing;
    }
};

/// What a person reads of a widget, and what a screen reader tells of it.
QStringList textsOf(const QWidget* widget) {
    QStringList texts{widget->toolTip(), widget->statusTip(), widget->accessibleName(),
                      widget->accessibleDescription(), widget->whatsThis()};
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) texts << button->text();
    if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << label->text();
    if (const auto* dock = qobject_cast<const QDockWidget*>(widget)) texts << dock->windowTitle();
    if (const auto* menu = qobject_cast<const QMenu*>(widget)) texts << menu->title();
    if (const auto* tree = qobject_cast<const QTreeWidget*>(widget))
        for (int i = 0; i < tree->columnCount(); ++i) texts << tree->headerItem()->text(i);
    for (const QAction* action : widget->actions()) texts << action->text() << action->toolTip();
    return texts;
}

/// Whether the text has words outside of brackets: of two letters at least, and no name of the scene's text.
bool hasPlainWords(QString text) {
    static const QRegularExpression bracketed(QStringLiteral("⟦[^⟦⟧]*⟧")), markup(QStringLiteral("<[^>]*>"));
    static const QRegularExpression words(QStringLiteral("[A-Z]?[a-z]{2,} [a-z]{2,}"));
    while (text.contains(bracketed)) text.remove(bracketed);
    return words.match(text.remove(markup)).hasMatch();
}

}  // namespace

class TranslationTest : public QObject {
    Q_OBJECT

    static void choose(const WindowDriver& d, const QString& code) {
        for (QAction* language : d->actions()->languages)
            if (language->data().toString() == code) return WindowDriver::trigger(language);
        QFAIL(qPrintable(code));
    }

  private slots:
    void initTestCase() {
        // Letters of all languages, wherever the test runs.
        if (QFontDatabase::families(QFontDatabase::Japanese).isEmpty())
            qWarning("no Japanese font is installed (fonts-vlgothic): widths of Japanese are those of boxes");
    }

    void everyLanguageIsComplete() {
        QProcess check;
        check.start(QStringLiteral(ISOSCOPE_SOURCE_DIR "/tools/translate"), {QStringLiteral("--check")});
        QVERIFY(check.waitForFinished(60000));
        if (check.exitCode() == 77) QSKIP(check.readAllStandardOutput().constData());
        QVERIFY2(check.exitCode() == 0, check.readAllStandardOutput().constData());
    }

    void theSystemsFirstKnownLanguageIsTaken() {
        QCOMPARE(bestInterfaceLanguage({"fr-FR", "es-MX", "en-US"}), QStringLiteral("es"));
        QCOMPARE(bestInterfaceLanguage({"ru_RU"}), QStringLiteral("ru"));
        QCOMPARE(bestInterfaceLanguage({"ja"}), QStringLiteral("ja"));
        QCOMPARE(bestInterfaceLanguage({"en-GB", "es-ES"}), QStringLiteral("en"));
        QCOMPARE(bestInterfaceLanguage({"C"}), QStringLiteral("en"));
        QCOMPARE(bestInterfaceLanguage({}), QStringLiteral("en"));
    }

    /// As the text has them: with a comma the place of the section took 0.5 for 5.
    void numbersHaveAPointInEveryCountry() {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        {
            WindowDriver d;
            const auto boxes = d->findChildren<QDoubleSpinBox*>();
            QVERIFY(boxes.size() > 5);
            for (const QDoubleSpinBox* box : boxes) {
                QVERIFY2(box->textFromValue(0.5).contains('.'), qPrintable(box->accessibleName()));
                QVERIFY2(box->valueFromText("0.5") == 0.5, qPrintable(box->accessibleName()));
            }
            ReadingBar bar;
            bar.showProgress(1.5, 10, 0.5);
            QVERIFY2(bar.text().contains("1.5 s"), qPrintable(bar.text()));
        }
        QLocale::setDefault(before);
    }

    void aChosenLanguageCountsFromTheNextStart() {
        WindowDriver d;
        QCOMPARE(d->actions()->save->toolTip(), QStringLiteral("Save the text (Ctrl+S)"));
        choose(d, QStringLiteral("es"));
        QCOMPARE(d->actions()->save->toolTip(), QStringLiteral("Save the text (Ctrl+S)"));
        d.restart();
        QVERIFY(d->actions()->save->toolTip().startsWith(QStringLiteral("Guardar el texto (")));
        QCOMPARE(d->docks()->find("problems")->windowTitle(), QStringLiteral("Problemas"));
        int checked = 0;
        for (const QAction* language : d->actions()->languages) checked += language->isChecked();
        QCOMPARE(checked, 1);
        choose(d, {});
        d.restart();
        QCOMPARE(d->actions()->save->toolTip(), QStringLiteral("Save the text (Ctrl+S)"));
    }

    /// What does not go through tr() stands without the brackets.
    void noTextIsOutsideOfTheTranslations() {
        Brackets brackets;
        QCoreApplication::installTranslator(&brackets);
        {
            WindowDriver d;
            d->resize(1800, 1300);
            QVERIFY(d.rests());
            QStringList plain;
            int bracketed = 0;
            for (QDockWidget* dock : d->docks()->all()) {
                d->docks()->bringUp(dock);
                QTest::qWait(20);
            }
            for (const QWidget* widget : d->findChildren<QWidget*>()) {
                // Qt's own buttons, names of numbers as the text has them, titles of the example files.
                const QByteArray type = widget->metaObject()->className();
                if (type == "QDockWidgetTitleButton" || type == "isoscope::NumberBox" ||
                    type == "isoscope::ExampleMenu")
                    continue;
                for (const QString& text : textsOf(widget)) {
                    bracketed += text.contains(opening);
                    if (hasPlainWords(text))
                        plain << QStringLiteral("%1 %2: %3")
                                     .arg(widget->metaObject()->className(), widget->objectName(), text);
                }
            }
            plain.removeDuplicates();
            for (const QString& text : plain) qWarning("%s", qPrintable(text));
            QVERIFY(plain.isEmpty());
            QVERIFY(bracketed > 500);
        }
        QCoreApplication::removeTranslator(&brackets);
    }

    void theWindowShowsEveryTextWhole_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("percent");
        for (const InterfaceLanguage& language : interfaceLanguages())
            for (const int percent : {100, 200})
                QTest::addRow("%s %d %%", qPrintable(language.code), percent) << language.code << percent;
    }
    void theWindowShowsEveryTextWhole() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        WindowDriver d;
        choose(d, language);
        for (QAction* size : d->actions()->interfaceSizes)
            if (size->data().toInt() == percent) WindowDriver::trigger(size);
        d.restart();
        d->showTutorial();
        d->resize(1800, 1300);
        QVERIFY(d.rests());
        QStringList cut;
        for (QDockWidget* dock : d->docks()->all()) {
            d->docks()->bringUp(dock);
            QTest::qWait(20);
            QStringList here = cutTexts(&d.window());
            if (!here.isEmpty()) {
                // What a study has just written may wait for its layout.
                QTest::qWait(200);
                here = cutTexts(&d.window());
            }
            cut << here;
        }
        cut.removeDuplicates();
        // The next window begins as every other.
        choose(d, {});
        for (QAction* size : d->actions()->interfaceSizes)
            if (size->data().toInt() == 100) WindowDriver::trigger(size);
        for (const QString& text : cut) qWarning("%s", qPrintable(text));
        QVERIFY(cut.isEmpty());
    }

    /// A bug once: "(X)" of menu entries stood on the buttons of tool bars.
    void noToolButtonShowsAnAccessKey() {
        WindowDriver d;
        choose(d, QStringLiteral("ja"));
        d.restart();
        int worded = 0;
        for (const QToolButton* button : d->findChildren<QToolButton*>()) {
            worded += !button->text().isEmpty();
            QVERIFY2(!button->text().contains(QRegularExpression(QStringLiteral(R"(\(&?[A-Z]\))"))),
                     qPrintable(button->text()));
        }
        choose(d, {});
        QVERIFY(worded > 10);
        QCOMPARE(Actions::plainText(QStringLiteral("開く(&O)…")), QStringLiteral("開く"));
        QCOMPARE(Actions::plainText(QStringLiteral("Save &As…")), QStringLiteral("Save As"));
        QCOMPARE(Actions::plainText(QStringLiteral("Compare A/B (&k)")), QStringLiteral("Compare A/B"));
    }

    void noMenuHasAnAccessKeyTwice_data() {
        QTest::addColumn<QString>("language");
        for (const InterfaceLanguage& language : interfaceLanguages())
            QTest::newRow(qPrintable(language.code)) << language.code;
    }
    void noMenuHasAnAccessKeyTwice() {
        QFETCH(QString, language);
        WindowDriver d;
        choose(d, language);
        d.restart();
        QStringList twice;
        QList<QWidget*> menus{d->menuBar()};
        for (QMenu* menu : d->menuBar()->findChildren<QMenu*>()) menus << menu;
        for (const QWidget* menu : menus) {
            QMap<QString, QString> texts;
            for (const QAction* action : menu->actions()) {
                const QString key = QKeySequence::mnemonic(action->text()).toString();
                if (menu == d->menuBar()) QVERIFY2(!key.isEmpty(), qPrintable(action->text()));
                if (key.isEmpty()) continue;
                if (texts.contains(key)) twice << texts[key] + QStringLiteral(" / ") + action->text();
                texts[key] = action->text();
            }
        }
        choose(d, {});
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join('\n')));
    }
};

QTEST_MAIN(TranslationTest)
#include "translation_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/icons.h"

#include <QTest>
#include <QToolButton>

#include "widgets/find_bar.h"
#include "widgets/scene_editor.h"

using namespace isoscope;

class IconsTest : public QObject {
    Q_OBJECT

  private slots:
    void themesAreFound() {
        for (const bool dark : {true, false}) {
            useIconTheme(dark);
            if (!QIcon::hasThemeIcon(QStringLiteral("document-open"))) QSKIP("no icon theme is installed");
            QVERIFY(!themeIcon(QStringLiteral("camera-photo")).pixmap(16, 16).isNull());
        }
    }

    void withoutAnyThemeButtonsStayReadable() {
        const QStringList paths = QIcon::themeSearchPaths();
        QIcon::setThemeSearchPaths({});
        QIcon::setFallbackSearchPaths({});
        QIcon::setThemeName(QStringLiteral("none"));
        QIcon::setFallbackThemeName(QStringLiteral("none"));
        QVERIFY(!themeIcon(QStringLiteral("document-open")).pixmap(16, 16).isNull());
        QVERIFY(themeIcon(QStringLiteral("no-such-icon")).isNull());
        SceneEditor editor;
        FindBar bar(&editor);
        for (const auto* button : bar.findChildren<QToolButton*>())
            QVERIFY2(!button->icon().isNull() || !button->text().isEmpty(),
                     qPrintable(button->accessibleName()));
        QIcon::setThemeSearchPaths(paths);
    }
};

QTEST_MAIN(IconsTest)
#include "icons_test.moc"

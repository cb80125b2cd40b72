// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/icons.h"

#include <cmath>
#include <QApplication>
#include <QTest>
#include <QToolButton>

#include "widgets/editor/find_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/theme.h"
#include "widgets/verdicts/severity_icon.h"

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

    /// D35: warnings and notes had the same white box.
    void signsOfSeveritiesDiffer() {
        QList<QImage> signs;
        for (const Severity severity :
             {Severity::error, Severity::warning, Severity::leftOut, Severity::note})
            signs << severityIcon(severity).pixmap(16, 16).toImage();
        for (qsizetype a = 0; a < signs.size(); ++a)
            for (qsizetype b = a + 1; b < signs.size(); ++b) {
                int different = 0;
                for (int y = 0; y < 16; ++y)
                    for (int x = 0; x < 16; ++x) different += signs[a].pixel(x, y) != signs[b].pixel(x, y);
                QVERIFY2(different > 80, qPrintable(QString::number(different)));
            }
    }

    /// D40: every text that is not switched off is told from its ground by at least 4.5 to 1, as the rules
    /// for accessible pages ask.
    void textsAreReadableInBothThemes() {
        const auto luminance = [](const QColor& color) {
            const auto linear = [](double c) {
                return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
                   0.0722 * linear(color.blueF());
        };
        for (const Theme theme : {Theme::dark, Theme::light}) {
            applyTheme(theme);
            const QPalette palette = QApplication::palette();
            for (const auto ink : {QPalette::WindowText, QPalette::Text, QPalette::PlaceholderText})
                for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
                    const double a = luminance(palette.color(ink)) + 0.05,
                                 b = luminance(palette.color(ground)) + 0.05;
                    const double contrast = std::max(a, b) / std::min(a, b);
                    QVERIFY2(contrast >= 4.5,
                             qPrintable(QStringLiteral("%1 on %2: %3").arg(ink).arg(ground).arg(contrast)));
                }
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

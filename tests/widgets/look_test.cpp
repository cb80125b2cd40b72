// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look.h"

#include <QApplication>
#include <QRandomGenerator>
#include <QTest>

#include "widgets/editor/editor_grounds.h"
#include "widgets/editor/scene_lexer.h"
#include "widgets/theme.h"
#include "widgets/verdicts/verdict_symbol.h"

using namespace isoscope;

namespace {

QString told(const QColor& ink, const QColor& ground) {
    return QStringLiteral("%1 on %2: %3").arg(ink.name(), ground.name()).arg(contrastRatio(ink, ground));
}

}  // namespace

class LookTest : public QObject {
    Q_OBJECT

  private slots:
    /// Values of WCAG's own examples: 21 for black and white, and the grey that just fails 4.5.
    void contrastIsThatOfWcag() {
        QCOMPARE(contrastRatio(Qt::black, Qt::white), 21.0);
        QCOMPARE(contrastRatio(Qt::white, Qt::black), 21.0);
        QCOMPARE(contrastRatio(Qt::red, Qt::red), 1.0);
        QVERIFY(std::abs(contrastRatio(0x777777, Qt::white) - 4.48) < 0.005);
        QVERIFY(std::abs(contrastRatio(0x767676, Qt::white) - 4.54) < 0.005);
    }

    void legibleColoursAreAndKeepWhatTheyCan() {
        const quint32 seed = QRandomGenerator::global()->generate();
        qInfo("seed %u", seed);
        QRandomGenerator random(seed);
        const auto any = [&random] { return QColor::fromRgb(random.generate() | 0xff000000U); };
        for (int i = 0; i < 2000; ++i) {
            const QColor color = any(), ground = any();
            const double best = std::max(contrastRatio(Qt::white, ground), contrastRatio(Qt::black, ground));
            for (const double ratio : {1.0, 3.0, 4.5, 7.0}) {
                const QColor made = legible(color, ground, ratio);
                QVERIFY2(contrastRatio(made, ground) >= std::min(ratio, best),
                         qPrintable(told(made, ground)));
                if (contrastRatio(color, ground) >= ratio) QCOMPARE(made, color);
            }
        }
    }

    void looksAreToldByTheirPalettes() {
        for (const Look look : {Look::light, Look::dark, Look::highContrast})
            QCOMPARE(lookOf(themePalette(look)), look);
        for (const Theme theme : {Theme::light, Theme::dark, Theme::highContrast, Theme::system})
            QCOMPARE(themeFromName(themeName(theme)), theme);
    }

    /// Also where it is disabled, selected or a tool tip.
    void textsOfHighContrastHaveSevenToOne() {
        const QPalette palette = themePalette(Look::highContrast);
        using P = QPalette;
        const std::pair<QList<P::ColorRole>, QList<P::ColorRole>> pairs[] = {
            {{P::WindowText, P::Text, P::ButtonText, P::PlaceholderText, P::BrightText, P::Link,
              P::LinkVisited},
             {P::Window, P::Base, P::AlternateBase, P::Button}},
            {{P::HighlightedText}, {P::Highlight}},
            {{P::ToolTipText}, {P::ToolTipBase}}};
        for (const auto group : {P::Active, P::Inactive, P::Disabled})
            for (const auto& [inks, grounds] : pairs)
                for (const auto ink : inks)
                    for (const auto ground : grounds) {
                        const QColor on = palette.color(group, ground), text = palette.color(group, ink);
                        QVERIFY2(contrastRatio(text, on) >= highContrastRatio, qPrintable(told(text, on)));
                    }
    }

    void wordsOfTheTextAreLegibleOnEveryGround_data() {
        QTest::addColumn<int>("look");
        QTest::addColumn<double>("ratio");
        // What WCAG asks of any text, and of the strictest.
        QTest::newRow("light") << static_cast<int>(Look::light) << 4.5;
        QTest::newRow("dark") << static_cast<int>(Look::dark) << 4.5;
        QTest::newRow("high contrast") << static_cast<int>(Look::highContrast) << highContrastRatio;
    }
    void wordsOfTheTextAreLegibleOnEveryGround() {
        QFETCH(int, look);
        QFETCH(double, ratio);
        const Look of = static_cast<Look>(look);
        const EditorGrounds& grounds = editorGrounds(of);
        for (int style = 0; style < static_cast<int>(SceneStyle::count); ++style) {
            const QColor ink = SceneLexer::textColor(static_cast<SceneStyle>(style), of);
            for (const QColor& ground : {SceneLexer::paperColor(of), grounds.caretLine, grounds.margin})
                QVERIFY2(contrastRatio(ink, ground) >= ratio, qPrintable(told(ink, ground)));
        }
        const QColor plain = SceneLexer::textColor(SceneStyle::plain, of);
        for (const QColor& ground : {grounds.selection, grounds.brace, grounds.loneBrace, grounds.callTip})
            QVERIFY2(contrastRatio(plain, ground) >= ratio, qPrintable(told(plain, ground)));
    }

    /// The sign of a verdict is drawn in black on its colour, and that on black.
    void signsOfVerdictsAreLegibleInHighContrast() {
        for (const auto verdict : {GradientVerdict::right, GradientVerdict::holes, GradientVerdict::wasteful,
                                   GradientVerdict::unbounded, GradientVerdict::unproven}) {
            const QColor color = verdictSymbolColor(verdict, Look::highContrast);
            QVERIFY2(contrastRatio(color, Qt::black) >= highContrastRatio, qPrintable(color.name()));
        }
    }
};

QTEST_MAIN(LookTest)
#include "look_test.moc"

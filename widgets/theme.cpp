// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme.h"

#include <QApplication>
#include <QStyle>
#include <QStyleFactory>

#include "widgets/icons.h"

namespace isoscope {

namespace {

QPalette darkPalette() {
    QPalette p;
    p.setColor(QPalette::Window, 0x2b2e33);
    p.setColor(QPalette::WindowText, 0xe2e4e8);
    p.setColor(QPalette::Base, 0x1e2024);
    p.setColor(QPalette::AlternateBase, 0x25282d);
    p.setColor(QPalette::Text, 0xe2e4e8);
    p.setColor(QPalette::PlaceholderText, 0x9ba1aa);
    p.setColor(QPalette::Button, 0x353940);
    p.setColor(QPalette::ButtonText, 0xe2e4e8);
    p.setColor(QPalette::BrightText, 0xffffff);
    p.setColor(QPalette::Highlight, 0x3d7edb);
    p.setColor(QPalette::HighlightedText, 0xffffff);
    p.setColor(QPalette::Link, 0x6ab0ff);
    p.setColor(QPalette::LinkVisited, 0xb794f4);
    p.setColor(QPalette::ToolTipBase, 0x353940);
    p.setColor(QPalette::ToolTipText, 0xe2e4e8);
    // Fusion derives its bevels from these; its own guesses are too bright on a dark window.
    p.setColor(QPalette::Light, 0x474c55);
    p.setColor(QPalette::Midlight, 0x3d424a);
    p.setColor(QPalette::Mid, 0x24272b);
    p.setColor(QPalette::Dark, 0x1a1c1f);
    p.setColor(QPalette::Shadow, 0x101113);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, 0x757b84);
    p.setColor(QPalette::Disabled, QPalette::Highlight, 0x474c55);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, 0x9aa0a8);
    return p;
}

QPalette lightPalette() {
    QPalette p;
    p.setColor(QPalette::Window, 0xf2f3f5);
    p.setColor(QPalette::WindowText, 0x202226);
    p.setColor(QPalette::Base, 0xffffff);
    p.setColor(QPalette::AlternateBase, 0xf6f7f9);
    p.setColor(QPalette::Text, 0x202226);
    p.setColor(QPalette::PlaceholderText, 0x5f656d);
    p.setColor(QPalette::Button, 0xe9ebee);
    p.setColor(QPalette::ButtonText, 0x202226);
    p.setColor(QPalette::BrightText, 0xffffff);
    p.setColor(QPalette::Highlight, 0x2f6fd0);
    p.setColor(QPalette::HighlightedText, 0xffffff);
    p.setColor(QPalette::Link, 0x1d5fbf);
    p.setColor(QPalette::LinkVisited, 0x6b3fb0);
    p.setColor(QPalette::ToolTipBase, 0xffffff);
    p.setColor(QPalette::ToolTipText, 0x202226);
    p.setColor(QPalette::Light, 0xffffff);
    p.setColor(QPalette::Midlight, 0xf8f9fa);
    p.setColor(QPalette::Mid, 0xc4c8ce);
    p.setColor(QPalette::Dark, 0xa3a8b0);
    p.setColor(QPalette::Shadow, 0x70757d);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, 0x8f959d);
    p.setColor(QPalette::Disabled, QPalette::Highlight, 0xc4c8ce);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, 0x5c626a);
    return p;
}

/// What the desktop asked for before the first call changed the palette.
bool desktopIsDark() {
    static const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

}  // namespace

void applyTheme(Theme theme) {
    const bool dark = isDark(theme);
    if (!QApplication::style() || QApplication::style()->name() != QLatin1String("fusion"))
        QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    useIconTheme(dark);
    QApplication::setPalette(themePalette(dark));
}

bool isDark(Theme theme) {
    const bool desktop = desktopIsDark();
    return theme == Theme::system ? desktop : theme == Theme::dark;
}

QPalette themePalette(bool dark) { return dark ? darkPalette() : lightPalette(); }

QString themeName(Theme theme) {
    switch (theme) {
        case Theme::light: return QStringLiteral("light");
        case Theme::dark: return QStringLiteral("dark");
        default: return QStringLiteral("system");
    }
}

Theme themeFromName(const QString& name) {
    if (name == QLatin1String("light")) return Theme::light;
    if (name == QLatin1String("dark")) return Theme::dark;
    return Theme::system;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme.h"

#include <QApplication>

#include "widgets/icons.h"
#include "widgets/interface_style.h"

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

/// Each text has highContrastRatio to each ground that it can stand on, also where it is disabled.
QPalette highContrastPalette() {
    QPalette p;
    for (const auto role : {QPalette::Window, QPalette::Base, QPalette::Button, QPalette::ToolTipBase})
        p.setColor(role, Qt::black);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText,
                            QPalette::HighlightedText})
        p.setColor(role, Qt::white);
    p.setColor(QPalette::AlternateBase, 0x141414);
    p.setColor(QPalette::PlaceholderText, 0xd0d0d0);
    // What has the focus, or is chosen among tabs.
    p.setColor(QPalette::BrightText, 0xffff00);
    p.setColor(QPalette::Highlight, 0x1030ff);
    p.setColor(QPalette::Link, 0x8cc8ff);
    p.setColor(QPalette::LinkVisited, 0xdcb8ff);
    p.setColor(QPalette::Light, 0xffffff);
    p.setColor(QPalette::Midlight, 0xd0d0d0);
    p.setColor(QPalette::Mid, 0x909090);
    p.setColor(QPalette::Dark, 0x606060);
    p.setColor(QPalette::Shadow, 0x303030);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, 0xa4a4a4);
    p.setColor(QPalette::Disabled, QPalette::Highlight, 0x303030);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, 0xd0d0d0);
    return p;
}

/// What the desktop asked for before the first call changed the palette.
bool desktopIsDark() {
    static const bool dark = QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
    return dark;
}

}  // namespace

void applyTheme(Theme theme) {
    const Look look = lookOf(theme);
    if (!qobject_cast<InterfaceStyle*>(QApplication::style())) {
        QApplication::setStyle(new InterfaceStyle);
        setInterfaceSize(interfaceSize());
    }
    useIconTheme(look != Look::light);
    QApplication::setPalette(themePalette(look));
}

Look lookOf(Theme theme) {
    const bool desktop = desktopIsDark();
    if (theme == Theme::highContrast) return Look::highContrast;
    return theme == Theme::dark || (theme == Theme::system && desktop) ? Look::dark : Look::light;
}

QPalette themePalette(Look look) {
    switch (look) {
        case Look::dark: return darkPalette();
        case Look::highContrast: return highContrastPalette();
        default: return lightPalette();
    }
}

QString themeName(Theme theme) {
    switch (theme) {
        case Theme::light: return QStringLiteral("light");
        case Theme::dark: return QStringLiteral("dark");
        case Theme::highContrast: return QStringLiteral("high-contrast");
        default: return QStringLiteral("system");
    }
}

Theme themeFromName(const QString& name) {
    if (name == QLatin1String("light")) return Theme::light;
    if (name == QLatin1String("dark")) return Theme::dark;
    if (name == QLatin1String("high-contrast")) return Theme::highContrast;
    return Theme::system;
}

}  // namespace isoscope

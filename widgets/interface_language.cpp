// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/interface_language.h"

#include <algorithm>
#include <memory>
#include <vector>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QSettings>
#include <QTranslator>

/// The resources of a static library are registered by hand; the macro wants to stand outside of namespaces.
static void registerTranslations() { Q_INIT_RESOURCE(translations); }

namespace isoscope {

namespace {

const QString languageKey = QStringLiteral("window/language");

bool isKnown(const QString& code) {
    const QList<InterfaceLanguage>& all = interfaceLanguages();
    return std::any_of(all.begin(), all.end(), [&](const auto& known) { return known.code == code; });
}

}  // namespace

const QList<InterfaceLanguage>& interfaceLanguages() {
    static const QList<InterfaceLanguage> all{{QStringLiteral("en"), QStringLiteral("English")},
                                              {QStringLiteral("es"), QStringLiteral("Español")},
                                              {QStringLiteral("ru"), QStringLiteral("Русский")},
                                              {QStringLiteral("ja"), QStringLiteral("日本語")}};
    return all;
}

QString chosenInterfaceLanguage() {
    const QString code = QSettings().value(languageKey).toString();
    return isKnown(code) ? code : QString();
}

void chooseInterfaceLanguage(const QString& code) { QSettings().setValue(languageKey, code); }

QString bestInterfaceLanguage(const QStringList& wanted) {
    for (const QString& name : wanted) {
        const QString code = QString(name).replace(QLatin1Char('-'), QLatin1Char('_')).section('_', 0, 0);
        if (isKnown(code)) return code;
    }
    return interfaceLanguages().constFirst().code;
}

void applyInterfaceLanguage() {
    registerTranslations();
    static std::vector<std::unique_ptr<QTranslator>> installed;
    installed.clear();  // a translator that ends takes itself away
    QString code = chosenInterfaceLanguage();
    if (code.isEmpty()) code = bestInterfaceLanguage(QLocale::system().uiLanguages());
    const auto install = [](const QString& name, const QString& folder) {
        auto translator = std::make_unique<QTranslator>();
        if (!translator->load(name, folder)) return;
        QCoreApplication::installTranslator(translator.get());
        installed.push_back(std::move(translator));
    };
    install(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    // English has its plurals only.
    install(QStringLiteral("isoscope_") + code, QStringLiteral(":/translations"));
}

QString withoutAccessKey(QString text) {
    static const QRegularExpression bracketed(QStringLiteral(R"(\s*\(&\w\))"));
    text.replace(QLatin1String("&&"), QString(QChar(0)));
    return text.remove(bracketed).remove(QLatin1Char('&')).replace(QChar(0), QLatin1Char('&'));
}

}  // namespace isoscope

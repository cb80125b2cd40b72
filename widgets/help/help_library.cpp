// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_library.h"

#include <algorithm>
#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include "core/function/builtins/builtin.h"
#include "core/language/tokens/words.h"
#include "widgets/help/function_page.h"
#include "widgets/help/help_markdown.h"

/// The resources of a static library are registered by hand; the macro wants to stand outside of namespaces.
static void registerHelpResource() { Q_INIT_RESOURCE(help); }

namespace isoscope {
namespace {

const QString root = QStringLiteral(":/docs/");
const QString functionFolder = QStringLiteral("function/");
const QString functionIndex = QStringLiteral("help/functions.md");
const QString statementPage = QStringLiteral("help/isosurface.md");

QString read(const QString& address) {
    QFile file(root + address);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

const Builtin* functionAt(const QString& address) {
    if (!address.startsWith(functionFolder)) return nullptr;
    const std::string name = address.mid(functionFolder.size()).toStdString();
    return name.empty() ? nullptr : findBuiltin(name);
}

QString titleOf(const QString& text) {
    static const QRegularExpression title(QStringLiteral("^# +(.*)$"), QRegularExpression::MultilineOption);
    return title.match(text).captured(1);
}

/// What the index calls a page; lessons have numbers.
QString listTitle(const QString& link, const QString& page) {
    const QString title = titleOf(page);
    return !title.isEmpty() && title.at(0).isDigit() ? title : link.left(1).toUpper() + link.mid(1);
}

/// Whether the page has the word in its code, or as the subject of a row of a table.
bool explains(const QString& text, const QString& word) {
    const QRegularExpression place(
        QStringLiteral("`[^`\\n]*\\b%1\\b[^`\\n]*`|^\\|[^|]*\\b%1\\b").arg(QRegularExpression::escape(word)),
        QRegularExpression::MultilineOption);
    return place.match(text).hasMatch();
}

}  // namespace

void HelpLibrary::registerPages() { registerHelpResource(); }

HelpLibrary::HelpLibrary() {
    registerPages();
    static const QRegularExpression heading(QStringLiteral("^## +(.*)$"));
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\(([^()\\s]+)\\)"));
    const QString text = read(index());
    // What the index says stands on the pages that it names.
    contents_.push_back({index(), titleOf(text), QString(), QString()});
    QString group;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (const auto match = heading.match(line); match.hasMatch()) group = match.captured(1);
        for (auto found = link.globalMatch(line); found.hasNext();) {
            const auto match = found.next();
            const QString address = resolvedAddress(index(), match.captured(2));
            const QString page = read(address);
            if (!page.isEmpty())
                contents_.push_back({address, listTitle(match.captured(1), page), group, page});
        }
    }
    static const QRegularExpression scenes(QStringLiteral("```pov.*?```"),
                                           QRegularExpression::DotMatchesEverythingOption);
    std::vector<HelpPage> functions;
    for (const Builtin& builtin : builtins()) {
        if (builtin.name.empty()) continue;
        const QString name = QString::fromStdString(builtin.name);
        functions.push_back({functionFolder + name, name,
                             QCoreApplication::translate("HelpPanel", "Built-in functions"),
                             functionPage(builtin).remove(scenes)});
    }
    std::ranges::sort(functions, {}, &HelpPage::title);
    contents_.insert(contents_.end(), functions.begin(), functions.end());
}

QString HelpLibrary::index() { return QStringLiteral("help/README.md"); }

QStringList HelpLibrary::all() const {
    QStringList addresses;
    for (QDirIterator file(root, {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
         file.hasNext();)
        addresses << file.next().mid(root.size());
    for (const HelpPage& page : contents_)
        if (page.address.startsWith(functionFolder)) addresses << page.address;
    addresses.sort();
    return addresses;
}

bool HelpLibrary::isPage(const QString& address) const {
    return functionAt(address) || (address.endsWith(QLatin1String(".md")) && QFile::exists(root + address));
}

QString HelpLibrary::text(const QString& address) const {
    if (const Builtin* builtin = functionAt(address)) return functionPage(*builtin);
    const QString text = read(address);
    return address == functionIndex ? text + functionLinks() : text;
}

QString HelpLibrary::addressOf(const QString& word) const {
    if (word.isEmpty()) return {};
    if (word == QLatin1String("isosurface")) return statementPage;
    const QString function = functionFolder + word;
    if (functionAt(function)) return function;
    const QRegularExpression heading(QStringLiteral("^## %1$").arg(QRegularExpression::escape(word)),
                                     QRegularExpression::MultilineOption);
    if (read(statementPage).contains(heading)) return statementPage + QLatin1Char('#') + headingAnchor(word);
    if (!findWord(word.toStdString())) return {};
    // What is said of a word stands where the words of its kind are.
    for (const char* page : {"povray/operators.md", "povray/patterns.md", "povray/primitives.md",
                             "povray/noise.md", "language.md"})
        if (explains(read(QLatin1String(page)), word)) return QLatin1String(page);
    return {};
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gallery/gallery_sources.h"

#include <algorithm>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>

#include "widgets/functions/function_snippet.h"
#include "widgets/help/help_library.h"
#include "widgets/help/help_markdown.h"

namespace isoscope {
namespace {

/// Snippets have some hundred characters.
constexpr qint64 largestSnippet = 64 * 1024;

/// "05_Isosurface_cristal" as "Isosurface cristal", "6a_Iso_f_helix1" as "Iso f_helix1".
QString titleOf(const QString& baseName) {
    static const QRegularExpression number(QStringLiteral("^[0-9][0-9a-z]*_"));
    QString title = baseName;
    title.remove(number).replace(QLatin1Char('_'), QLatin1Char(' '));
    return title.replace(QLatin1String(" f "), QLatin1String(" f_"));
}

QString completed(const QString& snippet) {
    return QStringLiteral(
               "#version 3.7;\n#include \"colors.inc\"\n#include \"textures.inc\"\n"
               "#include \"functions.inc\"\n"
               "global_settings { assumed_gamma 1 }\nbackground { rgb <0.16, 0.18, 0.21> }\n"
               "camera { location <2, 3, -6> right x*image_width/image_height angle 35 look_at <0, 1, 0> }\n"
               "light_source { <-500, 1000, -1000> rgb 1 }\n\n") +
           snippet;
}

QString read(const QString& path) {
    QFile file(path);
    if (file.size() > largestSnippet || !file.open(QIODevice::ReadOnly)) return {};
    return QString::fromUtf8(file.readAll());
}

}  // namespace

QList<GalleryEntry> functionEntries() {
    QList<GalleryEntry> entries;
    for (const Builtin& builtin : builtins()) {
        if (builtin.name.empty()) continue;
        const bool pattern = builtin.id < 0;
        entries.append({pattern ? GalleryEntry::Kind::pattern : GalleryEntry::Kind::function,
                        QString::fromStdString(builtin.name),
                        QString::fromStdString(builtin.formula),
                        QString::fromStdString(thumbnailScene(builtin)),
                        &builtin,
                        {}});
    }
    std::ranges::stable_sort(entries, [](const GalleryEntry& a, const GalleryEntry& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.title < b.title;
    });
    return entries;
}

QList<GalleryEntry> lessonEntries() {
    HelpLibrary::registerPages();
    QList<GalleryEntry> entries;
    const QString folder = QStringLiteral("help/lessons/");
    const QDir lessons(QStringLiteral(":/docs/") + folder);
    for (const QString& name : lessons.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        const QString page = read(lessons.filePath(name));
        QString heading = page.section(QLatin1Char('\n'), 0, 0);
        heading.remove(QRegularExpression(QStringLiteral("^#+\\s*")));
        for (const HelpScene& scene :
             preparedPage(page, folder + name, [](const QString&) { return false; }).scenes) {
            GalleryEntry entry;
            entry.kind = GalleryEntry::Kind::lesson;
            entry.title = heading;
            entry.sentence = scene.title;
            entry.text = scene.text;
            entry.asPovray = scene.asPovray;
            entry.composed = scene.composed;
            entries.append(entry);
        }
    }
    return entries;
}

QString firstComment(const QString& text) {
    static const QRegularExpression around(QStringLiteral("^[\\s/*]+|[\\s/*-]+$"));
    const QString start = text.trimmed();
    if (!start.startsWith(QLatin1String("//")) && !start.startsWith(QLatin1String("/*"))) return {};
    for (QString line : start.split(QLatin1Char('\n'))) {
        if (!line.remove(around).isEmpty()) return line;
    }
    return {};
}

QStringList povrayTemplateFolders() {
    QStringList found;
    QStringList roots = QStandardPaths::standardLocations(QStandardPaths::GenericDataLocation);
    for (const QString& root : roots) {
        QStringList scenes{root + QStringLiteral("/doc/povray/examples")};
        const QDir data(root);
        for (const QString& version : data.entryList({QStringLiteral("povray*")}, QDir::Dirs))
            scenes << data.filePath(version) + QStringLiteral("/scenes");
        for (const QString& folder : scenes)
            if (QDir templates(folder + QStringLiteral("/templates")); templates.exists())
                found << templates.canonicalPath();
    }
    found.removeDuplicates();
    return found;
}

QList<GalleryEntry> povrayEntries(const QStringList& templateFolders) {
    QList<GalleryEntry> entries;
    QSet<QString> known;
    for (const QString& folder : templateFolders) {
        const QDir templates(folder);
        for (const QString& group : templates.entryList({QStringLiteral("Isosurface*")}, QDir::Dirs)) {
            const QDir snippets(templates.filePath(group));
            for (const QFileInfo& info : snippets.entryInfoList({QStringLiteral("*.txt")}, QDir::Files)) {
                const QString text = read(info.filePath());
                // Some only explain the syntax, or are a part of another.
                if (!text.trimmed().startsWith(QLatin1String("isosurface")) || known.contains(text)) continue;
                known << text;
                entries.append(
                    {GalleryEntry::Kind::povray,
                     titleOf(info.completeBaseName()),
                     QCoreApplication::translate("Gallery", "POV-Ray's snippet: %1").arg(titleOf(group)),
                     completed(text),
                     nullptr,
                     {}});
            }
        }
    }
    return entries;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_markdown.h"

#include <QRegularExpression>
#include <QStringList>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>
#include <QUrl>

namespace isoscope {
namespace {

const QString fence = QStringLiteral("```");

HelpScene sceneOf(const QStringList& lines, const QString& word) {
    static const QRegularExpression around(QStringLiteral("^/+\\s*|\\.\\s*$"));
    HelpScene scene;
    scene.text = lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
    scene.title =
        lines.value(0).startsWith(QLatin1String("//")) ? QString(lines[0]).remove(around) : QString();
    scene.asPovray = word == QLatin1String("as-povray");
    scene.composed = word != QLatin1String("fit");
    return scene;
}

/// Text without fences, whose links are kept where they lead to a page.
QString withPageLinks(const QString& text, const QString& address,
                      const std::function<bool(const QString&)>& isPage) {
    static const QRegularExpression link(QStringLiteral("(!?)\\[([^\\]]*)\\]\\(([^()\\s]+)\\)"));
    static const QRegularExpression scheme(QStringLiteral("^[a-z]+:"));
    QString result;
    qsizetype done = 0;
    for (auto found = link.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        result += text.mid(done, match.capturedStart() - done);
        done = match.capturedEnd();
        const QString target = match.captured(3);
        const QString page = resolvedAddress(address, target);
        if (scheme.match(target).hasMatch())
            result += match.captured();
        else if (isPage(page.section(QLatin1Char('#'), 0, 0)))
            result += QStringLiteral("[%1](/%2)").arg(match.captured(2), page);
        else
            result += match.captured(2);
    }
    return result + text.mid(done);
}

QColor blended(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int from, int to) { return static_cast<int>(from + share * (to - from)); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

void dressCode(QTextBlock block, const QColor& ground) {
    constexpr double inset = 8;
    const auto isCode = [](const QTextBlock& one) {
        return one.isValid() && one.blockFormat().nonBreakableLines();
    };
    QTextBlockFormat format;
    format.setBackground(ground);
    format.setLeftMargin(inset);
    // The text of a scene may be wider than the panel.
    format.setNonBreakableLines(false);
    format.setTopMargin(block.previous().blockFormat().background() == QBrush(ground) ? 0 : inset);
    format.setBottomMargin(isCode(block.next()) ? 0 : inset);
    QTextCursor(block).mergeBlockFormat(format);
}

void dressTables(QTextFrame* frame, const QColor& line) {
    for (QTextFrame* child : frame->childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(child)) {
            constexpr double padding = 4, gap = 8;
            QTextTableFormat format = table->format();
            format.setBorderCollapse(true);
            format.setBorder(1);
            format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            format.setBorderBrush(line);
            format.setCellPadding(padding);
            format.setTopMargin(gap);
            format.setBottomMargin(gap);
            table->setFormat(format);
        }
        dressTables(child, line);
    }
}

/// Anchors of a heading's block, colours of the links in any.
void dressText(const QTextBlock& block, const QPalette& palette) {
    QTextCursor cursor(block);
    std::vector<std::pair<int, int>> links;
    for (auto it = block.begin(); !it.atEnd(); ++it)
        if (it.fragment().charFormat().isAnchor())
            links.emplace_back(it.fragment().position(), it.fragment().length());
    QTextCharFormat colour;
    colour.setForeground(palette.link());
    for (const auto& [begin, length] : links) {
        cursor.setPosition(begin);
        cursor.setPosition(begin + length, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(colour);
    }
    if (block.blockFormat().headingLevel() == 0 || block.length() < 2) return;
    QTextCharFormat anchor;
    anchor.setAnchor(true);
    anchor.setAnchorNames({headingAnchor(block.text())});
    cursor.setPosition(block.position());
    cursor.setPosition(block.position() + 1, QTextCursor::KeepAnchor);
    cursor.mergeCharFormat(anchor);
}

}  // namespace

QString resolvedAddress(const QString& from, const QString& link) {
    const QUrl base(QStringLiteral("/") + from);
    return base.resolved(QUrl(link)).toString().mid(1);
}

QString headingAnchor(const QString& heading) {
    static const QRegularExpression dropped(QStringLiteral("[^\\w\\- ]"),
                                            QRegularExpression::UseUnicodePropertiesOption);
    return heading.trimmed().toLower().remove(dropped).replace(QLatin1Char(' '), QLatin1Char('-'));
}

PreparedPage preparedPage(const QString& text, const QString& address,
                          const std::function<bool(const QString&)>& isPage) {
    PreparedPage page;
    QStringList plain, fenced;
    QString language;
    bool inside = false;
    const auto flush = [&] {
        page.markdown += withPageLinks(plain.join(QLatin1Char('\n')), address, isPage) + QLatin1Char('\n');
        plain.clear();
    };
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (!line.startsWith(fence)) {
            (inside ? fenced : plain) << line;
            continue;
        }
        inside = !inside;
        if (inside) {
            flush();
            language = line.mid(fence.size()).trimmed();
            fenced.clear();
            continue;
        }
        if (language == QLatin1String("mermaid")) continue;
        const QStringList words = language.split(QLatin1Char(' '));
        if (words.first() == QLatin1String("pov")) {
            page.markdown +=
                QStringLiteral("\n**[▶ Open this scene](scene:%1)**\n\n").arg(page.scenes.size());
            page.scenes.push_back(sceneOf(fenced, words.value(1)));
        }
        page.markdown += fence + QLatin1Char('\n') + fenced.join(QLatin1Char('\n')) + QLatin1Char('\n') +
                         fence + QLatin1Char('\n');
    }
    flush();
    return page;
}

void dressDocument(QTextDocument* document, const QPalette& palette) {
    const QColor ground = blended(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.07);
    const QColor line = blended(palette.color(QPalette::Base), palette.color(QPalette::Text), 0.3);
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        dressText(block, palette);
        if (block.blockFormat().nonBreakableLines()) dressCode(block, ground);
    }
    dressTables(document->rootFrame(), line);
}

}  // namespace isoscope

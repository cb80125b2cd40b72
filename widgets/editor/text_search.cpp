// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/text_search.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace isoscope {
namespace {

int utf8Length(QStringView text) {
    int length = 0;
    for (const QChar c : text) {
        // The halves of a pair are two bytes each, four together.
        if (c.unicode() < 0x80)
            length += 1;
        else if (c.unicode() < 0x800 || c.isSurrogate())
            length += 2;
        else
            length += 3;
    }
    return length;
}

QString filledIn(const QString& replacement, const QRegularExpressionMatch& match) {
    QString result;
    for (qsizetype i = 0; i < replacement.size(); ++i) {
        const QChar c = replacement[i];
        if (c != '\\' || i + 1 == replacement.size()) {
            result += c;
            continue;
        }
        const QChar code = replacement[++i];
        if (code >= '0' && code <= '9')
            result += match.captured(code.unicode() - '0');
        else if (code == 'n')
            result += '\n';
        else if (code == 't')
            result += '\t';
        else
            result += code;
    }
    return result;
}

QRegularExpression expressionFor(const SearchRequest& request) {
    QString pattern = request.regular ? request.pattern : QRegularExpression::escape(request.pattern);
    // Not \b: it would never match beside "#declare" or "}".
    if (request.wholeWord) pattern = "(?<!\\w)(?:" + pattern + ")(?!\\w)";
    QRegularExpression::PatternOptions options =
        QRegularExpression::MultilineOption | QRegularExpression::UseUnicodePropertiesOption;
    if (!request.caseSensitive) options |= QRegularExpression::CaseInsensitiveOption;
    return QRegularExpression(pattern, options);
}

}  // namespace

SearchResult searchText(const std::string& text, const SearchRequest& request) {
    SearchResult result;
    if (request.pattern.isEmpty()) return result;
    const QRegularExpression expression = expressionFor(request);
    if (!expression.isValid()) {
        result.error = expression.errorString();
        return result;
    }
    const QString subject = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    const QStringView view(subject);
    qsizetype characters = 0;
    int bytes = 0;
    // The subject was decoded from UTF-8 and is valid; checking it again for every match costs seconds in
    // long texts.
    for (qsizetype from = 0; from <= subject.size();) {
        const QRegularExpressionMatch match =
            expression.match(subject, from, QRegularExpression::NormalMatch,
                             QRegularExpression::DontCheckSubjectStringMatchOption);
        if (!match.isValid()) {
            result.error = QCoreApplication::translate("isoscope::FindBar", "expression is too complex");
            return result;
        }
        if (!match.hasMatch()) break;
        if (match.capturedLength() == 0) {
            from = match.capturedEnd() + 1;
            continue;
        }
        if (result.matches.size() == searchLimit) {
            result.cutOff = true;
            break;
        }
        SearchMatch found;
        found.begin = bytes + utf8Length(view.sliced(characters, match.capturedStart() - characters));
        found.end = found.begin + utf8Length(match.capturedView());
        found.replacement = request.regular ? filledIn(request.replacement, match) : request.replacement;
        characters = match.capturedEnd();
        bytes = found.end;
        result.matches.push_back(std::move(found));
        from = characters;
    }
    return result;
}

}  // namespace isoscope

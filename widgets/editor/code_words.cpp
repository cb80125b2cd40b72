// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/code_words.h"

#include <algorithm>
#include <cmath>

#include "core/text/diagnostic.h"
#include "widgets/interface_style.h"

namespace isoscope {
namespace {

// Of Unicode's private use: they stand in no text that a person wrote to be read.
constexpr QChar codeBegins(0xe000), codeEnds(0xe001);

}  // namespace

QString withQuotedCode(const std::string& message) {
    return QString::fromStdString(withCodeWords(message, "“", "”"));
}

QString withQuotedCode(const QString& message) { return withQuotedCode(message.toStdString()); }

QString withCodeAsHtml(const std::string& message) {
    const QString escaped = QString::fromStdString(message).toHtmlEscaped();
    return QString::fromStdString(withCodeWords(escaped.toStdString(), "<code>", "</code>"));
}

CodeLayout::CodeLayout(const QString& message, const QFont& font, int width) {
    const QString marked = QString::fromStdString(withCodeWords(
        message.toStdString(), QString(codeBegins).toStdString(), QString(codeEnds).toStdString()));
    QString text;
    QList<QTextLayout::FormatRange> formats;
    QTextCharFormat code;
    QFont fixed = fixedFont();
    fixed.setPointSizeF(font.pointSizeF() > 0 ? font.pointSizeF() : fixed.pointSizeF());
    fixed.setBold(font.bold());
    code.setFont(fixed);
    for (const QChar c : marked) {
        if (c == codeBegins)
            formats.push_back({static_cast<int>(text.size()), 0, code});
        else if (c == codeEnds && !formats.empty())
            formats.back().length = static_cast<int>(text.size()) - formats.back().start;
        else
            text += c;
    }
    layout.setText(text);
    layout.setFont(font);
    layout.setFormats(formats);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    qreal y = 0;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(std::max(width, 1));
        line.setPosition({0, y});
        y += line.height();
    }
    layout.endLayout();
    height = text.isEmpty() ? 0 : static_cast<int>(std::ceil(y));
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QString>
#include <QTextLayout>
#include <string>

namespace isoscope {

// Messages of the parser have words of the scene's language between backticks. What a person sees has them in
// the font of code, or in quotation marks where there is one font only.

/// “function” for `function`.
QString withQuotedCode(const std::string& message);
QString withQuotedCode(const QString& message);

/// Rich text; everything else is escaped.
QString withCodeAsHtml(const std::string& message);

/// `message` laid out in lines of at most `width`, its code in the fixed font; the layout begins at (0, 0).
struct CodeLayout {
    CodeLayout(const QString& message, const QFont& font, int width);

    QTextLayout layout;
    int height = 0;
};

}  // namespace isoscope

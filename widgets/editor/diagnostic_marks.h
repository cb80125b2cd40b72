// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "core/text/diagnostic.h"
#include "widgets/look.h"

class QsciScintilla;

namespace isoscope {

/// Squiggles under the text, symbols in margin 1, and the sentences for tooltips. Marks move with the text
/// they are about.
class DiagnosticMarks {
  public:
    explicit DiagnosticMarks(QsciScintilla* editor);

    static constexpr int margin = 1;

    /// Replaces all marks. A diagnostic of an include is marked at the statement of file 0 that led there;
    /// notes get no symbol.
    void set(const Diagnostics& diagnostics, const SourceLibrary& sources);
    /// Sets the colours of squiggles and symbols, present and future.
    void applyTheme(Look look);

    /// What there is to say about the byte at `position`, or about a line; rich text, empty for nothing.
    QString textAt(long position) const;
    QString textOfLine(int line) const;

    /// Scintilla's numbers of the squiggle, and of the symbol, for a severity.
    static int indicator(Severity severity) { return firstIndicator + static_cast<int>(severity); }
    static int marker(Severity severity) { return static_cast<int>(severity); }

  private:
    static constexpr int firstIndicator = 8;  // 0 to 7 belong to lexers
    static constexpr int severities = 4;

    struct Mark {
        QString text;
        int markerHandle = -1;
    };

    void clear();
    void underline(long begin, long end, Severity severity, int number);

    QsciScintilla* editor_;
    std::vector<Mark> marks_;
};

/// The message and its hint as rich text for a tooltip.
QString toolTipText(const Diagnostic& diagnostic);

}  // namespace isoscope

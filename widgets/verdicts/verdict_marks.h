// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/study/gradient/gradient_verdict.h"
#include "widgets/look.h"

class QsciScintilla;

namespace isoscope {

/// Signs of verdicts in the symbol margin of the editor, beside the lines that they are about. They move with
/// their lines.
class VerdictMarks {
  public:
    /// The verdict that is shown beside one line; empty while it is unknown.
    struct Mark {
        int line = 0;  ///< from 0
        std::optional<GradientVerdict> verdict;
        QString text;  ///< rich text for the tooltip

        bool operator==(const Mark&) const = default;
    };

    explicit VerdictMarks(QsciScintilla* editor);

    /// Of several for a line the worst is shown, and all are told. Signs that stand there already stay, since
    /// the editor paints the whole margin anew for one.
    void set(const std::vector<Mark>& marks);
    /// Draws the signs for this theme, at the editor's ratio of device to logical pixels.
    void applyTheme(Look look);
    /// What there is to say about a line; empty for nothing.
    QString textOfLine(int line) const;
    /// The verdict whose sign stands beside a line.
    bool marked(int line) const { return !textOfLine(line).isEmpty(); }

    /// Scintilla's number of the sign; a worse verdict has a larger one.
    static int marker(std::optional<GradientVerdict> verdict);
    /// Of all verdicts, for the margin's mask.
    static int mask();

  private:
    struct Placed {
        Mark mark;
        int handle = -1;
    };

    /// Whether these are the marks of the last set(), and their signs stand where they were put.
    bool stand(const std::vector<Mark>& marks) const;

    QsciScintilla* editor_;
    std::vector<Mark> given_;  ///< to the last set()
    std::vector<Placed> marks_;
};

}  // namespace isoscope

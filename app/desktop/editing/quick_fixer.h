// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QObject>
#include <string_view>
#include <vector>

#include "core/language/parse.h"

namespace isoscope {

class SceneEditor;
class SceneSession;

/// Makes the changes that Problems offers.
class QuickFixer : public QObject {
    Q_OBJECT
  public:
    QuickFixer(SceneEditor* editor, SceneSession* session, QObject* parent);

    /// One undo step. The places are those of the last parse of a text that was then the editor's; when the
    /// text has changed since, they are followed, and what was itself changed is left alone. Of two that
    /// overlap the first counts.
    void apply(std::vector<QuickFix> fixes);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    SceneEditor* editor_;
    std::shared_ptr<const ParseResult> shown_;  ///< what the places belong to
};

/// Where `range` of the text `before` stands in `after`, if what changed between the two lies beside it.
std::optional<SourceRange> followed(const SourceRange& range, std::string_view before,
                                    std::string_view after);

}  // namespace isoscope

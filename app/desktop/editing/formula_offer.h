// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <string>

#include "core/language/parse.h"
#include "core/study/view/formula_isosurface.h"
#include "widgets/latest_worker.h"

namespace isoscope {

class NoticeBar;
class QuickFixer;
class SceneEditor;
class SceneSession;

/// Offers to make an isosurface of a formula that stands alone in the text: with camera and lights where
/// there is nothing else.
class FormulaOffer : public QObject {
    Q_OBJECT
  public:
    /// What the offer reads and asks; it owns none of them.
    struct Parts {
        SceneEditor* editor;
        SceneSession* session;
        NoticeBar* notices;
        QuickFixer* fixer;
    };
    FormulaOffer(const Parts& parts, QObject* parent);

  private:
    void consider(const std::shared_ptr<const ParseResult>& result);
    void offer(const QuickFix& fix);
    void withdraw();

    Parts parts_;
    std::string considered_;  ///< the text whose formula was looked at last
    QString shown_;           ///< the notice, while it stands
    LatestWorker worker_;     // last: its tasks refer to the rest
};

}  // namespace isoscope

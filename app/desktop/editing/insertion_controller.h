// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>

#include "widgets/functions/function_insertion.h"
#include "widgets/latest_worker.h"

namespace isoscope {

class SceneEditor;
class SceneSession;
class ViewController;

/// Brings functions of the list into the text, where they are seen. A whole statement is planned in the
/// background, from the text as it was read; should the text change meanwhile, it is planned again.
class InsertionController : public QObject {
    Q_OBJECT
  public:
    InsertionController(SceneEditor* editor, SceneSession* session, ViewController* views, QObject* parent);
    ~InsertionController() override;

    /// Writes a statement outside of all others, with what the text lacks to show it, once the text is read;
    /// then fits the view unless a camera was written. A VirtuaLight text is left alone, with said().
    void insertStatement(const Builtin* builtin);
    /// Writes a call, and the include it needs, in the place of the selection at once; VirtuaLight as above.
    void insertCall(const Builtin* builtin);
    /// Shows the next text that is parsed whole, whatever camera it has.
    void fitNext() { fits_ = true; }
    /// Nothing is under way.
    bool idle() const { return !waiting_ && !fits_; }

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    bool understood();
    void plan();
    void apply(const FunctionInsertion& insertion);

    SceneEditor* editor_;
    SceneSession* session_;
    ViewController* views_;
    const Builtin* waiting_ = nullptr;  ///< the function whose statement is under way
    bool fits_ = false;                 ///< the view is fitted once the text is read
    LatestWorker worker_;               // last: its tasks refer to the others
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <QTimer>

#include "widgets/document/history_store.h"
#include "widgets/editor/edit_journal.h"

namespace isoscope {

class Document;
class SceneEditor;

/// Keeps the undo history of text, sliders and view on disk, a moment after each step, so that a text that
/// comes back, after the end of the program or a crash, comes back with what led to it.
class HistoryKeeper : public QObject {
    Q_OBJECT
  public:
    /// Both outlive the keeper.
    HistoryKeeper(SceneEditor* editor, const Document* document, QObject* parent);

    /// The steps that lead to `text`, which has become, or is about to become, that of the document.
    std::optional<EditJournal> past(const QString& text) const;
    /// Writes now what waits.
    void write();

    /// From a step to its writing, in milliseconds.
    static constexpr int pause = 1000;

  private:
    QString name() const;

    SceneEditor* editor_;
    const Document* document_;
    HistoryStore store_;
    QString untitled_;  ///< what a document without a file is called
    QTimer timer_;
    bool waiting_ = false;  ///< for write()
};

}  // namespace isoscope

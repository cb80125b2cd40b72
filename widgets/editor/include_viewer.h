// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QFrame>

#include "core/text/source_text.h"

class QLabel;
class QsciScintilla;

namespace isoscope {

class SceneLexer;

/// An include file to read, beside the text that includes it: opened at a place that a problem names. Hidden
/// until then; Escape and its button close it.
class IncludeViewer : public QFrame {
    Q_OBJECT
  public:
    explicit IncludeViewer(QWidget* parent = nullptr);
    ~IncludeViewer() override;

    /// Shows the text that `range` lies in and selects the range; nothing happens for one outside `sources`.
    void show(const SourceLibrary& sources, const SourceRange& range);
    using QFrame::show;
    /// The name of the file shown.
    QString fileName() const;
    QString selectedText() const;

  signals:
    /// The user has closed it.
    void closed();

  protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void applyTheme();
    void leave();

    QLabel* name_;
    QsciScintilla* text_;
    std::unique_ptr<SceneLexer> lexer_;
};

}  // namespace isoscope

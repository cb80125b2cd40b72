// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QString>
#include <QTimer>
#include <set>
#include <string>

#include "core/language/directives/written_files.h"
#include "core/language/parse.h"

namespace isoscope {

class Document;
class NoticeBar;
class SceneEditor;
class SceneSession;

/// What `#write` of the text puts into files: offered above the text, and written beside the scene once the
/// user has allowed it, and again when it changes. Leave is given for a name, until the document is closed,
/// and never asked for while the name is being typed. A file that stands there and is none that this scene
/// wrote has a question of its own, and so has one that would grow with each reading; the scene's own file is
/// never written.
class FileWriter : public QObject {
    Q_OBJECT
  public:
    /// What is read and where leave is asked for; the writer owns none of them.
    struct Parts {
        SceneEditor* editor;
        SceneSession* session;
        Document* document;
        NoticeBar* notices;
    };
    FileWriter(const Parts& parts, QObject* parent);

    /// Another document: nothing is allowed yet.
    void begin();

    /// A name that was typed has stood for so long, in milliseconds, before it is asked about.
    static constexpr int settlingTime = 1000;

  signals:
    /// Files were written; for the status line.
    void said(const QString& message);

  private:
    using Names = std::set<std::string>;
    enum class Question { write, replace, add, saveFirst };

    void consider(const std::shared_ptr<const ParseResult>& result);
    void settle();
    void askAll();
    void ask(Question question, const Names& names);
    void askAbout(const QString& text, const QString& topic, const QString& label, const QString& toolTip,
                  const Names& names);
    void withdraw(const Names& topics);
    /// Writes these names of the present text.
    void write(const Names& names, const Names& replaceable);
    std::string scene() const;
    /// Those that differ from what is there.
    WrittenFiles changed() const;
    bool grows(const std::string& name, const std::string& content) const;
    bool caretInString() const;

    Parts parts_;
    WrittenRecord record_;
    std::shared_ptr<const ParseResult> result_;  ///< the latest without mistakes
    Names allowed_;
    Names declined_;
    Names settled_;
    Names topics_;         ///< of the notices that may be standing
    bool untyped_ = true;  ///< all names are those of the file that was opened
    QTimer settling_;
};

}  // namespace isoscope

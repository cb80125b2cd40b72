// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <QObject>
#include <QStringList>
#include <string>

#include "core/language/parse.h"

namespace isoscope {

class Document;
class NoticeBar;
class SceneEditor;
class SceneSession;

/// What `#write` of the text puts into files: offered above the text, and written beside the scene once the
/// user has allowed it, and again when it changes. The permission ends with the document. Files that would
/// grow are asked about each time, and the scene's own file is never written.
class FileWriter : public QObject {
    Q_OBJECT
  public:
    struct Parts {
        SceneEditor* editor;
        SceneSession* session;
        Document* document;
        NoticeBar* notices;
    };
    FileWriter(const Parts& parts, QObject* parent);

    /// Another document: nothing is allowed yet.
    void begin();

  signals:
    void said(const QString& message);

  private:
    using Files = std::map<std::string, std::string>;

    void consider(const std::shared_ptr<const ParseResult>& result);
    void ask(const Files& files);
    void write(const Files& files);
    std::string folder() const;
    /// Those that differ from what is there.
    Files changed(const Files& files) const;

    Parts parts_;
    bool allowed_ = false;
    /// The names asked about last, so that each change of the text does not ask again.
    QStringList asked_;
    QStringList refused_;  ///< those told of last, for the same reason
};

}  // namespace isoscope

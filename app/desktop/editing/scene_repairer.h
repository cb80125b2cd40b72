// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <QObject>
#include <string>
#include <vector>

#include "core/language/parse.h"

namespace isoscope {

class NoticeBar;
class SceneEditor;
class SceneSession;
class SettingWriter;

/// Writes proven values of max_gradient back where the statements stand: into the text, as one undo step, and
/// into include files in the folder of the scene, which a notice offers to put back.
class SceneRepairer : public QObject {
    Q_OBJECT
  public:
    /// What the repairer works with; it owns none of them.
    struct Parts {
        SceneEditor* editor;
        SceneSession* session;
        SettingWriter* settings;
        NoticeBar* notices;
    };
    SceneRepairer(const Parts& parts, QObject* parent);

    /// Values by the numbers of isosurfaces of the text as it was read last; nothing is changed while the
    /// text is newer.
    void repair(const std::map<std::size_t, double>& values);

  signals:
    /// For the status line.
    void said(const QString& message);

  private:
    /// A file as it was, and as it is now.
    struct Written {
        std::string file, before, after;
    };

    std::vector<Written> writeIncludes(const ParseResult& parsed,
                                       const std::map<std::size_t, double>& values);
    void offerBack(const std::vector<Written>& written);
    void putBack(const std::vector<Written>& written);
    void readAgain();

    Parts parts_;
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QTimer>
#include <string>

#include "core/language/parse.h"
#include "widgets/latest_worker.h"

namespace isoscope {

/// From text to scene, in the background: texts are parsed by a worker thread, the newest one only, and the
/// last scene without errors is kept while the text has some, unless nothing is in it; of a text that never
/// was without errors, what was understood is shown. Sliders with a slot in the parameter table change the
/// scene at once, without a parse. Everything is called and signalled in the thread of the object.
class SceneSession : public QObject {
    Q_OBJECT
  public:
    enum class When { afterPause, now };
    enum class Shown {
        complete,  ///< the scene is that of the text
        partial,   ///< the text has errors; the scene is what was understood of it
        older,     ///< the text has errors; the scene is that of the last text without
        nothing,   ///< the text has errors, and there is no scene
    };

    explicit SceneSession(QObject* parent = nullptr);
    ~SceneSession() override;

    /// A new document: the next parse is shown even with errors, and nothing of the old one remains. `file`
    /// is where includes are searched beside; may be empty.
    void begin(const std::string& file);
    /// The file got another name; the text is the same.
    void setFile(const std::string& file);
    void setLibraryPaths(std::vector<std::filesystem::path> paths);

    /// `revision` is any number that tells texts apart; it comes back with the result.
    void setText(std::string text, quint64 revision, When when);
    /// A slider moved: slot `slot` of the scene that came from `owner` gets `value`, without a parse. False,
    /// and nothing happens, when another result is shown by now or there is no such slot.
    bool setParameter(const ParseResult* owner, int slot, double value);
    /// The text after setParameter(), which says the same as the scene: its parse can wait and changes
    /// nothing but places.
    void followParameter(std::string text, quint64 revision);

    /// What is to be shown; null before the first parse.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    /// The latest result; null before the first parse.
    const std::shared_ptr<const ParseResult>& result() const { return result_; }
    quint64 resultRevision() const { return resultRevision_; }
    /// A text waits to be parsed or is being parsed.
    bool busy() const { return timer_.isActive() || submitted_ != answered_; }

  signals:
    /// A text was parsed; `revision` is the one handed in with it.
    void parsed(const std::shared_ptr<const isoscope::ParseResult>& result, quint64 revision);
    /// Another scene is to be shown. `sameLook`: only its places in the text are new.
    void sceneChanged(const std::shared_ptr<const isoscope::Scene>& scene, bool sameLook);
    /// What the scene at hand has to do with the latest text.
    void shownChanged(isoscope::SceneSession::Shown shown);

  private:
    void parseNow();
    Shown shownOf(const std::shared_ptr<const ParseResult>& result) const;
    void receive(std::shared_ptr<const ParseResult> result, quint64 revision, std::uint64_t number,
                 std::uint64_t look);
    void show(std::shared_ptr<const ParseResult> result, std::uint64_t look);

    ParseOptions options_;
    QTimer timer_;
    std::string text_;
    quint64 revision_ = 0;
    /// Texts of the same look differ only by sliders that the scene at hand has followed.
    std::uint64_t look_ = 0;
    std::uint64_t shownLook_ = 0;
    std::uint64_t submitted_ = 0;
    std::uint64_t answered_ = 0;
    std::uint64_t firstOfDocument_ = 1;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const ParseResult> shown_;  ///< where scene_ comes from
    std::shared_ptr<const ParseResult> result_;
    quint64 resultRevision_ = 0;
    LatestWorker worker_;  // last: its tasks refer to the session
};

}  // namespace isoscope

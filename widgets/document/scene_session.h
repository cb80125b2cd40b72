// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/language/parse.h"
#include "widgets/latest_worker.h"

namespace isoscope {

/// From text to scene, in the background: texts are parsed by a worker thread, the newest one only, and the
/// last scene without errors is kept while the text has some, unless nothing is in it; of a text that never
/// was without errors, what was understood is shown. Sliders with a slot in the parameter table change the
/// scene at once, without a parse. A text that takes longer than timing::progressDelay tells how far it is,
/// can be stopped, and gives way to a newer one. Everything is called and signalled in the thread of the
/// object.
class SceneSession : public QObject {
    Q_OBJECT
  public:
    /// When a text is parsed: once no other has followed for a moment, or at once.
    enum class When { afterPause, now };
    /// How the scene that is shown relates to the latest text.
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
    /// As begin() or setFile() had it.
    const std::filesystem::path& file() const { return options_.file; }
    void setLibraryPaths(std::vector<std::filesystem::path> paths);

    /// `revision` is any number that tells texts apart; it comes back with the result.
    void setText(std::string text, quint64 revision, When when);
    /// A slider moved: slot `slot` of the scene that came from `owner` gets `value`, without a parse. False,
    /// and nothing happens, when another result is shown by now or there is no such slot.
    bool setParameter(const ParseResult* owner, int slot, double value) {
        return setParameters(owner, {{slot, value}});
    }
    /// The same for several slots at once, all or none.
    bool setParameters(const ParseResult* owner, const std::vector<std::pair<int, double>>& values);
    /// The text after setParameter(), which says the same as the scene: its parse can wait and changes
    /// nothing but places.
    void followParameter(std::string text, quint64 revision);

    /// The moment of an animation that later parses are for: `clock`, `frame_number` and the numbers of the
    /// first and the last frame. A new document has none.
    struct Moment {
        double clock = 0;
        int frame = 0;
        int first = 0;
        int last = 0;
    };
    /// Changes nothing that is read already.
    void setMoment(const std::optional<Moment>& moment);

    /// Ends the parse that runs, within milliseconds: its result has the error `stopped`.
    void stop();

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

    /// The latest text is taking long: it has been worked on for so many seconds and took so many steps, and
    /// what is read now stands behind `share` (0 to 1) of the text. Comes again and again until it is parsed.
    void readingSlowly(double seconds, qulonglong steps, double share);
    /// Behind readingSlowly(): nothing takes long any more.
    void readingEnded();

  private:
    /// A text in the hands of the worker.
    struct Reading {
        std::uint64_t number = 0;
        std::stop_source stop;
        std::shared_ptr<ParseProgress> progress = std::make_shared<ParseProgress>();
        QElapsedTimer since;
        std::size_t length = 0;
    };

    void parseNow();
    void followReadings();
    /// Whether `number` was stopped in favour of a newer text. Forgets it and those before it.
    bool endReading(std::uint64_t number);
    Shown shownOf(const std::shared_ptr<const ParseResult>& result) const;
    void receive(std::shared_ptr<const ParseResult> result, quint64 revision, std::uint64_t number,
                 std::uint64_t look);
    void show(std::shared_ptr<const ParseResult> result, std::uint64_t look);

    ParseOptions options_;
    QTimer timer_;
    QTimer readingTimer_;
    std::vector<std::shared_ptr<Reading>> readings_;  ///< by their numbers; those not answered yet
    bool slow_ = false;                               ///< readingSlowly() waits for its readingEnded()
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

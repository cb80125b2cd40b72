// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <QObject>
#include <QSize>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/scene/scene.h"
#include "core/study/gradient/gradient_proofs.h"
#include "core/study/gradient/surface_verdict.h"

namespace isoscope {

/// What every max_gradient of the text is worth, found out in the background by a thread that gives way to
/// all others: first a quick look at each isosurface, then the pixels that the view loses, then the proofs to
/// their ends. Proofs are kept, so that each is made once; only pixels are counted anew for another view.
class VerdictStudy : public QObject {
    Q_OBJECT
  public:
    explicit VerdictStudy(QObject* parent = nullptr);
    ~VerdictStudy() override;

    /// Null for none.
    void setScene(std::shared_ptr<const Scene> scene);
    /// The view that pixels are counted in.
    void setView(const Camera& camera, QSize size);
    /// The isosurface that somebody looks at: it comes first, from the next scene or view on.
    void setChosen(std::size_t isosurface) { chosen_ = isosurface; }
    /// While held, nothing is worked on: a proof ends with the box at hand and goes on there afterwards, and
    /// a view is counted again.
    void setHeld(bool held);
    /// Ends the work on the present scene, views included; what is known stays.
    void stop();
    /// Goes on with it.
    void goOn();
    bool stopped() const { return stopped_; }

    /// Of the isosurfaces that have a max_gradient; those of the scene before until something is known.
    const std::vector<SurfaceVerdict>& verdicts() const { return verdicts_; }
    /// What verdicts() is about.
    const std::shared_ptr<const Scene>& judged() const { return judged_; }
    /// Of one isosurface of judged(); null when there is none.
    const SurfaceVerdict* verdictOf(std::size_t isosurface) const;
    /// The present scene and view are not completely judged.
    bool busy() const { return busy_; }

    /// The proofs of all scenes so far, for others to share; never null, usable from any thread.
    const std::shared_ptr<GradientProofs>& proofs() const { return proofs_; }
    /// Slices of proofs begun so far, and views counted: what tests look at instead of the clock.
    std::uint64_t slices() const { return slices_.load(); }
    std::uint64_t views() const { return views_.load(); }

  signals:
    /// More is known, or nothing any more.
    void changed();

  private:
    struct Job {
        std::uint64_t generation = 0;
        std::shared_ptr<const Scene> scene;
        Camera camera;
        QSize size;
        std::size_t chosen = 0;
    };
    /// A job in the making.
    struct Work;

    void submit();
    void receive(std::uint64_t generation, const std::shared_ptr<const Scene>& scene,
                 std::vector<SurfaceVerdict> verdicts, bool finished);

    // In the worker's thread.
    void run(std::stop_token stop);
    void judge(Work& work);
    void adoptProofs(Work& work);
    void prove(Work& work, std::uint64_t boxesEach);
    void countPixels(Work& work);
    void tell(Work& work, bool finished = false);
    /// False when it is time to stop.
    bool mayGoOn(const Work& work);
    /// What stops when the study is held from now on; nothing if it is held already.
    std::optional<std::stop_token> beginUnheld();
    /// Runs `trace` until it has not been interrupted by setHeld().
    template <typename Result, typename Trace>
    Result uninterrupted(Work& work, const Trace& trace);

    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize size_{160, 120};
    std::size_t chosen_ = 0;
    std::vector<SurfaceVerdict> verdicts_;
    std::shared_ptr<const Scene> judged_;
    bool busy_ = false;
    bool stopped_ = false;  ///< by the user, until another scene comes
    std::uint64_t generation_ = 0;

    std::shared_ptr<GradientProofs> proofs_ =
        std::make_shared<GradientProofs>(GradientStudySettings{.threads = 0});
    std::vector<std::shared_ptr<GradientProof>> lastProofs_;  ///< of the job before
    std::atomic<std::uint64_t> slices_{0};
    std::atomic<std::uint64_t> views_{0};

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Job> waiting_;
    bool held_ = false;
    std::stop_source jobStop_;   ///< of the job at hand
    std::stop_source holdStop_;  ///< of what a hold interrupts
    std::jthread thread_;        // last: it uses the others
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>
#include <stop_token>
#include <vector>

#include "core/study/accuracy/cost_survey.h"
#include "widgets/latest_worker.h"
#include "widgets/studies/cost_plot.h"

namespace isoscope {

class CostStrip;
class ParameterPanel;
class ParameterSlider;

/// Fills the strips under the sliders of accuracy and max_gradient, one after the other, while all rests: in
/// one thread of the lowest priority, which stops at once when something moves. What was measured is kept
/// while the isosurfaces are the same but for the setting, and shown again when an earlier view comes back.
class CostSurveyor : public QObject {
    Q_OBJECT
  public:
    explicit CostSurveyor(ParameterPanel* panel, QObject* parent = nullptr);
    ~CostSurveyor() override;

    /// What the sliders belong to; null for none.
    void setScene(std::shared_ptr<const Scene> scene);
    void setView(const Camera& camera);
    /// The size that times are told for.
    void setPictureSize(QSize size);

    /// The text was read again, and its sliders may be others: each strip shows what is known of it, or that
    /// the scene has nothing it belongs to.
    void judgeStrips();
    /// Nothing moves any more: strips that are not fresh are measured, those on the screen first.
    void rest();
    /// Something moves: nothing is measured until rest().
    void stop();
    bool surveying() const { return surveying_; }
    /// Values measured since the program began.
    quint64 measuredValues() const { return measured_; }

  private:
    /// What a measurement is for.
    struct Subject {
        std::shared_ptr<const Scene> scene;
        Camera camera;
        QSize picture;
        std::size_t isosurface = 0;
        StudiedSetting setting = StudiedSetting::accuracy;
        double low = 0, high = 0;  ///< of the slider
    };
    struct Known {
        Subject subject;
        CostPlot plot;
    };

    std::optional<Subject> subjectOf(const ParameterSlider& slider) const;
    static bool same(const Subject& a, const Subject& b);
    const CostPlot* recall(const Subject& subject) const;
    void next();
    void start(CostStrip* strip, const Subject& subject);
    void receive(const CostPlot& plot, quint64 generation);

    ParameterPanel* panel_;
    std::shared_ptr<const Scene> scene_;
    Camera camera_;
    QSize picture_{800, 600};
    std::vector<Known> known_;  ///< the newest last
    QPointer<CostStrip> strip_;
    Subject subject_;
    std::stop_source stop_;
    quint64 generation_ = 0;
    quint64 measured_ = 0;
    bool resting_ = false;
    bool surveying_ = false;
    LatestWorker worker_;  // last: its tasks refer to the surveyor
};

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>
#include <stop_token>
#include <vector>

#include "core/study/range/scene_ranges.h"
#include "widgets/latest_worker.h"

namespace isoscope {

class ParameterPanel;
class ParameterSlider;

/// Shades the sliders of a panel where there is a surface: works while all rests and the panel is seen, in
/// one thread of the lowest priority, which stops at once when something moves. What was found is kept while
/// all else of the function is the same.
class RangeSurveyor : public QObject {
    Q_OBJECT
  public:
    explicit RangeSurveyor(ParameterPanel* panel, QObject* parent = nullptr);
    ~RangeSurveyor() override;

    /// What the sliders belong to; null for none.
    void setScene(std::shared_ptr<const Scene> scene);
    /// Nothing moves any more: ranges that are not known are searched.
    void rest();
    /// Something moves: nothing is searched until rest().
    void stop();
    bool surveying() const { return surveying_; }

  private:
    /// What is asked about one isosurface.
    struct Question {
        RangeSubject subject;
        std::shared_ptr<const Isosurface> shape;
        std::vector<double> others;  ///< the parameters, with 0 for the one that varies
        double low = 0, high = 0;    ///< of the slider
    };
    /// What is asked about one slider.
    struct Job {
        QPointer<ParameterSlider> slider;
        std::vector<Question> questions;
    };
    struct Known {
        std::vector<Question> questions;
        ParameterRange range;
    };

    static bool same(const Question& a, const Question& b);
    std::vector<Job> jobs() const;
    const ParameterRange* recall(const Job& job) const;
    void receive(const Job& job, const ParameterRange& range, quint64 generation);

    ParameterPanel* panel_;
    std::shared_ptr<const Scene> scene_;
    std::vector<Known> known_;  ///< the newest last
    std::stop_source stop_;
    quint64 generation_ = 0;
    bool surveying_ = false;
    LatestWorker worker_;  // last: its tasks refer to the surveyor
};

}  // namespace isoscope

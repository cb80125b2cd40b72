// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <QObject>
#include <QTimer>
#include <stop_token>

#include "core/study/accuracy/picture_time.h"
#include "widgets/latest_worker.h"

namespace isoscope {

/// How long a picture will take here and in POV-Ray, found in the background while its size is chosen.
class PictureForecast : public QObject {
    Q_OBJECT
  public:
    explicit PictureForecast(QObject* parent = nullptr);
    ~PictureForecast() override;

    /// Forgets what is known and begins once nothing has changed for a moment. Without a scene: nothing.
    void follow(const RenderRequest& request);
    /// Ends the work; what is known stays.
    void stop();

    /// No squares before the first report.
    const PictureTime& own() const { return own_; }
    /// Processor seconds; nothing while it is not known, and for a scene without isosurfaces.
    const std::optional<double>& povray() const { return povray_; }
    bool upToDate() const { return !pending_; }
    /// One line about both.
    QString text() const;

  signals:
    /// More is known than before, or nothing any more.
    void changed();

  private:
    void begin();

    RenderRequest request_;
    PictureTime own_;
    std::optional<double> povray_;
    QTimer pause_;
    std::stop_source stop_;
    std::uint64_t generation_ = 0;
    bool pending_ = false;
    LatestWorker worker_;  // last: its tasks refer to the forecast
};

}  // namespace isoscope

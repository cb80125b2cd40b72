// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/timeline_row.h"

#include <algorithm>
#include <QCoreApplication>
#include <QStringList>

#include "core/animation/camera_pose.h"
#include "widgets/numbers/number_text.h"

namespace isoscope {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(TimelineRow)
};

}  // namespace

std::set<int> TimelineRow::frames(const Timeline& timeline) const {
    std::set<int> found;
    for (const std::string& name : tracks)
        if (const KeyTrack* track = timeline.track(name))
            for (const Key& key : track->keys) found.insert(key.frame);
    return found;
}

bool TimelineRow::hasKey(const Timeline& timeline, int frame) const {
    return frames(timeline).contains(frame);
}

QString TimelineRow::told(const Timeline& timeline, int frame) const {
    QStringList lines;
    for (const std::string& name : tracks) {
        const KeyTrack* track = timeline.track(name);
        const Key* key = track ? track->at(frame) : nullptr;
        if (!key) continue;
        QString line = Texts::tr("%1 = %2 at frame %3")
                           .arg(QString::fromStdString(name), numberText(key->value), QString::number(frame));
        if (key != &track->keys.back())
            line += Texts::tr(", then %1").arg(easingTitle(key->easing).toLower());
        lines << line;
    }
    return lines.join('\n');
}

Easing TimelineRow::easing(const Timeline& timeline, int frame) const {
    for (const std::string& name : tracks)
        if (const KeyTrack* track = timeline.track(name))
            if (const Key* key = track->at(frame)) return key->easing;
    return Easing::smooth;
}

std::vector<TimelineRow> timelineRows(const Timeline& timeline, const std::vector<std::string>& missing) {
    std::vector<TimelineRow> rows;
    TimelineRow camera{Texts::tr("Camera"), {}, false};
    for (const KeyTrack& track : timeline.tracks) {
        if (isCameraTrack(track.name)) {
            camera.tracks.push_back(track.name);
            continue;
        }
        const bool gone = std::find(missing.begin(), missing.end(), track.name) != missing.end();
        rows.push_back({QString::fromStdString(track.name), {track.name}, gone});
    }
    if (!camera.tracks.empty()) rows.push_back(std::move(camera));
    return rows;
}

QString easingTitle(Easing easing) {
    switch (easing) {
        case Easing::smooth: return Texts::tr("Smooth");
        case Easing::linear: return Texts::tr("Even");
        case Easing::slowStart: return Texts::tr("Slow start");
        case Easing::slowEnd: return Texts::tr("Slow end");
        case Easing::curve: return Texts::tr("Curve through the keys");
        case Easing::hold: return Texts::tr("Hold, then jump");
    }
    return {};
}

}  // namespace isoscope

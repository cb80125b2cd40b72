// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/editing/preview_light.h"

#include <algorithm>

#include "widgets/document/scene_session.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/notice_bar.h"

namespace isoscope {

static const QString lightTopic = QStringLiteral("light");

namespace {

constexpr double grey = 0.8;

bool hasBlackObjects(const ParseResult& result) {
    return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                       [](const Diagnostic& one) { return one.id == "no-pigment"; });
}

}  // namespace

PreviewLight::PreviewLight(SceneEditor* editor, SceneSession* session, NoticeBar* notices, QObject* parent)
    : QObject(parent),
      session_(session),
      notices_(notices),
      notice_(tr("An object has no pigment: POV-Ray shows it black.")) {
    connect(session, &SceneSession::parsed, this, [this, editor](const auto& result, quint64 revision) {
        if (revision == editor->revision()) consider(*result);
    });
}

void PreviewLight::begin() {
    asked_ = on_ = false;
    notices_->withdraw(lightTopic);
}

void PreviewLight::consider(const ParseResult& result) {
    // While something is wrong, that comes first.
    const bool black = hasBlackObjects(result) && result.ok();
    if (!black) {
        notices_->withdraw(lightTopic);
        return;
    }
    if (asked_ || notices_->isVisible()) return;
    asked_ = true;
    notices_->ask(notice_,
                  {{tr("Light It in the Preview"),
                    tr("Show it in grey here; the text, exports and POV-Ray's picture stay black"),
                    [this] {
                        on_ = true;
                        emit changed();
                    }},
                   {tr("Leave It Black"), tr("Problems offers to add a pigment"), {}}},
                  lightTopic);
}

std::shared_ptr<const Scene> PreviewLight::shown(const std::shared_ptr<const Scene>& scene) const {
    // The first material is that of objects which have none: SceneBuilder adds it before all others.
    if (!on_ || !scene || scene->materials.empty()) return scene;
    const auto* plain = std::get_if<SolidPigment>(&scene->materials.front().pigment);
    if (!plain || !session_->result() || !hasBlackObjects(*session_->result())) return scene;
    auto lit = std::make_shared<Scene>(*scene);
    lit->materials.front().pigment = SolidPigment{Color{grey, grey, grey, 0, 0}, {}};
    return lit;
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/view_controller.h"

#include <QAction>
#include <QShortcut>

#include "app/desktop/window/actions.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

ViewController::ViewController(Actions* actions, Viewport* viewport, QObject* parent)
    : QObject(parent), viewport_(viewport) {
    // The letter alone counts only where nothing can be typed.
    auto* letter = new QShortcut(Qt::Key_F, viewport);
    letter->setContext(Qt::WidgetShortcut);
    connect(letter, &QShortcut::activated, this, &ViewController::fit);
    connect(actions->fitView, &QAction::triggered, this, &ViewController::fit);
    connect(actions->frontView, &QAction::triggered, this, [this] { show(StandardView::front); });
    connect(actions->topView, &QAction::triggered, this, [this] { show(StandardView::top); });
    connect(actions->sideView, &QAction::triggered, this, [this] { show(StandardView::side); });
}

ViewController::~ViewController() = default;

void ViewController::fit() { fitTo(viewport_->camera()); }

void ViewController::followText() { fitTo(viewport_->camera(), Cause::text); }

void ViewController::show(StandardView view) { fitTo(turnedTo(viewport_->camera(), view)); }

void ViewController::fitTo(const Camera& turned, Cause cause) {
    const std::shared_ptr<const Scene> scene = viewport_->scene();
    if (!scene) return;
    const Camera present = viewport_->camera();
    const Camera seen = fittedCamera(turned, viewport_->width(), viewport_->height());
    ++running_;
    worker_.submit([=, this](const std::stop_token& stop) {
        SurfaceBounds surfaces(scene, {}, stop);
        const std::optional<Camera> fitted = fittedView(turned, seen, surfaces);
        QMetaObject::invokeMethod(this, [=, this] {
            running_ = 0;  // orders that this one replaced are not answered
            if (viewport_->scene() != scene || !(viewport_->camera() == present)) return;
            if (fitted) {
                if (cause == Cause::text) emit followsText();
                viewport_->showCamera(*fitted);
            } else
                emit said(tr("There is nothing to fit: what the scene shows is empty, or has no end."));
        });
    });
}

}  // namespace isoscope

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/whats_this.h"

#include <map>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHelpEvent>
#include <QMenu>
#include <QTextDocument>
#include <QWhatsThis>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "widgets/parameters/parameter_slider.h"

namespace isoscope {

namespace {

/// A tooltip as a sentence of its own, without its shortcut.
QString asSentence(QString text) {
    text = text.trimmed();
    if (text.isEmpty() || Qt::mightBeRichText(text)) return text;
    if (!text.endsWith('.') && !text.endsWith(')') && !text.endsWith('?')) text += '.';
    return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
}

/// Of the settings of an isosurface, by the names of their sliders.
QString settingText(const QString& name) {
    if (name == QLatin1String("threshold"))
        return WhatsThis::tr(
            "<p>The level at which the surface lies: it is where the function has this value, and the solid "
            "is "
            "where the function is smaller.</p><p><b>threshold</b> is 0 where the text says nothing.</p>");
    if (name == QLatin1String("accuracy"))
        return WhatsThis::tr(
            "<p>How closely the place of the surface is found. Smaller is finer and takes longer; sheets "
            "thinner than this may be missed.</p><p>POV-Ray ends its search along a ray when the interval is "
            "shorter than <b>accuracy</b>.</p>");
    if (name == QLatin1String("max_gradient"))
        return WhatsThis::tr(
            "<p>How steep POV-Ray takes the function to be. Too low leaves holes in its picture, too high "
            "makes "
            "it slow; the badge in the status line tells which, with proof.</p><p>The gradient of the "
            "function "
            "must nowhere in the container be longer than <b>max_gradient</b>.</p>");
    return {};
}

}  // namespace

WhatsThis::WhatsThis(const Actions& actions, const Docks& docks, QWidget* window)
    : QObject(window), window_(window) {
    const std::map<QAction*, QString> concepts{
        {actions.certified,
         tr("<p>Shows the surface as it is, without holes.</p><p>The certified root finder encloses the "
            "function along every ray and proves what it finds; it needs no max_gradient. Pixels that could "
            "not be proven are counted below the picture.</p>")},
        {actions.povray,
         tr("<p>Shows what POV-Ray will draw, holes included.</p><p>POV-Ray's root finder trusts "
            "max_gradient "
            "and accuracy of the text; where the function is steeper than max_gradient it may step over the "
            "surface.</p>")},
        {actions.verdicts,
         tr("<p>Marks the pixels that are not proven to be right; mostly there are none.</p><p>The certified "
            "root finder leaves a pixel unproven when a root closer than accuracy/100 may hide there, when "
            "the ray took too many evaluations, or when the function has no known bounds.</p>")},
        {actions.overlayHoles,
         tr("<p>Shows where POV-Ray's picture would have holes, over the exact picture.</p><p>Both root "
            "finders are run; pixels are lost, gained, or found at a wrong place.</p>")},
        {actions.overlaySplit, tr("<p>Shows both pictures side by side: POV-Ray's at the left, the exact one "
                                  "at the right. Drag the "
                                  "divider.</p>")},
        {actions.overlayDifference,
         tr("<p>Shows only what POV-Ray's picture gets wrong, without the picture itself.</p>")},
        {actions.overlayGradient,
         tr("<p>Colours the surface by how steep the function is there; red is too steep for POV-Ray.</p><p>"
            "The colour is the length of the gradient as a share of max_gradient.</p>")},
        {actions.overlayCost,
         tr("<p>Shows what each pixel takes in evaluations of the function, the brighter the more, in the "
            "colour of the cause: empty space in the container, a field that is steep elsewhere, rays along "
            "the surface, places where the function jumps.</p><p>It counts for the root finder of the "
            "picture, exact or as POV-Ray.</p>")},
        {actions.overlayPovray, tr("<p>Has the POV-Ray that is installed draw the text, in a folder of its "
                                   "own, and shows its picture left "
                                   "of a divider that can be dragged, the exact one right of it. It is drawn "
                                   "anew for every view that "
                                   "rests.</p>")},
        {actions.overlayPovrayDifference,
         tr("<p>Has the POV-Ray that is installed draw the text and marks each pixel that differs from the "
            "exact "
            "picture by its cause: holes, accuracy, jumps, outlines, and what is not shown here.</p>")},
        {actions.overlayCompare,
         tr("<p>Shows what you change beside what was.</p><p>The scene is kept as it is at this moment (A); "
            "from now on it is drawn left of the divider, and the present one (B) right of it: other values, "
            "or another function. Choose it again to keep the present scene instead.</p>")},
        {actions.overlayNone, tr("<p>Shows the picture alone, with nothing laid over it.</p>")},
        {actions.inspectRay,
         tr("<p>Click a pixel to see why it looks as it does: how the function runs along the line of sight, "
            "where the surface is met, and what POV-Ray stepped over.</p><p>The panel “Ray” charts the "
            "function over the distance along the <b>ray</b>.</p>")},
        {actions.sectionPlane, tr("<p>Shows where the object is cut, and lets you drag the cut.</p><p>The "
                                  "<b>cross-section</b> shows "
                                  "the values of the function on that plane.</p>")},
    };
    for (const auto& [action, text] : concepts) action->setWhatsThis(text);
    for (QAction* action : actions.all())
        if (action->whatsThis().isEmpty()) action->setWhatsThis(asSentence(action->statusTip()));
    for (const QDockWidget* dock : docks.all())
        dock->toggleViewAction()->setWhatsThis(asSentence(dock->toggleViewAction()->toolTip()) +
                                               dock->whatsThis());
    qApp->installEventFilter(this);
}

QString WhatsThis::textOf(const QWidget* widget) {
    QString around;
    for (; widget; widget = widget->parentWidget()) {
        if (const auto* slider = qobject_cast<const ParameterSlider*>(widget))
            if (const QString text = settingText(slider->name()); !text.isEmpty()) return text;
        if (!widget->whatsThis().isEmpty()) return around.isEmpty() ? widget->whatsThis() : around;
        if (around.isEmpty()) around = asSentence(widget->toolTip());
        if (widget->isWindow()) break;
    }
    return around;
}

bool WhatsThis::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::QueryWhatsThis && event->type() != QEvent::WhatsThis)
        return QObject::eventFilter(watched, event);
    const auto* widget = qobject_cast<QWidget*>(watched);
    // Menus tell of their actions themselves.
    const bool ours = widget && !qobject_cast<const QMenu*>(widget) && widget->whatsThis().isEmpty() &&
                      (widget == window_ || window_->isAncestorOf(widget));
    const QString text = ours ? textOf(widget) : QString();
    if (text.isEmpty()) return QObject::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::WhatsThis)
        QWhatsThis::showText(static_cast<QHelpEvent*>(event)->globalPos(), text);
    return true;
}

}  // namespace isoscope

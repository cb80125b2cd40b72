// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desktop/window/whats_this.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>

#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

bool takesInput(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QTabBar*>(widget) || qobject_cast<const QAbstractScrollArea*>(widget) ||
           qobject_cast<const Viewport*>(widget);
}

bool answersWhatsThis(QWidget* widget) {
    QHelpEvent query(QEvent::QueryWhatsThis, {1, 1}, widget->mapToGlobal(QPoint(1, 1)));
    QApplication::sendEvent(widget, &query);
    return query.isAccepted();
}

}  // namespace

class WhatsThisTest : public QObject {
    Q_OBJECT

  private slots:
    void D18_everyControlSaysWhatItIs() {
        WindowDriver d;
        QVERIFY(d.rests());
        int asked = 0;
        QStringList silent;
        for (QDockWidget* dock : d->docks()->all()) {
            QVERIFY2(!dock->whatsThis().isEmpty(), qPrintable(dock->objectName()));
            dock->raise();
            QCoreApplication::processEvents();
            for (QWidget* widget : d.window().findChildren<QWidget*>()) {
                if (!widget->isVisible() || !takesInput(widget)) continue;
                ++asked;
                if (!answersWhatsThis(widget) || WhatsThis::textOf(widget).isEmpty())
                    silent << QStringLiteral("%1 “%2” in %3")
                                  .arg(widget->metaObject()->className(), widget->accessibleName(),
                                       widget->parentWidget()->metaObject()->className());
            }
        }
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join('\n')));
        QVERIFY(asked > 300);
    }

    void D18_everyCommandSaysWhatItDoes() {
        WindowDriver d;
        for (QAction* action : d->actions()->all())
            QVERIFY2(action->whatsThis().size() > 10, qPrintable(action->text()));
        QVERIFY(d->actions()->certified->whatsThis().contains(QStringLiteral("without holes")));
        QVERIFY(d->actions()->povray->whatsThis().contains(QStringLiteral("max_gradient")));
    }

    void D18_theConceptsHaveTextsOfTheirOwn() {
        WindowDriver d;
        QVERIFY(d.rests());
        for (const char* name : {"threshold", "accuracy", "max_gradient"}) {
            const int i = d.parameter(QLatin1String(name));
            QVERIFY2(i >= 0, name);
            auto* slider = d->parameters()->slider(i)->findChild<QSlider*>();
            QVERIFY2(WhatsThis::textOf(slider).contains(QStringLiteral("<b>%1</b>").arg(QLatin1String(name))),
                     name);
        }
    }
};

QTEST_MAIN(WhatsThisTest)
#include "whats_this_test.moc"

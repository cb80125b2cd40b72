// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>

#include "tests/widgets/gui_events.h"
#include "widgets/editor/find_bar.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/functions/function_browser.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/timeline/timeline_panel.h"
#include "widgets/verdicts/problems_panel.h"

using namespace isoscope;

namespace {

/// A control of our own: not a part of another one.
bool isControl(const QWidget* widget) {
    if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget)) return false;
    const QWidget* parent = widget->parentWidget();
    if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QLineEdit*>(parent)) return false;
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QsciScintilla*>(widget);
}

QList<QWidget*> controls(QWidget* root) {
    QList<QWidget*> found;
    for (QWidget* widget : root->findChildren<QWidget*>() + QList<QWidget*>{root})
        if (isControl(widget)) found << widget;
    return found;
}

QString nameOf(const QWidget* widget) {
    return QString("%1 \"%2\" in %3")
        .arg(widget->metaObject()->className(), widget->accessibleName(),
             widget->parentWidget() ? widget->parentWidget()->metaObject()->className() : "nothing");
}

}  // namespace

/// Walks every widget of the editor's side: each control must say what it is, to the mouse and to assistive
/// programs, and be reachable without a mouse.
class AccessibilityTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SceneEditor> editor_;
    std::vector<std::unique_ptr<QWidget>> widgets_;

  private slots:
    void initTestCase() {
        editor_ = std::make_unique<SceneEditor>();
        auto find = std::make_unique<FindBar>(editor_.get());
        find->showReplace();
        auto parameters = std::make_unique<ParameterPanel>();
        SceneParameter number, expression;
        number.name = "R";
        number.group = "#declare";
        expression = number;
        expression.name = "S";
        expression.expression = true;
        expression.text = "2*R";
        parameters->setParameters({number, expression});
        auto problems = std::make_unique<ProblemsPanel>();
        problems->setDiagnostics({{Severity::error, "e", {}, "message", "hint", {}}}, {});
        widgets_.push_back(std::move(find));
        widgets_.push_back(std::move(parameters));
        widgets_.push_back(std::move(problems));
        widgets_.push_back(std::make_unique<FunctionBrowser>());
        widgets_.push_back(std::make_unique<TimelinePanel>());
        for (const auto& widget : widgets_) widget->show();
        editor_->show();
    }
    void cleanupTestCase() {
        widgets_.clear();
        editor_.reset();
    }

    void everyControlHasANameAndAToolTip() {
        int count = 0;
        QList<QWidget*> all = controls(editor_.get());
        for (const auto& widget : widgets_) all += controls(widget.get());
        for (const QWidget* control : all) {
            QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(nameOf(control)));
            QVERIFY2(!control->toolTip().isEmpty(), qPrintable(nameOf(control)));
            ++count;
        }
        QVERIFY2(count >= 20, qPrintable(QString::number(count)));
    }

    void everyControlIsReachedByTheKeyboard() {
        for (const auto& widget : widgets_)
            for (const QWidget* control : controls(widget.get()))
                QVERIFY2(control->focusPolicy() & Qt::TabFocus, qPrintable(nameOf(control)));
    }

    void tabLeavesEveryControl() {
        for (const auto& widget : widgets_) {
            QVERIFY(test::showActive(widget.get()));
            QSet<QWidget*> seen;
            for (int i = 0; i < 40; ++i) {
                QTest::keyClick(widget->focusWidget() ? widget->focusWidget() : widget.get(), Qt::Key_Tab);
                seen << widget->focusWidget();
            }
            for (QWidget* control : controls(widget.get()))
                if (control->isVisible() && control->isEnabled())
                    QVERIFY2(seen.contains(control), qPrintable(nameOf(control)));
        }
    }

    void noEmojiInTexts() {
        for (const auto& widget : widgets_)
            for (const QWidget* control : controls(widget.get()))
                for (const QString& text : {control->toolTip(), control->accessibleName()})
                    for (const QChar c : text) QVERIFY2(c.unicode() < 0x2000, qPrintable(nameOf(control)));
    }
};

QTEST_MAIN(AccessibilityTest)
#include "accessibility_test.moc"

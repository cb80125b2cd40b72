// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameter_panel.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "tests/widgets/gui_events.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_group.h"
#include "widgets/parameters/parameter_slider.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

SceneParameter make(const char* group, const char* name, double value, SourceRange range = {}) {
    SceneParameter parameter;
    parameter.role = ParameterRole::argument;
    parameter.group = group;
    parameter.name = name;
    parameter.value = value;
    parameter.minimum = 0;
    parameter.maximum = 2;
    parameter.range = range;
    return parameter;
}

std::vector<SceneParameter> twoTori() {
    std::vector<SceneParameter> parameters{
        make("f_torus", "Major Radius", 0.8), make("f_torus", "Minor Radius", 0.2),
        make("f_torus", "Major Radius", 0.5), make("f_torus", "Minor Radius", 0.1), make("#declare", "R", 1)};
    parameters[0].statement = parameters[1].statement = 1;
    parameters[2].statement = parameters[3].statement = 2;
    return parameters;
}

}  // namespace

class ParameterPanelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ParameterPanel> panel_;

    QSlider* slider(int index) const { return panel_->slider(index)->findChild<QSlider*>(); }
    QStringList titles() const {
        QMap<int, QString> byPlace;
        for (auto* group : panel_->findChildren<ParameterGroup*>())
            if (group->isVisible()) byPlace[group->y()] = group->findChild<QToolButton*>()->text();
        return byPlace.values();
    }

  private slots:
    void init() {
        panel_ = std::make_unique<ParameterPanel>();
        panel_->resize(320, 700);
        QVERIFY(showActive(panel_.get()));
    }
    void cleanup() { panel_.reset(); }

    void groupsByCall() {
        SourceLibrary sources;
        sources.add("scene.pov", "\n\n\n");
        auto parameters = twoTori();
        parameters[2].range = parameters[3].range = {0, 2, 3};
        panel_->setParameters(parameters, &sources);
        QCoreApplication::processEvents();
        QCOMPARE(panel_->count(), 5);
        QCOMPARE(titles(), (QStringList{"f_torus (1), line 1", "f_torus (2), line 3", "#declare, line 1"}));
    }

    /// Not that of its first number, which may stand far below.
    void theLineIsThatWhereTheStatementBegins() {
        const std::string text =
            "// an isosurface\nmy_isosurface {}\nisosurface {\n  function { x }\n  threshold 0.5\n}\n";
        SourceLibrary sources;
        sources.add("scene.pov", text);
        SceneParameter threshold;
        threshold.role = ParameterRole::threshold;
        threshold.name = "threshold";
        threshold.group = "isosurface";
        const auto begin = static_cast<std::uint32_t>(text.find("0.5"));
        threshold.range = {0, begin, begin + 3};
        panel_->setParameters({threshold}, &sources);
        QCoreApplication::processEvents();
        QCOMPARE(titles(), QStringList{"isosurface, line 3"});
    }

    void signalsCarryTheIndex() {
        panel_->setParameters(twoTori());
        QSignalSpy changed(panel_.get(), &ParameterPanel::valueChanged),
            started(panel_.get(), &ParameterPanel::dragStarted),
            finished(panel_.get(), &ParameterPanel::dragFinished);
        dragSlider(slider(2), 30);
        QCOMPARE(started.count(), 1);
        QCOMPARE(started[0][0].toInt(), 2);
        QCOMPARE(finished[0][0].toInt(), 2);
        QVERIFY(changed.count() > 5);
        QCOMPARE(changed.last()[0].toInt(), 2);
        QCOMPARE(changed.last()[1].toDouble(), panel_->slider(2)->value());
    }

    void newValuesKeepWidgetsAndFocus() {
        panel_->setParameters(twoTori());
        const auto* before = panel_->slider(1);
        slider(1)->setFocus();
        auto parameters = twoTori();
        parameters[1].value = 0.3;
        panel_->setParameters(parameters);
        QCOMPARE(panel_->slider(1), before);
        QVERIFY(slider(1)->hasFocus());
        QCOMPARE(panel_->slider(1)->value(), 0.3);
    }

    void rowsThatStayKeepFocusWhenOthersComeAndGo() {
        panel_->setParameters(twoTori());
        const auto* before = panel_->slider(1);
        slider(1)->setFocus();
        std::vector<SceneParameter> parameters{make("isosurface", "threshold", 0),
                                               make("f_torus", "Major Radius", 0.8),
                                               make("f_torus", "Minor Radius", 0.2)};
        panel_->setParameters(parameters);
        QCOMPARE(panel_->slider(2), before);
        QVERIFY(slider(2)->hasFocus());
        QSignalSpy changed(panel_.get(), &ParameterPanel::valueChanged);
        QTest::keyClick(slider(2), Qt::Key_Right);
        QCOMPARE(changed[0][0].toInt(), 2);
    }

    void aDragSurvivesAParse() {
        panel_->setParameters(twoTori());
        QSignalSpy finished(panel_.get(), &ParameterPanel::dragFinished);
        dragSlider(slider(0), 20, 10, false);
        const double dragged = panel_->slider(0)->value();
        panel_->setParameters(twoTori());
        QVERIFY(panel_->slider(0)->isDragging());
        QCOMPARE(panel_->slider(0)->value(), dragged);
        QTest::mouseRelease(slider(0), Qt::LeftButton, {}, handleCenter(slider(0)));
        QCOMPARE(finished.count(), 1);
    }

    void aDragOfARowThatGoesIsFinished() {
        panel_->setParameters(twoTori());
        QSignalSpy finished(panel_.get(), &ParameterPanel::dragFinished);
        dragSlider(slider(4), 20, 10, false);
        panel_->setParameters({make("f_torus", "Major Radius", 0.8)});
        QCOMPARE(finished.count(), 1);
        QCOMPARE(panel_->count(), 1);
    }

    void filters() {
        panel_->setParameters(twoTori());
        auto* filter = panel_->findChild<QLineEdit*>();
        filter->setText("minor");
        QVERIFY(!panel_->slider(0)->isVisible());
        QVERIFY(panel_->slider(1)->isVisible());
        QVERIFY(panel_->slider(3)->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(titles(), (QStringList{"f_torus (1)", "f_torus (2)"}));
        filter->setText("torus MAJOR");
        QVERIFY(panel_->slider(0)->isVisible());
        filter->setText("nothing like it");
        QCOMPARE(titles(), QStringList());
        panel_->setParameters(twoTori());  // a parse keeps the filter
        QVERIFY(!panel_->slider(0)->isVisible());
        filter->clear();
        QVERIFY(panel_->slider(4)->isVisible());
    }

    void saysWhenThereIsNothing() {
        const auto message = [this] {
            for (QLabel* label : panel_->findChildren<QLabel*>())
                if (label->isVisible()) return label->text();
            return QString();
        };
        QVERIFY(message().startsWith("Nothing to move yet"));
        panel_->setParameters(twoTori());
        QVERIFY(!message().startsWith("Nothing"));
    }

    void expressionsAreReplacedOnDemand() {
        auto parameters = twoTori();
        parameters[1].expression = true;
        parameters[1].text = "0.1*2";
        panel_->setParameters(parameters);
        QSignalSpy asked(panel_.get(), &ParameterPanel::replaceExpressionRequested);
        panel_->slider(1)->findChild<QToolButton*>()->click();
        QCOMPARE(asked[0][0].toInt(), 1);
        panel_->setParameters(twoTori());
        QVERIFY(slider(1));
    }

    void thousandsOfNumbersCostNoTime() {
        std::vector<SceneParameter> many;
        for (int i = 0; i < 5000; ++i) many.push_back(make("#declare", qPrintable(QString("N%1").arg(i)), i));
        QElapsedTimer clock;
        clock.start();
        panel_->setParameters(many);
        qInfo("%lld ms", clock.elapsed());
        QCOMPARE(panel_->count(), static_cast<int>(ParameterPanel::rowLimit));
        QVERIFY(!panel_->slider(4000));
    }

    void noRowIsCutOffInANarrowDock() {
        auto parameters = twoTori();
        parameters[1].expression = true;
        parameters[1].text = "0.1*2 + sin(clock)*0.5 + some_long_name*another_long_name";
        panel_->setParameters(parameters);
        panel_->resize(10, 700);
        QCoreApplication::processEvents();
        for (int i = 0; i < panel_->count(); ++i) {
            const QWidget* row = panel_->slider(i);
            const QRect place(row->mapTo(panel_.get(), QPoint()), row->size());
            QVERIFY2(panel_->rect().contains(place), qPrintable(QString("row %1").arg(i)));
            QVERIFY(row->width() >= row->minimumSizeHint().width());
        }
    }

    void badIndexesDoNoHarm() {
        panel_->setValue(3, 1);
        QVERIFY(!panel_->slider(-1));
        QCOMPARE(panel_->textFor(99, 0.35), QString("0.35"));
    }

    /// Slider and text together, as the window wires them: the text follows the drag, one undo takes it back.
    void aDragRewritesTheTextAsOneStep() {
        SceneEditor editor;
        const QString text = QString::fromUtf8("// \xf0\x9f\x98\x80\nf_torus(x, y, z, 0.8, 0.2)\n");
        editor.setSceneText(text);
        const auto at = static_cast<std::uint32_t>(editor.utf8().find("0.8"));
        panel_->setParameters({make("f_torus", "Major Radius", 0.8, {0, at, at + 3})});
        editor.markNumbers({{0, at, at + 3}});
        connect(panel_.get(), &ParameterPanel::dragStarted, &editor, [&] { editor.beginDrag(); });
        connect(panel_.get(), &ParameterPanel::dragFinished, &editor, [&] { editor.endDrag(); });
        connect(panel_.get(), &ParameterPanel::valueChanged, &editor, [&](int index, double value) {
            QVERIFY(editor.replaceNumber(index, panel_->textFor(index, value)));
        });
        dragSlider(slider(0), 50);
        const QString number = panel_->textFor(0, panel_->slider(0)->value());
        QVERIFY(number != "0.8");
        QCOMPARE(editor.sceneText(), QString(text).replace("0.8", number));
        editor.undo();
        QCOMPARE(editor.sceneText(), text);
        QVERIFY(!editor.isUndoAvailable());
    }
};

QTEST_MAIN(ParameterPanelTest)
#include "parameter_panel_test.moc"

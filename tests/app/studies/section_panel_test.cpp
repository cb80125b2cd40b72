// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/section_panel.h"

#include <cmath>
#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>

#include "app/desktop/files/document_controller.h"
#include "app/desktop/studies/study_controller.h"
#include "app/desktop/window/actions.h"
#include "app/desktop/window/docks.h"
#include "core/language/parse.h"
#include "core/text/csv_table.h"
#include "tests/app/window_driver.h"
#include "widgets/charts/chart_view.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/linked_probe.h"
#include "widgets/section/section_profile.h"
#include "widgets/section/section_view.h"
#include "widgets/viewport/viewport.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// f says where it was taken: x + 10 y + 100 z.
const QString coordinates = QStringLiteral(
    "#version 3.7;\ncamera { location <3, 2, -6> look_at 0 angle 40 }\nlight_source { <4, 6, -5> rgb 1 }\n"
    "isosurface {\n  function { x + 10*y + 100*z }\n  contained_by { box { -1, 1 } }\n  max_gradient 101\n"
    "  pigment { rgb 0.9 }\n}\n");

bool shows(WindowDriver& d, const QString& text) {
    d->editor()->setSceneText(text);
    d->docks()->find("section")->raise();
    return d.rests(60000);
}

void press(WindowDriver& d, const QString& name) {
    for (auto* button : d->study<SectionPanel>()->findChildren<QAbstractButton*>())
        if (button->accessibleName() == name) return button->click();
    QFAIL(qPrintable(name));
}

void dragIn(QWidget* widget, QPointF from, QPointF to) {
    QTest::mousePress(widget, Qt::LeftButton, {}, from.toPoint());
    for (int i = 1; i <= 8; ++i) {
        QTest::mouseMove(widget, (from + (to - from) * i / 8).toPoint());
        QTest::qWait(2);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, {}, to.toPoint());
}

float expected(const SectionField& field, int column, int row) {
    const glm::dvec3 p =
        field.plane.at(field.left + (field.right - field.left) * column / (field.columns - 1),
                       field.bottom + (field.top - field.bottom) * row / (field.rows - 1));
    return static_cast<float>(p.x + 10 * p.y + 100 * p.z);
}

}  // namespace

/// The cross-section with planes of any direction and a line, in the real window.
class SectionPanelTest : public QObject {
    Q_OBJECT

  private slots:
    /// A bug once: a slider between the walls of a container stood beside the sentence that there is none.
    void controlsWithoutASurfaceAreNotSeen() {
        WindowDriver d;
        d->resize(1280, 800);
        const auto seen = [&] {
            QStringList names;
            for (const QWidget* control : d->study<SectionPanel>()->findChildren<QWidget*>())
                if (control->isVisible() && control->focusPolicy() != Qt::NoFocus &&
                    !control->accessibleName().isEmpty() && control->parentWidget() != nullptr &&
                    !qobject_cast<const SectionView*>(control))
                    names << control->accessibleName();
            return names;
        };
        QVERIFY(shows(d, coordinates));
        const QStringList all = seen();
        QVERIFY2(all.contains(QStringLiteral("Position of the plane")), qPrintable(all.join(", ")));
        d->documents()->newDocument();
        QVERIFY(shows(d, QStringLiteral("sphere { 0, 1 pigment { rgb 1 } } isosurface { function { }\n")));
        QTRY_VERIFY2(seen().isEmpty(), qPrintable(seen().join(", ")));
        const auto sentence = [&] {
            for (const QLabel* label : d->study<SectionPanel>()->findChildren<QLabel*>())
                if (label->text() == QStringLiteral("The scene has no isosurface to cut.")) return label;
            return static_cast<const QLabel*>(nullptr);
        };
        QTRY_VERIFY(sentence());
        QTRY_VERIFY(sentence()->width() > 200 && !sentence()->visibleRegion().isEmpty());
        // The chart was a white field beside the sentence.
        const auto isWindow = [&] {
            SectionView* view = d->study<SectionPanel>()->view();
            const QImage seen = view->grab().toImage();
            const QRgb window = view->palette().color(QPalette::Window).rgb();
            for (int y = 0; y < seen.height(); ++y)
                for (int x = 0; x < seen.width(); ++x)
                    if (seen.pixelColor(x, y).rgb() != window) return false;
            return true;
        };
        QTRY_VERIFY(isWindow());
        QVERIFY(shows(d, coordinates));
        QTRY_COMPARE(seen(), all);
    }

    /// D37: a wide pane gives its height to the section, a slim one its width.
    void theSectionUsesTheRoomItHas() {
        QScrollArea pane;  // as in the window
        pane.setFrameShape(QFrame::NoFrame);
        pane.setWidgetResizable(true);
        auto* panel = new SectionPanel;
        pane.setWidget(panel);
        pane.resize(820, 150);
        pane.show();
        QTRY_COMPARE(panel->height(), 150);
        QVERIFY2(panel->view()->height() >= 130, qPrintable(QString::number(panel->view()->height())));
        QVERIFY(panel->view()->width() >= 400);
        // Whatever the line of text says and however many surfaces there are to choose from.
        const ParseResult parsed = parseScene(
            "isosurface { function { x } max_gradient 1 } isosurface { function { y } max_gradient 1 }");
        panel->setScene(parsed.scene);
        QTRY_COMPARE(panel->height(), 150);
        QVERIFY2(panel->view()->height() >= 130, qPrintable(QString::number(panel->view()->height())));
        pane.resize(400, 600);
        QTRY_VERIFY2(panel->view()->width() >= 380, qPrintable(QString::number(panel->view()->width())));
        QVERIFY(panel->view()->height() >= 450);
    }

    /// D37: a section of 118 pixels had no number but 0.
    void smallSectionsHaveSeveralNumbers() {
        for (const double extent : {2.0, 2.2, 2.4, 3.2, 4.0, 5.8, 7.5, 12.0, 200.0, 0.0032})
            for (const double pixels : {90.0, 118.0, 150.0, 300.0, 900.0}) {
                const double step = SectionView::tickStep(extent, pixels);
                QVERIFY2(extent / step >= 2,
                         qPrintable(QString("%1 %2 %3").arg(extent).arg(pixels).arg(step)));
                QVERIFY(step / extent * pixels >= 24);
            }
    }

    void aFreePlaneBeginsWhereThePlaneWas() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        for (const int axis : {0, 1, 2}) {
            d->study<SectionPanel>()->setAxis(axis);
            d->study<SectionPanel>()->setPosition(0.5);
            QVERIFY(d.rests());
            const SectionField before = d->study<SectionPanel>()->view()->field();
            press(d, QStringLiteral("Free plane"));
            QVERIFY(d.rests());
            const SectionField& after = d->study<SectionPanel>()->view()->field();
            QVERIFY(after.plane.isFree());
            QCOMPARE(after.values.size(), before.values.size());
            for (std::size_t i = 0; i < before.values.size(); i += 101)
                QVERIFY(std::abs(after.values[i] - before.values[i]) < 1e-3);
            // The plane can be seen, for it wants to be dragged.
            QVERIFY(d->actions()->sectionPlane->isChecked());
            d->study<SectionPanel>()->setAxis(axis);
            QCOMPARE(d->study<SectionPanel>()->position(), 0.5);
        }
    }

    void aTurnedPlaneIsSampledWhereItSays() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        d->study<SectionPanel>()->turn(30, 20);
        d->study<SectionPanel>()->setPosition(0.3);
        QVERIFY(d.rests());
        const SectionField& field = d->study<SectionPanel>()->view()->field();
        QCOMPARE(field.plane.heading(), 30.0);
        QCOMPARE(field.plane.tilt(), 20.0);
        QVERIFY(std::max(field.columns, field.rows) == SectionPanel::fineResolution);
        for (const int column : {0, field.columns / 3, field.columns - 1})
            for (const int row : {0, field.rows / 2, field.rows - 1})
                QVERIFY(std::abs(field.values[static_cast<std::size_t>(row) * field.columns + column] -
                                 expected(field, column, row)) < 1e-3);
    }

    void thePlaneIsDraggedInThePicture() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        d->study<SectionPanel>()->setAxis(0);
        d->study<SectionPanel>()->setPosition(0);
        Viewport* viewport = d->viewport();
        WindowDriver::trigger(d->actions()->sectionPlane);
        QVERIFY(viewport->planeHandle().shown());
        const QPointF knob = *viewport->planeHandle().movePixel(viewport->projection());
        const Camera camera = viewport->camera();
        dragIn(viewport, knob, *viewport->projection().pixelOf({0.4, 0, 0}));
        QVERIFY2(std::abs(d->study<SectionPanel>()->position() - 0.4) < 0.06,
                 qPrintable(QString::number(d->study<SectionPanel>()->position())));
        QVERIFY(viewport->camera() == camera);  // it was the plane that moved
        const QPointF ball = *viewport->planeHandle().turnPixel(viewport->projection());
        dragIn(viewport, ball, ball + QPointF(0.03, -0.12) * viewport->height());
        QVERIFY(d->study<SectionPanel>()->plane().isFree());
        QVERIFY(d->study<SectionPanel>()->plane().tilt() > 5);
        QVERIFY(d.rests());
        QVERIFY(d->study<SectionPanel>()->view()->field().plane == d->study<SectionPanel>()->plane());
    }

    void theFunctionIsChartedAlongALine() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        d->study<SectionPanel>()->setAxis(2);
        d->study<SectionPanel>()->setPosition(0.02);
        SectionProfile* profile = d->study<SectionPanel>()->profile();
        QVERIFY(!profile->isVisible());
        press(d, QStringLiteral("Profile along a line"));
        QVERIFY(profile->isVisible());
        QVERIFY(d.rests());
        // The middle of the plane, from side to side, at first.
        const LineSamples& line = profile->samples();
        QCOMPARE(line.from.x, -1.0);
        QCOMPARE(line.to.x, 1.0);
        QVERIFY(std::abs(line.values.front() - 1) < 1e-9 && std::abs(line.values.back() - 3) < 1e-9);
        QVERIFY(std::abs(line.slopes[500] - std::sqrt(10101.0)) < 1e-9);
        // Drawn another one, upwards: f passes 0 where 10 y = -2 - x.
        SectionView* view = d->study<SectionPanel>()->view();
        QVERIFY(QTest::qWaitFor([&] { return view->settled(); }, 10000));
        dragIn(view, QPointF(view->width() * 0.4, view->height() * 0.85),
               QPointF(view->width() * 0.4, view->height() * 0.15));
        QVERIFY(d.rests());
        QVERIFY(line.from.y < 0 && line.to.y > 0 && std::abs(line.from.x - line.to.x) < 1e-6);
        const std::vector<double> crossings = line.crossings(5);
        QCOMPARE(crossings.size(), std::size_t(1));
        const glm::dvec3 zero = line.at(crossings[0]);
        QVERIFY(std::abs(zero.x + 10 * zero.y + 100 * zero.z) < 1e-9);
        QCOMPARE(profile->chart()->chart().marks.size(), 1);
        // A mere click leaves the line; moving the plane carries it along.
        const glm::dvec3 from = line.from;
        QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(view->width() * 6 / 10, view->height() / 2));
        QCOMPARE(line.from, from);
        d->study<SectionPanel>()->setPosition(0.5);
        QVERIFY(d.rests());
        QCOMPARE(line.from, glm::dvec3(from.x, from.y, 0.5));
        press(d, QStringLiteral("Profile along a line"));
        QVERIFY(!profile->isVisible());
    }

    /// Of x + 10 y + 100 z the gradient has the length sqrt(10101) everywhere.
    void theDistanceIsShownChartedAndTold() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        auto* panel = d->study<SectionPanel>();
        SectionView* view = panel->view();
        QVERIFY(!view->linesShown());
        panel->setQuantity(SectionQuantity::distance);
        QVERIFY(view->linesShown());  // a distance is told by them
        panel->setProfileShown(true);
        QVERIFY(d.rests());
        const double slope = std::sqrt(10101.0);
        const SectionField& field = view->field();
        QVERIFY(field.quantity == SectionQuantity::distance);
        for (const int row : {0, field.rows / 3, field.rows - 1})
            QVERIFY(std::abs(field.distances[static_cast<std::size_t>(row) * field.columns + 7] -
                             expected(field, 7, row) / slope) < 1e-5);
        const ChartSeries& curve = panel->profile()->chart()->chart().series.last();
        QCOMPARE(curve.name, QStringLiteral("distance"));
        QVERIFY(std::abs(curve.points.front().y() - -1 / slope) < 1e-9 &&
                std::abs(curve.points.back().y() - 1 / slope) < 1e-9);
        QTest::mouseMove(view, view->rect().center() + QPoint(-30, 10));
        QTRY_VERIFY(d->studies()->probe()->point() && d->studies()->probe()->upToDate());
        const ProbedPoint& point = *d->studies()->probe()->point();
        QVERIFY(std::abs(point.distance() - point.value / slope) < 1e-9);
        const QString told = QStringLiteral("distance %1").arg(QString::number(point.distance(), 'g', 5));
        QTRY_VERIFY2(d->probed()->text().endsWith(told), qPrintable(d->probed()->text()));
        QTRY_VERIFY2(view->accessibleDescription().contains(QString(told).replace("ce ", "ce = ")),
                     qPrintable(view->accessibleDescription()));
        // Of another quantity it is not the scale.
        panel->setQuantity(SectionQuantity::value);
        QVERIFY(d.rests());
        QVERIFY(field.distances.empty() && field.slopes.empty());
    }

    void theNumbersAreATable() {
        WindowDriver d;
        QVERIFY(shows(d, coordinates));
        d->study<SectionPanel>()->setQuantity(SectionQuantity::gradient);
        QVERIFY(d.rests());
        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("a.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(d->study<SectionPanel>()->table().toUtf8());
        file.close();
        const auto table = CsvTable::read(file.fileName().toStdString());
        QVERIFY(table);
        QCOMPARE(table->rowCount(), d->study<SectionPanel>()->view()->field().values.size());
        for (const std::size_t row : {std::size_t(0), table->rowCount() / 3, table->rowCount() - 1}) {
            const double x = table->number(row, "x", 9), y = table->number(row, "y", 9),
                         z = table->number(row, "z", 9);
            QVERIFY(std::abs(table->number(row, "value", 0) - (x + 10 * y + 100 * z)) < 1e-4);
            QVERIFY(std::abs(table->number(row, "gradient", 0) - std::sqrt(10101.0)) < 1e-4);
        }
    }

    void withoutASurfaceThereIsNoPlane() {
        WindowDriver d;
        WindowDriver::trigger(d->actions()->sectionPlane);
        d->study<SectionPanel>()->turn(10, 10);
        QVERIFY(shows(d, QStringLiteral("#version 3.7;\ncamera { location -3*z }\nsphere { 0, 1 }\n")));
        QVERIFY(!d->viewport()->planeHandle().movePixel(d->viewport()->projection()));
        QVERIFY(!d->study<SectionPanel>()->subject());
        d->study<SectionPanel>()->setProfileShown(true);
        QVERIFY(d->study<SectionPanel>()->profile()->samples().empty());
    }

    void smallContainersHaveFinePositions() {
        WindowDriver d;
        QString text = coordinates;
        QVERIFY(shows(d, text.replace(QStringLiteral("{ -1, 1 }"), QStringLiteral("{ -0.0001, 0.0001 }"))));
        d->study<SectionPanel>()->setPosition(0.0000125);
        QVERIFY(std::abs(d->study<SectionPanel>()->position() - 0.0000125) < 1e-8);
    }
};

QTEST_MAIN(SectionPanelTest)
#include "section_panel_test.moc"

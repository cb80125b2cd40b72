// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cstdlib>
#include <QAction>
#include <QElapsedTimer>
#include <QFile>
#include <QRandomGenerator>
#include <QSlider>
#include <QTest>

#include "app/desktop/window/actions.h"
#include "tests/app/window_driver.h"
#include "widgets/editor/scene_editor.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_slider.h"
#include "widgets/section/section_panel.h"
#include "widgets/viewport/viewport.h"

#if defined(__GLIBC__)
#include <malloc.h>
#include <unistd.h>
#endif

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// Seconds of random use; ISOSCOPE_SOAK_SECONDS asks for more (`make soak`: 60).
int soakSeconds() {
    const int asked = qEnvironmentVariableIntValue("ISOSCOPE_SOAK_SECONDS");
    return asked > 0 ? asked : 6;
}

quint32 soakSeed() {
    const int asked = qEnvironmentVariableIntValue("ISOSCOPE_SOAK_SEED");
    return asked > 0 ? static_cast<quint32>(asked) : QRandomGenerator::global()->generate() & 0x7fffffff;
}

/// What the process takes, in MB, without what it has freed; 0 where that is not told.
double memory() {
#if defined(__GLIBC__)
    malloc_trim(0);
    QFile pages(QStringLiteral("/proc/self/statm"));
    if (pages.open(QIODevice::ReadOnly))
        return pages.readAll().split(' ').value(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) /
               1e6;
#endif
    return 0;
}

}  // namespace

/// Edits, drags, resizes and quits at random: nothing may crash or hang.
class SoakTest : public QObject {
    Q_OBJECT

    std::unique_ptr<WindowDriver> driver_;
    QRandomGenerator random_;

    int upTo(int bound) { return static_cast<int>(random_.bounded(bound)); }

    void edit() {
        SceneEditor* editor = (*driver_)->editor();
        static const char* const pieces[] = {"0",
                                             "9",
                                             ".",
                                             "{",
                                             "}",
                                             "x",
                                             "-",
                                             "*",
                                             "(",
                                             ")",
                                             "sin(",
                                             "<",
                                             "#declare Q = 2;",
                                             "\n",
                                             "isosurface { function { y } }",
                                             "/*",
                                             "\"",
                                             "#while (1)",
                                             "#end",
                                             "e9"};
        const int length = static_cast<int>(editor->length());
        editor->SendScintilla(QsciScintilla::SCI_GOTOPOS, length > 0 ? upTo(length) : 0);
        if (upTo(4) == 0) {
            for (int i = upTo(20); i > 0; --i) editor->SendScintilla(QsciScintilla::SCI_DELETEBACK);
        } else {
            editor->setFocus();
            const QString piece = QString::fromLatin1(pieces[upTo(std::size(pieces))]);
            if (piece == QLatin1String("\n"))
                QTest::keyClick(editor->viewport(), Qt::Key_Return);
            else
                QTest::keyClicks(editor->viewport(), piece);
        }
    }

    void dragSlider() {
        ParameterPanel* panel = (*driver_)->parameters();
        if (panel->count() == 0) return;
        const int index = upTo(panel->count());
        if (panel->slider(index) && panel->slider(index)->isVisible() &&
            panel->slider(index)->findChild<QSlider*>())
            driver_->drag(index, upTo(160) - 80);
    }

    void step() {
        WindowDriver& d = *driver_;
        Actions* actions = d->actions();
        switch (upTo(14)) {
            case 0:
            case 1: edit(); break;
            case 2:
            case 3: dragSlider(); break;
            case 4:
                d.dragViewport({upTo(200) + 20, upTo(150) + 20}, {upTo(200) - 100, upTo(100) - 50});
                break;
            case 5: d.wheel(d->viewport(), {upTo(200), upTo(150)}, upTo(2) ? 120 : -120); break;
            case 6: d->resize(600 + upTo(900), 400 + upTo(600)); break;
            case 7: actions->undo->trigger(); break;
            case 8: actions->redo->trigger(); break;
            case 9: (upTo(2) ? actions->writeView : actions->resetView)->trigger(); break;
            case 10: d->study<SectionPanel>()->setAxis(upTo(3)); break;
            case 11: d->study<SectionPanel>()->setPosition(upTo(200) / 100.0 - 1); break;
            case 12: (upTo(2) ? actions->themeDark : actions->themeLight)->trigger(); break;
            default: (upTo(3) ? actions->stop : actions->redraw)->trigger();
        }
        QTest::qWait(upTo(40));
    }

  private slots:
    void randomUse() {
        const quint32 seed = soakSeed();
        random_.seed(seed);
        qInfo("seed %u (ISOSCOPE_SOAK_SEED), %d seconds", seed, soakSeconds());
        driver_ = std::make_unique<WindowDriver>();
        QElapsedTimer since;
        since.start();
        int steps = 0, rounds = 0;
        qint64 slowest = 0;
        std::vector<double> taken;  // once per minute
        while (!since.hasExpired(soakSeconds() * 1000)) {
            const qint64 before = since.elapsed();
            step();
            slowest = std::max(slowest, since.elapsed() - before);
            if (++steps % 60 != 0) continue;
            // The window is closed in the middle of everything, each later than the one before: what a
            // window gathers is seen.
            if (std::has_single_bit(static_cast<unsigned>(++rounds))) driver_->restart();
            (*driver_)->showTutorial();
            if (since.elapsed() < 60000 * static_cast<qint64>(taken.size() + 1)) continue;
            QVERIFY(driver_->rests(60000));
            taken.push_back(memory());
            qInfo("minute %zu, %d steps: %.1f MB", taken.size(), steps, taken.back());
        }
        qInfo("%d steps, the slowest took %lld ms", steps, slowest);
        QVERIFY(steps > 0);
        // Eight hours of use, at the pace of a person. The first minute fills what is kept on purpose.
        if (taken.size() >= 9) QVERIFY2(taken.back() - taken.front() < 20, "memory grows");
        // Still usable: a good text gives a picture.
        (*driver_)->showTutorial();
        QVERIFY(driver_->rests(60000));
        QVERIFY(distinctColors(driver_->picture()) > 100);
        driver_.reset();
    }
};

QTEST_MAIN(SoakTest)
#include "soak_test.moc"

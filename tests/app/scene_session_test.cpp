// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "widgets/document/scene_session.h"
#include "widgets/timing.h"

using namespace isoscope;

namespace {

const std::string sphere =
    "#declare R = 0.8;\nisosurface { function { x*x + y*y + z*z - R } contained_by { sphere { 0, 1.2 } } }\n";

}  // namespace

class SceneSessionTest : public QObject {
    Q_OBJECT

    struct Watched {
        SceneSession session;
        int scenes = 0, parses = 0;
        bool sameLook = false;
        SceneSession::Shown shown = SceneSession::Shown::nothing;
        quint64 revision = 0;
        Watched() {
            QObject::connect(&session, &SceneSession::sceneChanged, &session, [this](const auto&, bool same) {
                ++scenes;
                sameLook = same;
            });
            QObject::connect(&session, &SceneSession::parsed, &session, [this](const auto&, quint64 number) {
                ++parses;
                revision = number;
            });
            QObject::connect(&session, &SceneSession::shownChanged, &session,
                             [this](SceneSession::Shown now) { shown = now; });
        }
        void read(const std::string& text, quint64 number) {
            session.setText(text, number, SceneSession::When::now);
        }
    };

    static int slotOf(const ParseResult& result, const std::string& name) {
        for (const SceneParameter& parameter : result.scene->parameters)
            if (parameter.name == name) return parameter.slot;
        return -1;
    }

    /// Reads for many seconds unless it is stopped.
    static std::string endlessText() { return "#while (1) #declare A = 1; #end\n" + sphere; }

  private slots:
    void aTextThatTakesLongTellsHowFarItIsAndCanBeStopped() {
        Watched w;
        QSignalSpy slowly(&w.session, &SceneSession::readingSlowly);
        QSignalSpy ended(&w.session, &SceneSession::readingEnded);
        w.read(sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        QCOMPARE(slowly.size(), 0);
        const auto before = w.session.scene();
        QElapsedTimer since;
        since.start();
        w.read(endlessText(), 2);
        QTRY_VERIFY(slowly.size() >= 2);
        QVERIFY(since.elapsed() >= timing::progressDelay);
        QVERIFY(slowly.last()[0].toDouble() >= 0.5);
        QVERIFY(slowly.last()[1].toULongLong() > slowly.first()[1].toULongLong());
        QVERIFY(slowly.last()[2].toDouble() >= 0 && slowly.last()[2].toDouble() < 0.5);
        QCOMPARE(ended.size(), 0);
        since.restart();
        w.session.stop();
        QTRY_VERIFY(!w.session.busy());
        qInfo("stopped after %lld ms", since.elapsed());
        QCOMPARE(ended.size(), 1);
        QCOMPARE(w.revision, quint64(2));
        QVERIFY(!w.session.result()->ok());
        QCOMPARE(w.session.result()->diagnostics.back().id, std::string("stopped"));
        // What was shown before stays, and the next text is read as ever.
        QVERIFY(w.shown == SceneSession::Shown::older && w.session.scene() == before);
        w.read(sphere, 3);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::complete && w.session.result()->ok());
        // The stop was of the parse, not of what is read with its options later.
        QVERIFY(!w.session.result()->options.stop.stop_possible());
    }

    void aTextThatTakesLongGivesWayToANewerOne() {
        Watched w;
        w.read(endlessText(), 1);
        QTest::qWait(50);
        w.read(sphere, 2);
        QTRY_VERIFY_WITH_TIMEOUT(!w.session.busy(), 4000);
        QCOMPARE(w.parses, 1);
        QCOMPARE(w.revision, quint64(2));
        QVERIFY(w.shown == SceneSession::Shown::complete);
    }

    void aClosedSessionDoesNotWaitForItsText() {
        QElapsedTimer since;
        {
            Watched w;
            w.read(endlessText(), 1);
            QTest::qWait(50);
            since.start();
        }
        // Without a stop it is the seconds that the budget of steps lasts.
        qInfo("closed after %lld ms", since.elapsed());
    }

    void textBecomesAScene() {
        Watched w;
        w.read(sphere, 1);
        QVERIFY(w.session.busy());
        QTRY_VERIFY(!w.session.busy());
        QCOMPARE(w.session.scene()->isosurfaces.size(), std::size_t(1));
        QCOMPARE(w.revision, quint64(1));
        QVERIFY(w.shown == SceneSession::Shown::complete);
        QVERIFY(!w.sameLook);
    }

    void typingIsReadAfterAPauseAndOnlyOnce() {
        Watched w;
        for (int i = 1; i <= 20; ++i)
            w.session.setText(sphere + std::string(i, ' '), i, SceneSession::When::afterPause);
        QCOMPARE(w.parses, 0);
        QTRY_COMPARE(w.revision, quint64(20));
        QCOMPARE(w.parses, 1);
    }

    void lastGoodSceneStaysWhileTheTextHasErrors() {
        Watched w;
        w.read(sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        const auto good = w.session.scene();
        w.read(sphere + "isosurface { function { x + } }", 2);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::older);
        QCOMPARE(w.session.scene(), good);
        QVERIFY(!w.session.result()->ok());
        w.read(sphere, 3);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::complete);
        QVERIFY(w.session.scene() != good);
    }

    void newDocumentWithErrorsShowsWhatWasUnderstood() {
        Watched w;
        w.session.begin({});
        w.read(sphere + "sphere { 0, }", 1);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::partial);
        QVERIFY(w.session.scene());
        QCOMPARE(w.session.scene()->isosurfaces.size(), std::size_t(1));
    }

    /// A bug once: a scene that never was without errors stood still, whatever was typed.
    void aTextThatNeverWasGoodKeepsFollowing() {
        Watched w;
        w.session.begin({});
        w.read("sphere { 0, }" + sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        w.read("sphere { 0, }" + sphere + sphere, 2);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::partial);
        QCOMPARE(w.session.scene()->isosurfaces.size(), std::size_t(2));
        w.read("} }", 3);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::older);
    }

    /// A bug once: a kept text with an error, put into an empty document, showed the black picture of the
    /// empty text instead of its surfaces.
    void theSceneOfAnEmptyTextIsNotHeldOnTo() {
        Watched w;
        w.read("", 1);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::complete);
        w.read(sphere + "sphere { 0, ", 2);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::partial);
        QCOMPARE(w.session.scene()->isosurfaces.size(), std::size_t(1));
    }

    void aTextOfNothingButErrorsShowsNothing() {
        Watched w;
        w.session.begin({});
        w.read("} } }", 1);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(w.shown == SceneSession::Shown::nothing);
        QVERIFY(!w.session.scene());
    }

    void parameterMovesWithoutAParse() {
        Watched w;
        w.read(sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        const auto owner = w.session.result();
        const int slot = slotOf(*owner, "R");
        QVERIFY(slot >= 0);
        const auto before = w.session.scene();
        QVERIFY(w.session.setParameter(owner.get(), slot, 0.5));
        QCOMPARE(w.parses, 1);
        QCOMPARE(w.scenes, 2);
        QCOMPARE((*w.session.scene()->parameterTable)[slot], 0.5);
        QCOMPARE((*before->parameterTable)[slot], 0.8);  // scenes never change
        QCOMPARE(w.session.scene()->isosurfaces[0].shape, before->isosurfaces[0].shape);
    }

    void parseAfterADragLooksTheSame() {
        Watched w;
        w.read(sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        const auto owner = w.session.result();
        const int slot = slotOf(*owner, "R");
        QVERIFY(w.session.setParameter(owner.get(), slot, 0.5));
        std::string moved = sphere;
        moved.replace(moved.find("0.8"), 3, "0.5");
        w.session.followParameter(moved, 2);
        QTRY_VERIFY(!w.session.busy());
        QCOMPARE(w.revision, quint64(2));
        QVERIFY(w.sameLook);
        QCOMPARE((*w.session.scene()->parameterTable)[slotOf(*w.session.result(), "R")], 0.5);
    }

    void olderParseDoesNotBringBackASlider() {
        // A text that takes a while, so that the slider moves on before its parse is back.
        const std::string slow = "#declare I = 0; #while (I < 60000) #declare I = I + 1; #end\n" + sphere;
        Watched w;
        w.read(slow, 1);
        QTRY_VERIFY_WITH_TIMEOUT(!w.session.busy(), 20000);
        const auto owner = w.session.result();
        const int slot = slotOf(*owner, "R");
        const auto value = [&] { return (*w.session.scene()->parameterTable)[slot]; };
        const auto text = [&](const char* number) {
            std::string moved = slow;
            return moved.replace(moved.find("0.8"), 3, number);
        };
        QVERIFY(w.session.setParameter(owner.get(), slot, 0.5));
        w.session.followParameter(text("0.5"), 2);
        QTest::qWait(timing::typingPause + 20);  // its parse runs now, or has just ended
        const bool running = w.parses == 1;
        QVERIFY(w.session.setParameter(running ? owner.get() : w.session.result().get(), slot, 0.7));
        w.session.followParameter(text("0.7"), 3);
        while (w.session.busy()) {
            QCOMPARE(value(), 0.7);
            QTest::qWait(1);
        }
        QCOMPARE(value(), 0.7);
        QCOMPARE(w.revision, quint64(3));
    }

    void slidersOfAnotherResultAreRefused() {
        Watched w;
        w.read(sphere, 1);
        QTRY_VERIFY(!w.session.busy());
        const auto old = w.session.result();
        w.read("#declare A = 1;\n" + sphere, 2);
        QTRY_VERIFY(!w.session.busy());
        QVERIFY(!w.session.setParameter(old.get(), slotOf(*old, "R"), 0.5));
        QVERIFY(!w.session.setParameter(w.session.result().get(), 1000, 0.5));
        QVERIFY(!w.session.setParameter(w.session.result().get(), -1, 0.5));
        QVERIFY(!w.session.setParameter(nullptr, 0, 0.5));
    }

    void resultsOfTheLastDocumentAreDropped() {
        Watched w;
        w.read(sphere, 1);
        w.session.begin({});
        w.read("background { rgb 1 }", 2);
        QTRY_VERIFY(!w.session.busy());
        QCOMPARE(w.revision, quint64(2));
        QTest::qWait(50);
        QCOMPARE(w.parses, 1);
        QVERIFY(w.session.scene()->isosurfaces.empty());
    }

    void endsWhileParsing() {
        auto session = std::make_unique<SceneSession>();
        for (int i = 0; i < 5; ++i) session->setText(sphere, i, SceneSession::When::now);
        session.reset();
        QCoreApplication::processEvents();
    }
};

QTEST_GUILESS_MAIN(SceneSessionTest)
#include "scene_session_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/certified/march_lanes.h"

#include <cmath>
#include <QTest>

#include "tests/support/instruction_sets.h"

using namespace isoscope;
using namespace isoscope::test;

namespace {

/// One step of a lane outside, at t = 1, whose piece is a 32nd of the resolution long.
struct ShortStep {
    RayPieces pieces;
    MarchLanes lanes{};
    std::array<MarchEvent, batchLanes> events{};
    static constexpr double resolution = 1e-3, length = resolution / 32;

    ShortStep(double center, double slope, double error) {
        pieces.start.fill(1);
        pieces.length.fill(length);
        lanes.far.fill(2);
        lanes.resolution.fill(resolution);
        lanes.tolerance.fill(2 * resolution);
        lanes.sign.fill(1);
        lanes.signPlace.fill(1);
        lanes.watched.fill(MarchLanes::noSign);
        lanes.budget.fill(100);
        std::array<double, batchLanes> a, b, e;
        a.fill(center);
        b.fill(slope);
        e.fill(error);
        march(pieces, lanes, {a.data(), b.data(), e.data()}, {}, batchLanes, events.data());
    }
};

}  // namespace

class MarchLanesTest : public QObject {
    Q_OBJECT

  private slots:
    void aPieceShorterThanTheResolutionKeepsItsLength_data() {
        QTest::addColumn<qint64>("target");
        for (const auto& [target, name] : instructionSets()) QTest::newRow(name) << qint64(target);
    }

    /// Pieces by cases are as short as a 64th of the resolution. They became as long as that: behind a
    /// crossing, or where there is no value, what lies behind the piece was passed over, and its sign taken
    /// for known. Found by following proofs, graph 6629 of `roots_proof_chain` with
    /// ISOSCOPE_PROOF_CHAINS=1e5.
    void aPieceShorterThanTheResolutionKeepsItsLength() {
        QFETCH(qint64, target);
        const ForcedInstructionSet forced(target);
        const ShortStep crossing(0, -1, 1e-12);
        const ShortStep undefined(0, 0, -INFINITY);
        const ShortStep unresolved(1, 0, INFINITY);
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            QCOMPARE(crossing.events[lane], MarchEvent::crossing);
            QCOMPARE(crossing.pieces.start[lane], 1.0);
            QCOMPARE(crossing.pieces.length[lane], ShortStep::length);
            QCOMPARE(undefined.events[lane], MarchEvent::undefined);
            QCOMPARE(undefined.pieces.length[lane], ShortStep::length);
            // Nothing is known of it: what is passed over may as well be the resolution.
            QCOMPARE(unresolved.events[lane], MarchEvent::unresolved);
            QCOMPARE(unresolved.pieces.length[lane], ShortStep::resolution);
        }
    }

    void errorsShortenPiecesByHowLargeTheyAre_data() { aPieceShorterThanTheResolutionKeepsItsLength_data(); }

    /// Where the error is more than sixteen times the value, half the piece would hardly tell the sign.
    void errorsShortenPiecesByHowLargeTheyAre() {
        QFETCH(qint64, target);
        const ForcedInstructionSet forced(target);
        for (const double value : {0.01, 2.0}) {
            const double usual = lengthBehind(value, 15.5 * value), wild = lengthBehind(value, 16.5 * value);
            QVERIFY(usual < 0.5 && wild < 0.5 * usual);
            QCOMPARE(lengthBehind(value, 1.5 * value), usual);
        }
    }

  private:
    /// How long a piece of length 1 becomes whose sign is open at its start, given the center and the error
    /// of its form.
    static double lengthBehind(double center, double error) {
        RayPieces pieces;
        MarchLanes lanes{};
        std::array<MarchEvent, batchLanes> events{};
        pieces.length.fill(1);
        lanes.far.fill(2);
        lanes.resolution.fill(1e-3);
        lanes.tolerance.fill(2e-3);
        lanes.sign.fill(1);
        lanes.watched.fill(MarchLanes::noSign);
        lanes.budget.fill(100);
        std::array<double, batchLanes> a, b{}, e;
        a.fill(center);
        e.fill(error);
        march(pieces, lanes, {a.data(), b.data(), e.data()}, {}, batchLanes, events.data());
        return pieces.length[0];
    }
};

QTEST_APPLESS_MAIN(MarchLanesTest)
#include "march_lanes_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/roots/cells/choice_pieces.h"

#include <QTest>

#include "core/evaluate/prepared_function.h"
#include "tests/support/tape_of.h"

using namespace isoscope;
using test::tapeOf;

namespace {

/// Choices that are decided for x from -1 to 1, and some that are not.
std::shared_ptr<const PreparedFunction> withChoices(int decided, int open) {
    return PreparedFunction::of(tapeOf([&](auto x, auto y, auto z) {
                                    Expression sum = y + z;
                                    for (int k = 0; k < decided; ++k) sum = sum + max(x, 3.0 + k);
                                    for (int k = 0; k < open; ++k) sum = sum + max(x, 0.01 * k);
                                    return sum;
                                }),
                                {});
}

/// Whether most choices are decided along lines from x = -1 to 1, cut into so many pieces of the same place.
bool mostDecided(int decided, int open, std::size_t pieces) {
    const auto function = withChoices(decided, open);
    const RootSettings settings;
    AffineEvaluator forms(function);
    ChoicePieces choices(*function, settings, forms);
    const std::vector<LineQuery> lines(2, {{-1, 0, 0}, {1, 0, 0}, 0, 2});
    const std::vector<std::uint8_t> wanted(lines.size(), 1);
    const auto bundle = LineBundle::around(lines, wanted);
    for (std::size_t lane = 0; lane < pieces; ++lane) choices.place(*bundle, {0, 2}, lane);
    choices.enclose(pieces);
    return choices.mostDecided(pieces);
}

}  // namespace

class ChoicePiecesTest : public QObject {
    Q_OBJECT

  private slots:
    void mostAreMoreThanHalf() {
        for (const std::size_t pieces : {1, 2, 8}) {
            QVERIFY(mostDecided(6, 4, pieces));
            QVERIFY(!mostDecided(5, 5, pieces));
            QVERIFY(!mostDecided(2, 8, pieces));
        }
    }
};

QTEST_APPLESS_MAIN(ChoicePiecesTest)
#include "choice_pieces_test.moc"

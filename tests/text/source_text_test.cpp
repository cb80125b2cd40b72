// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/source_text.h"

#include <QTest>

using namespace isoscope;

class SourceTextTest : public QObject {
    Q_OBJECT

  private slots:
    void countsLinesAndColumnsFromOne() {
        const SourceText text("scene.pov", "ab\n\ncd");
        QCOMPARE(text.position(0).line, 1);
        QCOMPARE(text.position(1).column, 2);
        QCOMPARE(text.position(3).line, 2);
        QCOMPARE(text.position(5).line, 3);
        QCOMPARE(text.position(5).column, 2);
        QCOMPARE(text.position(999).column, 3);
    }

    void slicesOnlyWhatIsThere() {
        SourceLibrary library;
        library.add("a", "hello");
        QCOMPARE(library.slice({0, 1, 3}), std::string_view("el"));
        QCOMPARE(library.slice({0, 3, 9}), std::string_view());
        QCOMPARE(library.slice({7, 0, 1}), std::string_view());
    }
};

QTEST_APPLESS_MAIN(SourceTextTest)
#include "source_text_test.moc"

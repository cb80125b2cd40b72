// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/editor/scene_scanner.h"

#include <QRandomGenerator>
#include <QTest>

using namespace isoscope;

namespace {

/// One letter per byte: . plain, c comment, s string, n number, d directive, k keyword, f function, + symbol.
QByteArray styles(const std::string& text, int depth = 0) {
    QByteArray result;
    for (SceneScanner scanner(text, depth); !scanner.atEnd();) {
        const SceneScanner::Piece piece = scanner.next();
        result += QByteArray(piece.length, ".csndkf+"[static_cast<int>(piece.style)]);
    }
    return result;
}

}  // namespace

class SceneScannerTest : public QObject {
    Q_OBJECT

  private slots:
    void colours_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* name, const char* text, const char* expected) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(expected);
        };
        row("statement", "isosurface { R }", "kkkkkkkkkk.+...+");
        row("call", "f_torus(x, 0.8)", "fffffff+k+.nnn+");
        row("language function", "sin(y)", "fff+k+");
        row("directive", "#declare R=1;", "dddddddd..+n+");
        row("directive with blanks", "#  if (1)", "ddddd.+n+");
        row("no directive", "#foo", "+...");
        row("line comment", "x // 1 y\nz", "k.cccccc.k");
        row("nested comments", "/* a /* b */ c */x", "ccccccccccccccccck");
        row("open comment", "/* a\nb", "cccccc");
        row("string", "\"a\\\"b\" 1", "ssssss.n");
        row("open string ends with its line", "\"ab\n1", "sss.n");
        row("comment inside string", "\"/*\" 1", "ssss.n");
        row("numbers", "1 .5 1.5e-3 2.", "n.nn.nnnnnn.nn");
        row("digits of names", "P0 atan2", "...fffff");
        row("not an exponent", "2*e", "n+.");
        row("member", "w.x", ".+k");
        row("wide characters", "\xe6\xbc\xa2 1", "....n");
    }
    void colours() {
        QFETCH(QByteArray, text);
        QTEST(styles(text.toStdString()), "expected");
    }

    void continuesInsideAComment() {
        QCOMPARE(styles("a */ b", 1), QByteArray("cccc.."));
        QCOMPARE(styles("a */ b */x", 2), QByteArray("ccccccccck"));
    }

    /// Scanning line by line, with the depth carried over, gives what scanning in one piece gives, and every
    /// byte a style.
    void linesAgreeWithTheWhole() {
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random(seed);
        const QByteArrayList parts{"/*", "*/",  "//", "\"",   "\\",
                                   "\n", "#if", " ",  "1.5",  ".",
                                   "e",  "box", "{",  "\xff", QByteArray(1, '\0')};
        for (int round = 0; round < 500; ++round) {
            std::string text;
            for (int i = 0; i < 40; ++i)
                text += parts[random.bounded(static_cast<int>(parts.size()))].toStdString();
            const QByteArray whole = styles(text);
            QCOMPARE(whole.size(), static_cast<qsizetype>(text.size()));
            QByteArray lines;
            int depth = 0;
            for (std::size_t begin = 0; begin < text.size();) {
                const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
                const std::string line = text.substr(begin, end - begin);
                lines += styles(line, depth);
                SceneScanner scanner(line, depth);
                while (!scanner.atEnd()) scanner.next();
                depth = scanner.depth();
                begin = end;
            }
            QVERIFY2(lines == whole, qPrintable(QString("seed %1").arg(seed)));
        }
    }
};

QTEST_APPLESS_MAIN(SceneScannerTest)
#include "scene_scanner_test.moc"

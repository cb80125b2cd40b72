// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/section/font_file.h"

#include <QApplication>
#include <QFile>
#include <QRawFont>
#include <QTest>

using namespace isoscope;

class FontFileTest : public QObject {
    Q_OBJECT

  private slots:
    /// Panels drawn by VTK name eps and the like; VTK's own fonts have no Greek.
    void theApplicationsFontHasAFile() {
        const QString path = fontFile(QApplication::font().family());
        QVERIFY2(QFile::exists(path), qPrintable(path));
        const QRawFont font(path, 12);
        QVERIFY(font.isValid());
        QVERIFY(font.supportsCharacter(QChar(0x03b5)));
    }

    /// A bug once: only one file of one distribution was tried.
    void anUnknownFamilyGetsAnotherFont() {
        QVERIFY(QFile::exists(fontFile(QStringLiteral("No Such Family"))));
        QVERIFY(QFile::exists(fontFile({})));
    }
};

QTEST_MAIN(FontFileTest)
#include "font_file_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes/solids/font_file.h"

#include <algorithm>
#include <glm/common.hpp>
#include <QTest>

#include "core/language/directives/library_paths.h"

using namespace isoscope;

class FontFileTest : public QObject {
    Q_OBJECT

  private slots:
    /// The letter u of this font has a control point one unit to the left of where the font says that it
    /// begins: POV-Ray moves it there. Its extents of "iu" are 0.641018, of "ui" 0.657018.
    void outlinesBeginWhereTheFontSays() {
        std::unique_ptr<FontFile> font;
        for (const std::filesystem::path& folder : installedLibraryPaths())
            if (std::filesystem::exists(folder / "cyrvetic.ttf"))
                font = FontFile::open(folder / "cyrvetic.ttf");
        if (!font) QSKIP("cyrvetic.ttf, which comes with POV-Ray, is not installed");
        const auto rightEnd = [&](char32_t letter) {
            double most = 0;
            for (const CurvePiece& piece : font->glyph(letter).outline)
                most = std::max({most, piece.at(0).x, piece.at(1).x});
            return most;
        };
        QVERIFY(std::abs(font->glyph(U'u').bearing - 0.045) < 1e-12);
        QVERIFY(std::abs(rightEnd(U'u') - 0.481) < 1e-12);
        QVERIFY(std::abs(font->glyph(U'i').advance - font->glyph(U'i').bearing + rightEnd(U'u') - 0.641) <
                1e-12);
        QVERIFY(std::abs(font->glyph(U'u').advance - font->glyph(U'u').bearing + rightEnd(U'i') - 0.657) <
                1e-12);
    }
};

QTEST_APPLESS_MAIN(FontFileTest)
#include "font_file_test.moc"
